#include "widgets/core/form/number_edit.h"

#include <QAction>
#include <QEvent>
#include <QKeyEvent>
#include <QLocale>
#include <QMenu>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "widgets/core/icons.h"

namespace lathelier {
namespace {

constexpr int typingPause_ms = 350;

/// Text of a number for editing: a converted number is rounded to meaningful digits.
QString localText(double number, double factor)
{
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return locale.toString(number * factor, 'g', factor == 1 ? 12 : 7);
}

/// The typed number, rounded to remove conversion noise.
double fromShown(double shown, double factor)
{
    if (factor == 1 || shown == 0) return shown;
    const double number = shown / factor;
    const double digit = std::pow(10, 12 - std::ceil(std::log10(std::abs(number))));
    return std::round(number * digit) / digit;
}

/// Step size for `number`: 0.05 and 0.1 by 0.01, 3 by 1; at most a hundredth of the range.
double stepOf(double number, double range, bool integer)
{
    const double size = number == 0 ? 0.1 : std::pow(10, std::floor(std::log10(std::abs(number) / 2) + 1e-9));
    const double step = std::min(size, range / 100);
    return integer ? std::max(1.0, std::round(step)) : step;
}

}  // namespace

NumberEdit::NumberEdit(double minimum, double maximum, QWidget* parent)
    : QLineEdit(parent), minimum_(minimum), maximum_(maximum)
{
    warning_ = addAction(icon("warning"), QLineEdit::TrailingPosition);
    warning_->setVisible(false);
    pause_.setSingleShot(true);
    pause_.setInterval(typingPause_ms);
    connect(&pause_, &QTimer::timeout, this, &NumberEdit::announce);
    connect(this, &QLineEdit::textEdited, this, &NumberEdit::typed);
    connect(this, &QLineEdit::editingFinished, this, &NumberEdit::finish);
}

void NumberEdit::setOptional(const QString& placeholder)
{
    optional_ = true;
    setPlaceholderText(placeholder);
    setClearButtonEnabled(true);
}

void NumberEdit::setUsual(const std::vector<double>& values)
{
    usual_ = values;
    if (usual_.empty() || offer_) return;
    offer_ = addAction(icon("choose"), QLineEdit::TrailingPosition);
    offer_->setObjectName("usualValues");
    connect(offer_, &QAction::triggered, this, &NumberEdit::offer);
    offer_->setToolTip(tr("Usual values"));
}

void NumberEdit::offer()
{
    QMenu menu(this);
    const auto add = [&](const QString& text, std::optional<double> number) {
        QAction* action = menu.addAction(text, this, [this, number] { take(number); });
        action->setCheckable(true);
        action->setChecked(number == number_);
    };
    if (optional_) add(placeholderText(), std::nullopt);
    for (const double value : usual_) add(localText(value, factor_), value);
    menu.exec(mapToGlobal(rect().bottomLeft()));
}

/// Sets a number immediately, as one gesture.
void NumberEdit::take(std::optional<double> number)
{
    pause_.stop();
    pending_ = false;
    const bool changed = number != number_;
    number_ = number;
    showNumber();
    if (changed) emit numberChanged();
    emit finished();
}

void NumberEdit::setHelp(const QString& help)
{
    help_ = help;
    mark(sound_);
}

void NumberEdit::setFactor(double factor)
{
    if (factor == factor_) return;
    announce();
    factor_ = factor;
    showNumber();
}

void NumberEdit::setNumber(std::optional<double> number)
{
    if (pending_) return;  // the user is typing: the typed value has precedence
    if (sound_ && number && number == number_ && !text().isEmpty()) return;  // keep "0.050" as it was typed
    number_ = number;
    showNumber();
}

void NumberEdit::showNumber()
{
    setText(number_ ? localText(*number_, factor_) : QString());
    mark(true);
}

bool NumberEdit::accepts(const QString& text, std::optional<double>& number) const
{
    const QString trimmed = text.trimmed();
    if (trimmed.isEmpty()) {
        number.reset();
        return optional_;
    }
    // Both decimal marks are accepted in any locale, since group separators are not typed here.
    QString plain = trimmed;
    plain.replace(',', '.').replace(QChar(0x2212), '-');
    bool understood = false;
    const double value = fromShown(QLocale::c().toDouble(plain, &understood), factor_);
    number = value;
    return understood && std::isfinite(value) && value >= minimum_ && value <= maximum_ &&
           (!integer_ || value == std::floor(value));
}

void NumberEdit::typed()
{
    std::optional<double> number;
    const bool sound = accepts(text(), number);
    mark(sound);
    pending_ = sound && number != number_;
    if (pending_)
        pause_.start();
    else
        pause_.stop();
}

void NumberEdit::announce()
{
    pause_.stop();
    if (!pending_) return;
    pending_ = false;
    std::optional<double> number;
    if (!accepts(text(), number) || number == number_) return;
    number_ = number;
    emit numberChanged();
}

void NumberEdit::finish()
{
    announce();
    if (!sound_ && !hasFocus()) showNumber();  // on leaving the field the last valid number is shown
    emit finished();
}

void NumberEdit::step(int steps)
{
    announce();
    const double from = number_.value_or(std::clamp(0.0, minimum_, maximum_)) * factor_;
    const double size = stepOf(from, (maximum_ - minimum_) * factor_, integer_);
    const double to = std::clamp(fromShown(std::round(from / size) * size + steps * size, factor_), minimum_, maximum_);
    if (number_ && to == *number_) return;
    number_ = to;
    showNumber();
    emit numberChanged();
}

void NumberEdit::mark(bool sound)
{
    sound_ = sound;
    warning_->setVisible(!sound);
    const QString problem =
        integer_ ? tr("Expected a whole number from %1 to %2.") : tr("Expected a number from %1 to %2.");
    const QString text = sound ? help_ : problem.arg(localText(minimum_, factor_), localText(maximum_, factor_));
    setToolTip(text);
    setAccessibleDescription(text);
    warning_->setToolTip(text);
}

bool NumberEdit::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride && !pending_ && sound_) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
            event->ignore();
            return true;
        }
    }
    return QLineEdit::event(event);
}

void NumberEdit::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Up || event->key() == Qt::Key_Down) {
        step(event->key() == Qt::Key_Up ? 1 : -1);
        return;
    }
    QLineEdit::keyPressEvent(event);
}

void NumberEdit::wheelEvent(QWheelEvent* event)
{
    if (!hasFocus()) {
        event->ignore();  // scroll the column instead
        return;
    }
    step(event->angleDelta().y() > 0 ? 1 : -1);
    event->accept();
}

void NumberEdit::changeEvent(QEvent* event)
{
    QLineEdit::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        if (offer_) offer_->setToolTip(tr("Usual values"));
        if (sound_ && !pending_)
            showNumber();
        else
            mark(sound_);
    }
}

}  // namespace lathelier
