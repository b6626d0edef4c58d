#include "widgets/speed/speed_views.h"

#include <QVBoxLayout>

#include "engine/core/units.h"
#include "engine/receptance/frf_plots.h"
#include "engine/stability/stability_report.h"
#include "widgets/core/language.h"

namespace lathelier::speed_panel {
namespace {

/// The values of the operator's screen, in its order.
std::vector<FieldInfo> askedValues()
{
    std::vector<FieldInfo> asked;
    for (const char* key : {diameterKey, lengthKey, cuttingSpeedKey, lowestKey, highestKey})
        for (const FieldInfo& info : infos<SpeedQuestion>())
            if (info.key == key) asked.push_back(info);
    return asked;
}

}  // namespace

SpeedViews::SpeedViews(QWidget* parent)
    : QWidget(parent),
      primaryViews_(new PrimaryViews),
      keys_(new OperatorKeys(askedValues(), {"D", "L", "v_c", "v_c min", "v_c max"})),
      lobes_(new plot::ChartView),
      parts_(new plot::ChartView),
      candidates_(new CopyTable)
{
    keys_->setObjectName("operatorKeys");
    lobes_->setObjectName("speedLobes");
    parts_->setObjectName("speedRealImaginary");
    candidates_->setObjectName("speedCandidates");
    primaryViews_->add("keys", keys_);
    primaryViews_->add("lobes", lobes_);
    primaryViews_->add("parts", parts_);
    primaryViews_->add("candidates", candidates_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(primaryViews_, 1);
    connect(keys_, &OperatorKeys::valueEntered, this, &SpeedViews::valueEntered);
    connect(keys_, &OperatorKeys::valueCleared, this, &SpeedViews::valueCleared);
    for (plot::ChartView* chart : {lobes_, parts_})
        connect(chart, &plot::PlotWidget::notWritten, this, &SpeedViews::notWritten);
    retranslate();
}

void SpeedViews::setOutcome(const std::shared_ptr<const SpeedOutcome>& outcome)
{
    outcome_ = outcome;
    for (const char* key : {"lobes", "parts"}) primaryViews_->setAvailable(key, outcome->lobes != nullptr);
    primaryViews_->setAvailable("candidates", outcome->speed.has_value());
    show();
}

void SpeedViews::show()
{
    if (!outcome_) return;
    keys_->setValues(toValues(outcome_->question));
    if (outcome_->speed) {
        const stability::SpeedResult& speed = *outcome_->speed;
        keys_->setReading(
            screenNumber(speed.recommended_rpm, 0), screenText(unit::rpm),
            tr("instead of %1 · %2 m/min")
                .arg(screenNumber(speed.selected_rpm, 0), screenNumber(speed.recommended_cutting_speed_m_min, 0)),
            true);
        candidates_->setTable(stability::candidatesTable(speed));
    } else if (outcome_->problem) {
        keys_->setReading("–", {}, screenText(*outcome_->problem), false);
    }
    if (!outcome_->lobes) return;
    lobes_->setData(lobesPlot(*outcome_->lobes, outcome_->speed ? &*outcome_->speed : nullptr, {}, screenLanguage()));
    parts_->setData(
        receptance::realImaginaryPlot(*outcome_->frf, outcome_->lobes->frequency_of_minimum_hz, screenLanguage()));
}

void SpeedViews::retranslate()
{
    primaryViews_->setTitle("keys", tr("Operator"));
    primaryViews_->setTitle("lobes", tr("Lobes"));
    primaryViews_->setTitle("parts", tr("Real and imaginary"));
    primaryViews_->setTitle("candidates", tr("Stable speeds"));
    candidates_->setAccessibleName(tr("Stable speeds"));
    show();
}

}  // namespace lathelier::speed_panel
