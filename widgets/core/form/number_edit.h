// A field for one number in the user's locale.
#pragma once

#include <QLineEdit>
#include <QTimer>
#include <optional>
#include <vector>

#include "widgets/core/form/typing.h"

namespace lathelier {

/// Accepts a number with point or comma; may be empty when optional. Up, Down and the wheel (with focus) step by an
/// amount adapted to its magnitude. A value outside the range is marked with a symbol and a tooltip, and is not
/// reported. Typing is reported after a short pause, Enter and leaving the field immediately.
class NumberEdit : public QLineEdit, public TypingEditor {
    Q_OBJECT
public:
    NumberEdit(double minimum, double maximum, QWidget* parent = nullptr);

    void setInteger(bool integer) { integer_ = integer; }
    void setOptional(const QString& placeholder);      ///< allows an empty field; `placeholder` explains it
    void setUsual(const std::vector<double>& values);  ///< offered in a menu, with "not given" when it is optional
    void setHelp(const QString& help);                 ///< the tooltip while the number is sound
    void setFactor(double factor);                     ///< shown and typed value = number() × factor

    std::optional<double> number() const { return number_; }  ///< last valid number
    void setNumber(std::optional<double> number);             ///< sets the number without a signal
    bool isSound() const { return sound_; }
    void takeOver() override { announce(); }  ///< reports typed input now, without the pause

signals:
    void numberChanged();  ///< changed by the user; number() is valid
    void finished();       ///< Enter or focus lost: end of the gesture

protected:
    bool event(QEvent* event) override;  ///< Undo and Redo go to the program except while typing
    void keyPressEvent(QKeyEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void typed();
    void announce();
    void finish();
    void step(int steps);
    void take(std::optional<double> number);
    void offer();
    void showNumber();
    void mark(bool sound);
    bool accepts(const QString& text, std::optional<double>& number) const;

    double minimum_;
    double maximum_;
    double factor_ = 1;  ///< display factor
    bool integer_ = false;
    bool optional_ = false;
    bool sound_ = true;
    bool pending_ = false;  ///< typed, not yet reported
    std::optional<double> number_;
    QString help_;
    QAction* warning_;
    QAction* offer_ = nullptr;
    std::vector<double> usual_;
    QTimer pause_;
};

}  // namespace lathelier
