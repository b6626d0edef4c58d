// A field for one number in the user's locale.
#pragma once

#include <QLineEdit>
#include <QTimer>
#include <optional>
#include <vector>

#include "widgets/core/form/typing.h"

namespace lathelier {

/// Takes a number with point or comma; may be empty when it is optional. Up, Down and the wheel (when focused) step by
/// a readable amount for its size. What is outside the range is marked with a symbol and said in the tooltip, and is
/// not announced. Typing is announced after a short pause, Enter and leaving the field at once.
class NumberEdit : public QLineEdit, public TypingEditor {
    Q_OBJECT
public:
    NumberEdit(double minimum, double maximum, QWidget* parent = nullptr);

    void setInteger(bool integer) { integer_ = integer; }
    void setOptional(const QString& placeholder);      ///< may be empty; says what empty means
    void setUsual(const std::vector<double>& values);  ///< offered in a menu, with "not given" when it is optional
    void setHelp(const QString& help);                 ///< the tooltip while the number is sound
    void setFactor(double factor);                     ///< what is shown and typed = number() × factor

    std::optional<double> number() const { return number_; }  ///< the last sound one
    void setNumber(std::optional<double> number);             ///< shows it, announces nothing
    bool isSound() const { return sound_; }
    void takeOver() override { announce(); }  ///< what is typed counts now, not after the pause

signals:
    void numberChanged();  ///< by the user; number() is sound
    void finished();       ///< Enter or focus lost: the gesture is over

protected:
    bool event(QEvent* event) override;  ///< Undo and Redo are the program's, except while something is being typed
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
    double factor_ = 1;  ///< of what is shown
    bool integer_ = false;
    bool optional_ = false;
    bool sound_ = true;
    bool pending_ = false;  ///< typed, not yet announced
    std::optional<double> number_;
    QString help_;
    QAction* warning_;
    QAction* offer_ = nullptr;
    std::vector<double> usual_;
    QTimer pause_;
};

}  // namespace lathelier
