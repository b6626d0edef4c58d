#include "widgets/chain/chain_views.h"

#include <QVBoxLayout>

#include "engine/chain/dossier_report.h"
#include "widgets/chain/chain_steps.h"
#include "widgets/core/language.h"

namespace lathelier::chain_panel {

ChainViews::ChainViews(QWidget* parent)
    : QWidget(parent),
      primaryViews_(new PrimaryViews),
      chart_(new plot::ChartView),
      rows_(new CopyTable),
      fit_(new CopyTable),
      steps_(new CopyTable),
      files_(new CopyTable),
      numbers_(new CopyTable),
      takeFit_(new QPushButton)
{
    chart_->setObjectName("proofChart");
    rows_->setObjectName("proofRows");
    fit_->setObjectName("proofFit");
    steps_->setObjectName("chainSteps");
    files_->setObjectName("chainFiles");
    numbers_->setObjectName("chainNumbers");
    takeFit_->setObjectName("takeFit");
    primaryViews_->add("proof", chart_);
    primaryViews_->add("rows", rows_);
    primaryViews_->add("fit", fit_);
    primaryViews_->add("steps", steps_);
    primaryViews_->add("files", files_);
    primaryViews_->add("numbers", numbers_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(primaryViews_, 1);
    layout->addWidget(takeFit_, 0, Qt::AlignRight);
    connect(takeFit_, &QPushButton::clicked, this, &ChainViews::fitRequested);
    connect(steps_, &QTableWidget::cellActivated, this, [this](int row, int) {
        if (looked_ && row < static_cast<int>(looked_->steps.size()))
            emit stepRequested(looked_->steps[static_cast<std::size_t>(row)].id);
    });
    connect(chart_, &plot::PlotWidget::notWritten, this, &ChainViews::notWritten);
    retranslate();
}

void ChainViews::setOutcome(const std::shared_ptr<const chain::ChainOutcome>& outcome)
{
    outcome_ = outcome;
    looked_ = outcome->dossier;
    for (const char* key : {"proof", "rows"}) primaryViews_->setAvailable(key, outcome->proof.has_value());
    primaryViews_->setAvailable("fit", outcome->fit.has_value());
    show();
}

void ChainViews::setLooked(const std::shared_ptr<const chain::Dossier>& dossier)
{
    looked_ = dossier;
    showSteps();
}

/// The files of a step stand in its tooltip.
void ChainViews::showSteps()
{
    if (!looked_) return;
    steps_->setTable(chain::stepsTable(*looked_));
    for (int row = 0; row < steps_->rowCount(); ++row) {
        const chain::ChainStep& step = looked_->steps[static_cast<std::size_t>(row)];
        QTableWidgetItem* const state = steps_->item(row, 1);
        state->setText(signOf(chain::standingOf(step)) + " " + state->text());
        for (int column = 0; column < steps_->columnCount(); ++column)
            steps_->item(row, column)->setToolTip(aboutOf(step));
    }
}

void ChainViews::show()
{
    takeFit_->setEnabled(outcome_ && outcome_->fit);
    showSteps();
    if (!outcome_) return;
    if (outcome_->proof) {
        chart_->setData(chain::plotOf(*outcome_));
        rows_->setTable(chain::proofTable(*outcome_->proof));
    }
    if (outcome_->fit) fit_->setTable(chain::fitTable(*outcome_->fit));
    files_->setTable(chain::filesTable(*outcome_->dossier));
    numbers_->setTable(chain::numbersTable(*outcome_->dossier));
}

void ChainViews::showStretch(const Interval& z_mm)
{
    primaryViews_->setPrimary("proof");
    chart_->setMarker((z_mm.from + z_mm.to) / 2);
}

void ChainViews::setPresenting(bool presenting)
{
    takeFit_->setVisible(!presenting);
}

void ChainViews::retranslate()
{
    primaryViews_->setTitle("proof", tr("Predicted and measured"));
    primaryViews_->setTitle("rows", tr("Rows"));
    primaryViews_->setTitle("fit", tr("Fit"));
    primaryViews_->setTitle("steps", tr("Steps"));
    primaryViews_->setTitle("files", tr("Files"));
    primaryViews_->setTitle("numbers", tr("Numbers"));
    rows_->setAccessibleName(tr("Rows with their normalized errors"));
    fit_->setAccessibleName(tr("Stiffness and forces fitted to the copy"));
    steps_->setAccessibleName(tr("Steps of the chain"));
    files_->setAccessibleName(tr("Files of the chain"));
    numbers_->setAccessibleName(tr("Numbers and where they stand"));
    takeFit_->setText(tr("Take the fit to the machine"));
    takeFit_->setToolTip(
        tr("Stiffness and forces as fitted to the copy become a machine of the project; Deflection and the chain take "
           "them from then on. One undo step."));
    show();
}

}  // namespace lathelier::chain_panel
