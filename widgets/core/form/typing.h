// Pending input of fields and editors that report after a pause.
#pragma once

class QWidget;

namespace lathelier {

/// A widget that reports typed input after a pause.
class TypingEditor {
public:
    /// Reports pending input now.
    virtual void takeOver() = 0;

protected:
    ~TypingEditor() = default;
};

/// Commits pending input anywhere in `window`: before saving, closing, reporting, exporting.
void takeOverTyping(const QWidget* window);

}  // namespace lathelier
