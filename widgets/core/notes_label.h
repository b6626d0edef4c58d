// The notes under a headline: what matters most first, the rest folded away.
#pragma once

#include <QToolButton>
#include <QWidget>

#include "engine/core/error.h"

namespace lathelier {

class WrappingLabel;

/// As they are shown: warnings before facts, what concerns the answer before where the data come from; a note that
/// several files share is said once, with all their names. Files by their names: the folders stand in the tooltips of
/// the inputs and in the report.
Notes arranged(const Notes& notes);

/// The first notes are always seen, the rest unfolds.
class NotesLabel : public QWidget {
    Q_OBJECT
public:
    explicit NotesLabel(QWidget* parent = nullptr);
    void setNotes(const Notes& notes);
    void setPresenting(bool presenting);  ///< fewer are seen, to leave room for the views
    void setRoom(int height_px);          ///< of the panel: in a low one, only warnings stay unfolded

protected:
    void changeEvent(QEvent* event) override;

private:
    void refresh();

    WrappingLabel* text_;
    QToolButton* fold_;
    Notes notes_;
    bool presenting_ = false;
    bool low_ = false;
};

}  // namespace lathelier
