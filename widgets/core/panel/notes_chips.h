// The notes of an answer as counted chips: warnings, facts. A click opens them all.
#pragma once

#include <QFrame>
#include <QToolButton>
#include <QWidget>

#include "engine/core/error.h"

namespace lathelier {

class WrappingLabel;

/// Notes in display order: warnings before facts, notes on the answer before notes on the data; a note common to
/// several files is merged. Files without folders, which are in the tooltips of the inputs and in the report.
Notes arranged(const Notes& notes);

class NotesChips : public QWidget {
    Q_OBJECT
public:
    explicit NotesChips(QWidget* parent = nullptr);
    void setNotes(const Notes& notes);

protected:
    void changeEvent(QEvent* event) override;

private:
    void refresh();
    void open();

    QToolButton* warnings_;
    QToolButton* facts_;
    QFrame* popup_;
    WrappingLabel* text_;
    Notes notes_;
};

}  // namespace lathelier
