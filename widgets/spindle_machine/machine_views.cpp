#include "widgets/spindle_machine/machine_views.h"

#include <QVBoxLayout>

#include "engine/receptance/spindle_plots.h"
#include "widgets/core/language.h"

namespace lathelier::machine_panel {

MachineViews::MachineViews(QWidget* parent)
    : QWidget(parent),
      heroes_(new HeroViews),
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
    heroes_->add("magnitude", magnitude_);
    heroes_->add("phase", phase_);
    heroes_->add("heldOut", heldOut_);
    heroes_->add("residual", residual_);
    heroes_->add("condition", condition_);
    heroes_->add("responses", responses_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(heroes_, 1);
    layout->addWidget(use_, 0, Qt::AlignRight);
    connect(use_, &QPushButton::clicked, this, &MachineViews::spindleWanted);
    for (plot::ChartView* chart : {magnitude_, phase_, heldOut_, residual_, condition_})
        connect(chart, &plot::PlotWidget::notWritten, this, &MachineViews::notWritten);
    retranslate();
}

void MachineViews::setPicture(const std::shared_ptr<const MachinePicture>& picture)
{
    picture_ = picture;
    const bool measured = picture->check != nullptr;
    for (const char* key : {"residual", "condition", "responses"}) heroes_->setAvailable(key, measured);
    heroes_->setAvailable("heldOut", measured && picture->identified->hold_out_rms_percent.has_value());
    show();
}

void MachineViews::show()
{
    if (!picture_) return;
    magnitude_->setData(receptance::spindleMagnitudePlot(picture_->spindle));
    phase_->setData(receptance::spindlePhasePlot(picture_->spindle));
    if (!picture_->check) return;
    heldOut_->setData(receptance::heldOutPlot(*picture_->check, screenLanguage()));
    residual_->setData(receptance::residualPlot(*picture_->identified, *picture_->check));
    condition_->setData(receptance::conditionPlot(*picture_->identified));
    responses_->setTable(receptance::responsesTable(*picture_->check));
}

void MachineViews::setPresenting(bool presenting)
{
    use_->setVisible(!presenting);
}

void MachineViews::retranslate()
{
    heroes_->setTitle("magnitude", tr("Magnitude"));
    heroes_->setTitle("phase", tr("Phase"));
    heroes_->setTitle("heldOut", tr("Rod held out"));
    heroes_->setTitle("residual", tr("Residual"));
    heroes_->setTitle("condition", tr("Condition"));
    heroes_->setTitle("responses", tr("Responses"));
    responses_->setAccessibleName(tr("Responses"));
    use_->setText(tr("Use this spindle"));
    use_->setToolTip(tr("Put a shaft on it"));
    show();
}

}  // namespace lathelier::machine_panel
