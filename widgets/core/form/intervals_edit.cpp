#include "widgets/core/form/intervals_edit.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <algorithm>

#include "widgets/core/form/disconnect_children.h"
#include "widgets/core/icons.h"

namespace lathelier {

IntervalsEdit::IntervalsEdit(double minimum, double maximum, QWidget* parent)
    : QWidget(parent), minimum_(minimum), maximum_(maximum)
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    rowsLayout_ = new QVBoxLayout;
    rowsLayout_->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(rowsLayout_);
    add_ = new QToolButton(this);
    add_->setIcon(icon("add"));
    add_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    add_->setAutoRaise(true);
    layout->addWidget(add_, 0, Qt::AlignLeft);
    connect(add_, &QToolButton::clicked, this, [this] {
        addRow(std::nullopt);
        rows_.back().from->setFocus();
    });
    retranslate();
}

IntervalsEdit::~IntervalsEdit()
{
    disconnectChildren(*this);
}

std::vector<Interval> IntervalsEdit::intervals() const
{
    std::vector<Interval> result;
    for (const Row& row : rows_)
        if (row.from->number() && row.to->number() && *row.from->number() <= *row.to->number())
            result.push_back({*row.from->number(), *row.to->number()});
    return result;
}

void IntervalsEdit::setIntervals(const std::vector<Interval>& intervals)
{
    announced_ = intervals;
    if (intervals == this->intervals()) return;  // keeps an incomplete row
    while (!rows_.empty()) {
        rows_.back().widget->hide();
        rows_.back().widget->deleteLater();
        rows_.pop_back();
    }
    for (const Interval& interval : intervals) addRow(interval);
}

void IntervalsEdit::setFactor(double factor)
{
    factor_ = factor;
    for (const Row& row : rows_)
        for (NumberEdit* end : {row.from, row.to}) end->setFactor(factor_);
}

void IntervalsEdit::setNames(const QString& name, const QString& help)
{
    name_ = name;
    help_ = help;
    retranslate();
}

void IntervalsEdit::addRow(std::optional<Interval> interval)
{
    Row row{new QWidget(this), new NumberEdit(minimum_, maximum_), new NumberEdit(minimum_, maximum_), new QToolButton};
    auto* layout = new QHBoxLayout(row.widget);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(row.from, 1);
    layout->addWidget(new QLabel(QStringLiteral("–")));
    layout->addWidget(row.to, 1);
    layout->addWidget(row.remove);
    row.remove->setIcon(icon("remove"));
    row.remove->setAutoRaise(true);
    for (NumberEdit* end : {row.from, row.to}) end->setFactor(factor_);
    if (interval) {
        row.from->setNumber(interval->from);
        row.to->setNumber(interval->to);
    }
    for (NumberEdit* end : {row.from, row.to}) {
        connect(end, &NumberEdit::numberChanged, this, &IntervalsEdit::announce);
        connect(end, &NumberEdit::finished, this, &IntervalsEdit::finished);
    }
    connect(row.remove, &QToolButton::clicked, this, [this, widget = row.widget] { removeRow(widget); });
    rowsLayout_->addWidget(row.widget);
    rows_.push_back(row);
    retranslate();
}

void IntervalsEdit::removeRow(QWidget* widget)
{
    std::erase_if(rows_, [&](const Row& row) { return row.widget == widget; });
    widget->hide();
    widget->deleteLater();
    announce();
    emit finished();
}

void IntervalsEdit::announce()
{
    if (intervals() == announced_) return;
    announced_ = intervals();
    emit intervalsChanged();
}

void IntervalsEdit::retranslate()
{
    add_->setText(tr("Add a range"));
    for (const Row& row : rows_) {
        row.from->setHelp(help_);
        row.to->setHelp(help_);
        row.from->setAccessibleName(tr("%1, from").arg(name_));
        row.to->setAccessibleName(tr("%1, to").arg(name_));
        row.remove->setToolTip(tr("Remove this range"));
        row.remove->setAccessibleName(tr("Remove this range"));
    }
}

void IntervalsEdit::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) retranslate();
}

}  // namespace lathelier
