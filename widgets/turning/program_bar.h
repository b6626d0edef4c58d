// Status of the shown program (planned, compensated or edited by hand; checked or not) and its commands.
#pragma once

#include <QLabel>
#include <QToolButton>
#include <QWidget>

#include "engine/cam/drawn/drawn_plan.h"

namespace lathelier::turning_panel {

class ProgramBar : public QWidget {
    Q_OBJECT

public:
    explicit ProgramBar(QWidget* parent = nullptr);

    void setOutcome(const cam::TurningOutcome& outcome, std::size_t setup);
    QString state() const { return state_->text(); }
    QToolButton* check() const { return check_; }
    QToolButton* takeBack() const { return takeBack_; }
    QToolButton* use() const { return use_; }
    void retranslate();

signals:
    void checkRequested();     ///< request to check the shown text
    void takeBackRequested();  ///< request to discard the edits
    void useRequested();       ///< request to use the program in the panels Deflection, Correction and Program

private:
    QLabel* state_;
    QToolButton* check_;
    QToolButton* takeBack_;
    QToolButton* use_;
};

}  // namespace lathelier::turning_panel
