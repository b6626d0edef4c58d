#include "widgets/spindle_machine/machine_views.h"

#include <QVBoxLayout>

#include "engine/receptance/spindle/spindle_plots.h"
#include "widgets/core/language.h"

namespace lathelier::machine_panel {

MachineViews::MachineViews(QWidget* parent)
    : QWidget(parent),
      primaryViews_(new PrimaryViews),
      magnitude_(new plot::ChartView),
      phase_(new plot::ChartView),
      heldOut_(new plot::ChartView),
      residual_(new plot::ChartView),
      condition_(new plot::ChartView),
      responses_(new CopyTable),
      use_(new QPushButton)
{
    magnitude_->setObjectName("spindleMagnitude");
    phase_->setObjectName("spindlePhase");
    heldOut_->setObjectName("heldOut");
    residual_->setObjectName("residual");
    condition_->setObjectName("condition");
    responses_->setObjectName("responses");
    use_->setObjectName("useSpindle");
    primaryViews_->add("magnitude", magnitude_);
    primaryViews_->add("phase", phase_);
    primaryViews_->add("heldOut", heldOut_);
    primaryViews_->add("residual", residual_);
    primaryViews_->add("condition", condition_);
    primaryViews_->add("responses", responses_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(primaryViews_, 1);
    layout->addWidget(use_, 0, Qt::AlignRight);
    connect(use_, &QPushButton::clicked, this, &MachineViews::spindleRequested);
    for (plot::ChartView* chart : {magnitude_, phase_, heldOut_, residual_, condition_})
        connect(chart, &plot::PlotWidget::notWritten, this, &MachineViews::notWritten);
    retranslate();
}

void MachineViews::setOutcome(const std::shared_ptr<const receptance::SpindleOutcome>& outcome)
{
    outcome_ = outcome;
    const bool measured = outcome->check != nullptr;
    for (const char* key : {"residual", "condition", "responses"}) primaryViews_->setAvailable(key, measured);
    primaryViews_->setAvailable("heldOut", measured && outcome->identified->hold_out_rms_percent.has_value());
    show();
}

void MachineViews::show()
{
    if (!outcome_) return;
    magnitude_->setData(receptance::spindleMagnitudePlot(outcome_->spindle));
    phase_->setData(receptance::spindlePhasePlot(outcome_->spindle));
    if (!outcome_->check) return;
    heldOut_->setData(receptance::heldOutPlot(*outcome_->check, screenLanguage()));
    residual_->setData(receptance::residualPlot(*outcome_->check, screenLanguage()));
    condition_->setData(receptance::conditionPlot(*outcome_->identified));
    responses_->setTable(receptance::responsesTable(*outcome_->check));
}

void MachineViews::setPresenting(bool presenting)
{
    use_->setVisible(!presenting);
}

void MachineViews::retranslate()
{
    primaryViews_->setTitle("magnitude", tr("Magnitude"));
    primaryViews_->setTitle("phase", tr("Phase"));
    primaryViews_->setTitle("heldOut", tr("Rod held out"));
    primaryViews_->setTitle("residual", tr("Residual"));
    primaryViews_->setTitle("condition", tr("Condition"));
    primaryViews_->setTitle("responses", tr("Responses"));
    responses_->setAccessibleName(tr("Responses"));
    use_->setText(tr("Use this spindle"));
    use_->setToolTip(tr("Put a shaft on it"));
    show();
}

}  // namespace lathelier::machine_panel
