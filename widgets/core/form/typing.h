// What is being typed, and not announced yet, in fields and editors that wait for a pause.
#pragma once

class QWidget;

namespace lathelier {

/// A widget that announces what is typed after a pause.
class TypingEditor {
public:
    /// Announces it now.
    virtual void takeOver() = 0;

protected:
    ~TypingEditor() = default;
};

/// Takes over what is being typed anywhere in `window`: before saving, closing, reporting, exporting.
void takeOverTyping(const QWidget* window);

}  // namespace lathelier
