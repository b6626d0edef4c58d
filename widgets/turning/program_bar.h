// What the program that stands here is worth: planned, compensated or changed by hand; checked or not; and what can be
// done with it.
#pragma once

#include <QLabel>
#include <QToolButton>
#include <QWidget>

#include "widgets/turning/turning_picture.h"

namespace lathelier::turning_panel {

class ProgramBar : public QWidget {
    Q_OBJECT

public:
    explicit ProgramBar(QWidget* parent = nullptr);

    void setPicture(const TurningPicture& picture, std::size_t setup);
    QString state() const { return state_->text(); }
    QToolButton* check() const { return check_; }
    QToolButton* takeBack() const { return take_back_; }
    QToolButton* use() const { return use_; }
    void retranslate();

signals:
    void checkWanted();     ///< of the text that stands here
    void takeBackWanted();  ///< the changes by hand
    void useWanted();       ///< in the panels Deflection, Correction and Program

private:
    QLabel* state_;
    QToolButton* check_;
    QToolButton* take_back_;
    QToolButton* use_;
};

}  // namespace lathelier::turning_panel
