#include "widgets/speed/operator_keys.h"

#include <QGridLayout>
#include <QKeyEvent>
#include <QLocale>
#include <algorithm>

#include "widgets/core/language.h"

namespace lathelier::speed_panel {
namespace {

constexpr int mostSigns = 9;      // largest number of characters of an entry
constexpr int shownDecimals = 3;  // decimals of a value, trailing zeros removed
constexpr int gap_px = 6;
constexpr char badInk[] = "color: #d0463b;";

QPushButton* makeButton(const char* name)
{
    auto* button = new QPushButton;
    button->setObjectName(name);
    button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
    button->setFocusPolicy(Qt::NoFocus);  // the keyboard types into the screen as a whole
    return button;
}

QLabel* makeLabel(const char* name)
{
    auto* label = new QLabel;
    label->setObjectName(name);
    label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
    label->setAlignment(Qt::AlignCenter);
    return label;
}

QString shown(double value, Text unit)
{
    QString text = QLocale().toString(value * screenFactor(unit), 'f', shownDecimals);
    const QChar point = QLocale().decimalPoint();
    while (text.contains(point) && (text.endsWith('0') || text.endsWith(point))) text.chop(1);
    return text.remove(QLocale().groupSeparator());
}

void setPixels(QWidget* widget, int px, bool bold = false)
{
    QFont font = widget->font();
    font.setPixelSize(std::max(6, px));
    font.setBold(bold);
    widget->setFont(font);
}

}  // namespace

OperatorKeys::OperatorKeys(std::vector<FieldInfo> asked, QStringList symbols, QWidget* parent)
    : QWidget(parent),
      asked_(std::move(asked)),
      symbols_(std::move(symbols)),
      values_(asked_.size()),
      reading_(makeLabel("reading")),
      line_(makeLabel("readingLine")),
      pad_(new QWidget)
{
    setFocusPolicy(Qt::StrongFocus);
    auto* layout = new QGridLayout(this);
    layout->setContentsMargins(gap_px, gap_px, gap_px, gap_px);
    layout->setSpacing(gap_px);
    layout->addWidget(reading_, 0, 0, 1, 2);
    layout->addWidget(line_, 1, 0, 1, 2);
    auto* list = new QGridLayout;
    list->setSpacing(gap_px);
    for (std::size_t i = 0; i < asked_.size(); ++i) {
        QPushButton* row = makeButton(asked_[i].key.c_str());
        row->setCheckable(true);
        connect(row, &QPushButton::clicked, this, [this, i] { choose(i); });
        list->addWidget(row, static_cast<int>(i), 0);
        rows_.push_back(row);
    }
    auto* grid = new QGridLayout(pad_);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(gap_px);
    pad_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
    layout->addLayout(list, 2, 0);
    layout->addWidget(pad_, 2, 1);
    layout->setRowStretch(0, 5);
    layout->setRowStretch(1, 2);
    layout->setRowStretch(2, 13);
    layout->setColumnStretch(0, 5);
    layout->setColumnStretch(1, 6);
    for (int digit = 0; digit < 10; ++digit) {
        const int row = digit == 0 ? 3 : 2 - (digit - 1) / 3;
        QPushButton* key = makeKey(QString("key%1").arg(digit), row, digit == 0 ? 0 : (digit - 1) % 3);
        connect(key, &QPushButton::clicked, this, [this, digit] { type(QChar('0' + digit)); });
    }
    point_ = makeKey("keyPoint", 3, 1);
    connect(point_, &QPushButton::clicked, this, [this] { type(QLocale().decimalPoint()); });
    connect(makeKey("keyErase", 0, 3), &QPushButton::clicked, this, &OperatorKeys::erase);
    connect(makeKey("keyClear", 1, 3), &QPushButton::clicked, this, &OperatorKeys::clear);
    connect(makeKey("keyNext", 2, 3), &QPushButton::clicked, this, [this] { choose(chosen_ + 1); });
    auto* enterKey = makeKey("keyEnter", 3, 2);
    grid->addWidget(enterKey, 3, 2, 1, 2);
    connect(enterKey, &QPushButton::clicked, this, &OperatorKeys::enter);
    relabel();
}

QPushButton* OperatorKeys::makeKey(const QString& name, int row, int column)
{
    QPushButton* key = makeButton(name.toLatin1().constData());
    static_cast<QGridLayout*>(pad_->layout())->addWidget(key, row, column);
    keys_.push_back(key);
    return key;
}

void OperatorKeys::setValues(const Values& values)
{
    for (std::size_t i = 0; i < asked_.size(); ++i) {
        const Value* const found = lathelier::find(values, asked_[i].key);
        values_[i] = found ? *found : Value();
    }
    relabel();
}

void OperatorKeys::setReading(const QString& value, const QString& unit, const QString& line, bool good)
{
    reading_->setText(good ? QString("%1 %2").arg(value, unit) : value);
    readingLine_ = line;
    good_ = good;
    showReadingLine();
    setTypeSizes();
}

/// Line under the reading: remark, or reason for a rejected entry.
void OperatorKeys::showReadingLine()
{
    const FieldInfo& info = asked_[chosen_];
    const double factor = screenFactor(info.unit);
    line_->setText(refused_ ? tr("%1: from %2 to %3 %4")
                                  .arg(screenText(info.label), QLocale().toString(info.minimum * factor, 'g', 6),
                                       QLocale().toString(info.maximum * factor, 'g', 6), screenUnit(info.unit))
                            : readingLine_);
    line_->setStyleSheet(refused_ ? badInk : "");
    reading_->setStyleSheet(good_ ? "" : badInk);
}

void OperatorKeys::choose(std::size_t which)
{
    chosen_ = which % asked_.size();
    entry_.reset();
    refused_ = false;
    relabel();
}

void OperatorKeys::type(QChar sign)
{
    QString text = refused_ ? QString() : entry_.value_or(QString());
    refused_ = false;
    const QChar point = QLocale().decimalPoint();
    if (text.size() < mostSigns && !(sign == point && text.contains(point))) text += sign;
    entry_ = text;
    relabel();
}

void OperatorKeys::erase()
{
    if (entry_) entry_->chop(1);
    refused_ = false;
    relabel();
}

void OperatorKeys::clear()
{
    entry_ = QString();
    refused_ = false;
    relabel();
}

/// Commits the entry and moves to the next value.
void OperatorKeys::enter()
{
    const FieldInfo& info = asked_[chosen_];
    const QString key = QString::fromStdString(info.key);
    const std::optional<QString> typed = entry_;
    if (typed && !typed->isEmpty()) {
        bool sound = false;
        const double value = QLocale().toDouble(*typed, &sound) / screenFactor(info.unit);
        refused_ = !sound || value < info.minimum || value > info.maximum;
        if (refused_) return relabel();
        values_[chosen_] = value;
        choose(chosen_ + 1);
        emit valueEntered(key, value);
    } else {
        if (typed) values_[chosen_] = Value();
        choose(chosen_ + 1);
        if (typed) emit valueCleared(key);
    }
}

void OperatorKeys::keyPressEvent(QKeyEvent* event)
{
    const QString text = event->text();
    const bool plain = (event->modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
    if (plain && text.size() == 1 && text[0] >= '0' && text[0] <= '9') return type(text[0]);
    if (plain && (text == "." || text == ",")) return type(QLocale().decimalPoint());
    switch (event->key()) {
        case Qt::Key_Return:
        case Qt::Key_Enter: return enter();
        case Qt::Key_Backspace: return erase();
        case Qt::Key_Delete: return clear();
        case Qt::Key_Down: return choose(chosen_ + 1);
        case Qt::Key_Up: return choose(chosen_ + asked_.size() - 1);
        default: QWidget::keyPressEvent(event);
    }
}

void OperatorKeys::relabel()
{
    for (std::size_t i = 0; i < asked_.size(); ++i) {
        const FieldInfo& info = asked_[i];
        const bool typed = i == chosen_ && entry_;
        const double* const number = std::get_if<double>(&values_[i]);
        const QString value = typed ? *entry_ + "▏" : number ? shown(*number, info.unit) : QString("–");
        rows_[i]->setText(QString("%1  %2 %3").arg(symbols_[static_cast<int>(i)], value, screenUnit(info.unit)));
        rows_[i]->setChecked(i == chosen_);
        rows_[i]->setAccessibleName(screenText(info.label));
        rows_[i]->setToolTip(screenText(info.help));
        rows_[i]->setStyleSheet(i == chosen_ && refused_ ? badInk : "");
    }
    for (int digit = 0; digit < 10; ++digit) keys_[static_cast<std::size_t>(digit)]->setText(QString::number(digit));
    const QStringList others{QString(QLocale().decimalPoint()), "⌫", "C", "▼", "↵"};
    const QStringList names{tr("Decimal mark"), tr("Erase one sign"), tr("Clear the value"), tr("Next value"),
                            tr("Take over")};
    for (int i = 0; i < others.size(); ++i) {
        QPushButton* key = keys_[std::size_t{10} + static_cast<std::size_t>(i)];
        key->setText(others[i]);
        key->setToolTip(names[i]);
        key->setAccessibleName(names[i]);
    }
    showReadingLine();
    setTypeSizes();
}

/// The font size follows the available space.
void OperatorKeys::setTypeSizes()
{
    const auto fitted = [](const QString& text, const QFont& font, int width, int most) {
        QFont trial = font;
        trial.setPixelSize(100);
        const int wide = QFontMetrics(trial).horizontalAdvance(text);
        return std::min(most, wide > 0 ? 100 * width / wide : most);
    };
    const int wide = width() - 2 * gap_px;
    setPixels(reading_, fitted(reading_->text(), reading_->font(), 9 * wide / 10, height() / 5), true);
    setPixels(line_, fitted(line_->text(), line_->font(), 95 * wide / 100, height() / 14));
    const int row = height() * 13 / 20 / static_cast<int>(rows_.size());
    int size = row / 2;
    for (QPushButton* button : rows_)
        size = std::min(size, fitted(button->text(), button->font(), wide * 5 / 11 * 9 / 10, size));
    for (QPushButton* button : rows_) setPixels(button, size, button->isChecked());
    for (QPushButton* key : keys_) setPixels(key, std::min(height() * 13 / 20 / 9, wide / 22));
}

void OperatorKeys::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    setTypeSizes();
}

void OperatorKeys::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange) relabel();
}

}  // namespace lathelier::speed_panel
