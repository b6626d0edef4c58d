#include "widgets/turning/operations_pane.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QSignalBlocker>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>

#include "engine/cam/operation_order.h"
#include "widgets/core/language.h"

namespace lathelier::turning_panel {
namespace {

QString wordsOf(const cam::OperationStep& step)
{
    return QString("%1, T%2").arg(screenText(cam::nameOf(step.kind))).arg(step.tool);
}

}  // namespace

OperationsPane::OperationsPane(QWidget* parent)
    : QWidget(parent),
      table_(new OperationsTable),
      up_(new QToolButton),
      down_(new QToolButton),
      reset_(new QToolButton),
      refusal_(new QLabel)
{
    table_->setObjectName("turningOperations");
    up_->setObjectName("operationUp");
    down_->setObjectName("operationDown");
    reset_->setObjectName("operationsReset");
    refusal_->setObjectName("operationsSaid");
    up_->setArrowType(Qt::UpArrow);
    down_->setArrowType(Qt::DownArrow);
    up_->setShortcut(QKeySequence("Alt+Up"));
    down_->setShortcut(QKeySequence("Alt+Down"));
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->verticalHeader()->show();
    table_->verticalHeader()->setSectionsMovable(true);
    refusal_->setWordWrap(true);
    auto* buttons = new QHBoxLayout;
    buttons->setContentsMargins(0, 0, 0, 0);
    buttons->addWidget(up_);
    buttons->addWidget(down_);
    buttons->addWidget(reset_);
    buttons->addStretch(1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    column->addLayout(buttons);
    column->addWidget(table_, 1);
    column->addWidget(refusal_);
    refusal_->hide();
    connect(up_, &QToolButton::clicked, this, [this] { moveBy(-1); });
    connect(down_, &QToolButton::clicked, this, [this] { moveBy(1); });
    connect(reset_, &QToolButton::clicked, this, &OperationsPane::orderReset);
    connect(table_, &QTableWidget::currentCellChanged, this, [this](int now, int, int before, int) {
        if (now == before) return;
        if (now >= 0 && now < static_cast<int>(rows_.size())) chosen_ = rows_[static_cast<std::size_t>(now)];
        enableButtons();
    });
    // The header moves the row itself, which is not what moves an operation: it goes back, once the drag has ended.
    connect(table_->verticalHeader(), &QHeaderView::sectionMoved, this, [this](int row, int from, int on) {
        if (putsBack_) return;
        QTimer::singleShot(0, this, [this, row, from, on] {
            putsBack_ = true;
            table_->verticalHeader()->moveSection(on, from);
            putsBack_ = false;
            dropRow(row, on);
        });
    });
}

void OperationsPane::setOutcome(const cam::TurningOutcome& outcome, std::size_t setup)
{
    table_->setOutcome(outcome, setup);
    steps_ = stepsOf(outcome, setup);
    rows_.clear();
    rowSteps_.clear();
    for (const cam::ListedOperation& operation : listedOperations(outcome, setup)) {
        rows_.push_back(operation.which);
        rowSteps_.push_back(stepOf(operation.which, outcome.plan->job));
    }
    const auto& order = outcome.plan->parameters.order;
    isOwnOrder_ = std::any_of(order.begin(), order.end(), [setup](const cam::OperationStep& step) {
        return step.setup == static_cast<int>(setup) + 1;
    });
    refusal_->clear();
    refusal_->hide();
    const auto kept = chosen_ ? std::find(rows_.begin(), rows_.end(), *chosen_) : rows_.end();
    if (kept != rows_.end()) {
        const QSignalBlocker quiet(table_);
        table_->setCurrentCell(static_cast<int>(kept - rows_.begin()), 0);
    }
    enableButtons();
}

std::optional<std::size_t> OperationsPane::placeOf(int row) const
{
    if (row < 0 || row >= static_cast<int>(rowSteps_.size())) return std::nullopt;
    const auto step = std::find(steps_.begin(), steps_.end(), rowSteps_[static_cast<std::size_t>(row)]);
    return static_cast<std::size_t>(step - steps_.begin());
}

void OperationsPane::enableButtons()
{
    const auto place = placeOf(table_->currentRow());
    up_->setEnabled(place && *place > 0);
    down_->setEnabled(place && *place + 1 < steps_.size());
    reset_->setEnabled(isOwnOrder_);
}

void OperationsPane::moveBy(int places)
{
    const auto place = placeOf(table_->currentRow());
    if (!place || (places < 0 && *place == 0)) return;
    moveStep(table_->currentRow(), places < 0 ? *place - 1 : *place + 1);
}

void OperationsPane::dropRow(int row, int on)
{
    if (const auto place = placeOf(on)) moveStep(row, *place);
}

void OperationsPane::moveStep(int row, std::size_t place)
{
    const auto from = placeOf(row);
    if (!from || place >= steps_.size() || place == *from) return;
    std::vector<cam::OperationStep> wanted = steps_;
    const cam::OperationStep step = wanted[*from];
    wanted.erase(wanted.begin() + static_cast<std::ptrdiff_t>(*from));
    wanted.insert(wanted.begin() + static_cast<std::ptrdiff_t>(place), step);
    if (const auto fault = cam::faultOf(wanted)) {
        refusal_->setText(tr("✗ “%1” cannot run before “%2”: %3.")
                              .arg(wordsOf(fault->step), wordsOf(fault->needs), screenText(fault->reason)));
        refusal_->show();
        return;
    }
    refusal_->clear();
    refusal_->hide();
    chosen_ = step;
    emit orderRequested(wanted, step);
}

void OperationsPane::retranslate()
{
    up_->setToolTip(tr("Run this operation earlier (Alt+Up)"));
    up_->setAccessibleName(tr("Run this operation earlier"));
    down_->setToolTip(tr("Run this operation later (Alt+Down)"));
    down_->setAccessibleName(tr("Run this operation later"));
    reset_->setText(tr("Reset order"));
    reset_->setToolTip(tr("Back to the usual order of operations"));
    table_->setAccessibleName(tr("Operations"));
    table_->setToolTip(
        tr("The box switches an operation off: what it would take off stays. Drag a row by its number, or use the "
           "arrows, to run an operation earlier or later."));
    refusal_->clear();
    refusal_->hide();
}

}  // namespace lathelier::turning_panel
