#include "widgets/correction/correction_views.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>

#include "engine/deflection/deflection_plots.h"
#include "widgets/core/language.h"

namespace lathelier::correction_panel {

CorrectionViews::CorrectionViews(QWidget* parent)
    : QWidget(parent),
      primaryViews_(new PrimaryViews),
      lines_(new QTableView),
      model_(new DiffModel(this)),
      onlyChanges_(new QCheckBox),
      check_(new QToolButton),
      reason_(new QLabel),
      correction_(new plot::ChartView),
      residual_(new plot::ChartView),
      robustness_(new CopyTable)
{
    lines_->setObjectName("correctionLines");
    correction_->setObjectName("correctionAlongZ");
    residual_->setObjectName("correctionResidual");
    robustness_->setObjectName("correctionRobustness");
    lines_->setModel(model_);
    lines_->setSelectionBehavior(QAbstractItemView::SelectRows);
    lines_->setSelectionMode(QAbstractItemView::SingleSelection);
    lines_->setWordWrap(false);
    lines_->setShowGrid(false);
    lines_->verticalHeader()->hide();
    lines_->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);  // fixed row height, for speed
    lines_->verticalHeader()->setDefaultSectionSize(lines_->fontMetrics().height() + 6);
    for (const int column : {DiffModel::Program, DiffModel::Corrected, DiffModel::Reason})
        lines_->horizontalHeader()->setSectionResizeMode(column, QHeaderView::Stretch);
    lines_->horizontalHeader()->setHighlightSections(false);
    auto* both = new QWidget;
    auto* stacked = new QVBoxLayout(both);
    stacked->setContentsMargins(0, 0, 0, 0);
    check_->setObjectName("correctionCheck");
    auto* above = new QHBoxLayout;
    above->addWidget(onlyChanges_);
    above->addStretch();
    above->addWidget(check_);
    stacked->addLayout(above);
    stacked->addWidget(lines_, 1);
    reason_->setObjectName("correctionReason");
    reason_->setWordWrap(true);
    reason_->setMinimumHeight(2 * reason_->fontMetrics().lineSpacing());
    stacked->addWidget(reason_);
    primaryViews_->add("lines", both);
    primaryViews_->add("correction", correction_);
    primaryViews_->add("residual", residual_);
    primaryViews_->add("robustness", robustness_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(primaryViews_, 1);
    connect(onlyChanges_, &QCheckBox::toggled, model_, &DiffModel::setOnlyChanges);
    connect(check_, &QToolButton::clicked, this, &CorrectionViews::checkRequested);
    connect(model_, &DiffModel::taken, this, &CorrectionViews::taken);
    connect(lines_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& now) { markRow(now.row()); });
    for (plot::PlotWidget* view : {correction_, residual_})
        connect(view, &plot::PlotWidget::notWritten, this, &CorrectionViews::notWritten);
    for (plot::ChartView* view : {correction_, residual_})
        connect(view, &plot::ChartView::clicked, this, [this](double z_mm, double) {
            const int row = model_->rowAt(z_mm);
            if (row >= 0) lines_->selectRow(row);
        });
    retranslate();
}

void CorrectionViews::setOutcome(const std::shared_ptr<const DeflectionOutcome>& outcome)
{
    const int before = lines_->currentIndex().row();
    outcome_ = outcome;
    model_->setOutcome(outcome);
    show();
    const int row = before >= 0 && before < model_->rowCount() ? before : model_->firstChange();
    if (row >= 0) {
        lines_->selectRow(row);
        lines_->scrollTo(model_->index(row, 0), QAbstractItemView::PositionAtCenter);
    }
}

void CorrectionViews::markRow(int row)
{
    reason_->setText(model_->index(row, DiffModel::Reason).data().toString());
    const auto z_mm = model_->placeOf(row);
    correction_->setMarker(z_mm);
    residual_->setMarker(z_mm);
}

void CorrectionViews::show()
{
    if (!outcome_ || !outcome_->study->corrected) return;
    const deflection::CompensationResult& result = outcome_->study->corrected->compensation;
    const Language& language = screenLanguage();
    correction_->setData(deflection::correctionPlot(result, language));
    deflection::ErrorPlotParts parts;
    parts.corrected = &result;
    parts.tolerance_um = outcome_->study->parameters.tolerance_um;
    residual_->setData(deflection::errorPlot(result.before, parts, language));
    primaryViews_->setAvailable("robustness", !result.robustness.empty());
    robustness_->setTable(deflection::robustnessTable(result.robustness));
    lines_->resizeColumnToContents(DiffModel::Take);
    lines_->resizeColumnToContents(DiffModel::Line);
}

void CorrectionViews::retranslate()
{
    primaryViews_->setTitle("lines", tr("Programs side by side"));
    primaryViews_->setTitle("correction", tr("Correction"));
    primaryViews_->setTitle("residual", tr("Before and after"));
    primaryViews_->setTitle("robustness", tr("Other machines"));
    onlyChanges_->setText(tr("Changed blocks only"));
    check_->setText(tr("Check as a turning program"));
    check_->setToolTip(
        tr("Gives the corrected program with its correction to the panel Turning program, which checks it against the "
           "drawing, the stock and the chuck."));
    lines_->setAccessibleName(tr("Programs side by side"));
    robustness_->setAccessibleName(tr("Other machines"));
    model_->retranslate();
    show();
}

}  // namespace lathelier::correction_panel
