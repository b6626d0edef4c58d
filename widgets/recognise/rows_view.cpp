#include "widgets/recognise/rows_view.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "engine/features/report/recognition_report.h"
#include "widgets/core/language.h"
#include "widgets/core/panel/view_frame.h"

namespace lathelier::recognise_panel {

RowsView::RowsView(QWidget* parent)
    : QWidget(parent), table_(new CopyTable), buttons_(new QWidget), accept_(new QPushButton), all_(new QPushButton)
{
    table_->setObjectName("rows");
    table_->setMouseTracking(true);
    accept_->setObjectName("acceptSize");
    all_->setObjectName("acceptAll");
    buttons_->setProperty(ViewFrame::onlyLarge, true);
    auto* row = new QHBoxLayout(buttons_);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(accept_);
    row->addWidget(all_);
    row->addStretch();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(table_, 1);
    layout->addWidget(buttons_);
    connect(table_, &QTableWidget::cellEntered, this, [this](int row_at, int) { emit rowPointedAt(row_at); });
    connect(table_, &QTableWidget::currentCellChanged, this, [this](int row_at) {
        emit rowPointedAt(row_at);
        show();
    });
    connect(table_, &QTableWidget::cellDoubleClicked, this, [this](int row_at, int) { acceptFirst(row_at); });
    connect(accept_, &QPushButton::clicked, this, [this] { acceptFirst(table_->currentRow()); });
    connect(all_, &QPushButton::clicked, this, &RowsView::allAccepted);
    retranslate();
}

void RowsView::setOutcome(const std::shared_ptr<const cad::RecognizeOutcome>& outcome)
{
    outcome_ = outcome;
    const int at = table_->currentRow();
    {
        const QSignalBlocker quiet(table_);
        report::Table table = rowsTable(*outcome->result, screenLanguage());
        table_->setTable(table);
        table_->horizontalHeader()->setStretchLastSection(false);
        for (int row = 0; row < static_cast<int>(outcome->result->segments.size()); ++row)
            addChips(row, features::nominalColumn);
        if (at >= 0 && at < table_->rowCount()) table_->setCurrentCell(at, 0);
    }
    show();
}

/// By a person, or put in place with all that agree.
bool RowsView::isAccepted(const features::AcceptedSize& size, bool agrees) const
{
    if (agrees && outcome_->result->parameters.snap == features::Snap::Apply) return true;
    const auto& accepted = outcome_->accepted;
    return std::find(accepted.begin(), accepted.end(), size) != accepted.end();
}

/// Sizes accepted together with a suggestion: all sizes of a row given by one standard.
std::vector<features::AcceptedSize> RowsView::together(int row, const features::Suggestion& suggestion) const
{
    std::vector<features::AcceptedSize> sizes;
    for (const features::Suggestion& other : outcome_->result->segments[static_cast<std::size_t>(row)].suggestions)
        if (other.quantity == suggestion.quantity ||
            (!suggestion.designation.empty() && other.designation == suggestion.designation))
            sizes.push_back({row + 1, other.quantity});
    sizes.erase(std::unique(sizes.begin(), sizes.end()), sizes.end());
    return sizes;
}

/// One button for each suggestion: pressed when it is accepted.
void RowsView::addChips(int row, int column)
{
    const features::RecognizedRow& measured = outcome_->result->segments[static_cast<std::size_t>(row)];
    if (measured.suggestions.empty()) return;
    auto* chips = new QWidget;
    auto* layout = new QHBoxLayout(chips);
    layout->setContentsMargins(2, 0, 2, 0);
    std::vector<features::AcceptedSize> offered;
    for (const features::Suggestion& suggestion : measured.suggestions) {
        // Of equally near tapers the first is used.
        const features::AcceptedSize size{row + 1, suggestion.quantity};
        if (std::find(offered.begin(), offered.end(), size) != offered.end()) continue;
        const std::vector<features::AcceptedSize> sizes = together(row, suggestion);
        offered.insert(offered.end(), sizes.begin(), sizes.end());
        auto* chip = new QToolButton;
        const QString suggestedText = QString::fromStdString(suggestionText(suggestion, screenLanguage()));
        chip->setText(suggestedText.left(suggestedText.indexOf(" (")));
        chip->setCheckable(true);
        chip->setChecked(isAccepted(size, suggestion.agrees));
        const features::Snap snap = outcome_->result->parameters.snap;
        chip->setEnabled(snap == features::Snap::Suggest || (snap == features::Snap::Apply && !suggestion.agrees));
        QString tip = tr("Put %1 in place of the measured size.").arg(suggestedText);
        if (!suggestion.agrees)
            tip += " " + tr("The measured size is further from it than its U: only you can confirm it.");
        if (suggestion.chance_percent)
            tip +=
                " " +
                tr("That any size is as near to such a number: %1 %").arg(screenNumber(*suggestion.chance_percent, 0));
        chip->setToolTip(tip);
        chip->setAccessibleName(suggestedText);
        connect(chip, &QToolButton::clicked, this, [this, sizes] { emit sizesAccepted(sizes); });
        layout->addWidget(chip);
    }
    layout->addStretch();
    table_->item(row, column)->setForeground(Qt::transparent);  // invisible text for copying
    table_->setCellWidget(row, column, chips);
    for (QToolButton* chip : chips->findChildren<QToolButton*>()) chip->ensurePolished();
    layout->invalidate();
    table_->setColumnWidth(column, std::max(table_->columnWidth(column), chips->sizeHint().width()));
    table_->setRowHeight(row, std::max(table_->rowHeight(row), chips->sizeHint().height()));
}

void RowsView::acceptFirst(int row)
{
    if (!outcome_ || row < 0 || row >= static_cast<int>(outcome_->result->segments.size())) return;
    if (outcome_->result->parameters.snap != features::Snap::Suggest) return;
    const auto& suggestions = outcome_->result->segments[static_cast<std::size_t>(row)].suggestions;
    if (!suggestions.empty()) emit sizesAccepted(together(row, suggestions.front()));
}

void RowsView::markRow(std::optional<std::size_t> row)
{
    const QSignalBlocker quiet(table_);
    if (row && static_cast<int>(*row) < table_->rowCount())
        table_->setCurrentCell(static_cast<int>(*row), 0);
    else
        table_->clearSelection();
    show();
}

/// Enables the buttons.
void RowsView::show()
{
    const bool suggests = outcome_ && outcome_->result->parameters.snap == features::Snap::Suggest;
    const int at = table_->currentRow();
    const auto& rows = outcome_ ? outcome_->result->segments : std::vector<features::RecognizedRow>();
    const bool here = suggests && at >= 0 && at < static_cast<int>(rows.size()) &&
                      !rows[static_cast<std::size_t>(at)].suggestions.empty();
    accept_->setEnabled(here);
    all_->setEnabled(suggests && std::any_of(rows.begin(), rows.end(), [](const features::RecognizedRow& row) {
                         return !row.suggestions.empty();
                     }));
}

void RowsView::retranslate()
{
    table_->setAccessibleName(tr("Rows"));
    table_->setToolTip({});
    accept_->setText(tr("Accept"));
    accept_->setToolTip(tr("Put the suggested size of this row in place of the measured one"));
    all_->setText(tr("Accept all"));
    all_->setToolTip(
        tr("Put all suggested sizes that the measured ones agree with within U in their place; the "
           "measured ones stay beside them"));
    if (outcome_) setOutcome(outcome_);
}

}  // namespace lathelier::recognise_panel
