#include "widgets/speed/speed_views.h"

#include <QVBoxLayout>

#include "engine/core/units.h"
#include "engine/receptance/frf_plots.h"
#include "engine/stability/stability_report.h"
#include "engine/stability/task/speed_entry.h"
#include "widgets/core/language.h"
#include "widgets/core/panel/task_panel.h"

namespace lathelier::speed_panel {

SpeedViews::SpeedViews(QWidget* parent)
    : QWidget(parent),
      primaryViews_(new PrimaryViews),
      keys_(new OperatorKeys(stability::screenFields(), {"D", "L", "v_c", "v_c min", "v_c max"})),
      linkBar_(new LinkBar),
      lobes_(new plot::ChartView),
      parts_(new plot::ChartView),
      candidates_(new CopyTable)
{
    keys_->setObjectName("operatorKeys");
    lobes_->setObjectName("speedLobes");
    parts_->setObjectName("speedRealImaginary");
    candidates_->setObjectName("speedCandidates");
    auto* screen = new QWidget;
    auto* rows = new QVBoxLayout(screen);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->addWidget(keys_, 1);
    rows->addWidget(linkBar_);
    primaryViews_->add("keys", screen);
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

void SpeedViews::setOutcome(const std::shared_ptr<const stability::SpeedOutcome>& outcome)
{
    outcome_ = outcome;
    linkBar_->setQuestion(outcome->asked);
    for (const char* key : {"lobes", "parts"}) primaryViews_->setAvailable(key, outcome->near != nullptr);
    primaryViews_->setAvailable("candidates", outcome->safe || outcome->published);
    show();
}

void SpeedViews::show()
{
    if (!outcome_) return;
    keys_->setValues(stability::screenValues(outcome_->asked.parameters));
    const report::Answer told = answer(*outcome_, screenLanguage());
    if (outcome_->problem && !outcome_->safe)
        keys_->setReading("–", {}, screenText(neededBy(stability::speedTask(), *outcome_->problem)), false);
    else
        keys_->setReading(screenNumber(told.value.value_or(0), 0), screenText(unit::rpm),
                          QString::fromStdString(report::sentenceText(told, screenLanguage())),
                          outcome_->recommendedRpm().has_value());
    if (outcome_->safe)
        candidates_->setTable(stability::pocketsTable(*outcome_->safe, false));
    else if (outcome_->published)
        candidates_->setTable(stability::candidatesTable(*outcome_->published));
    if (!outcome_->near) return;
    const stability::LobeResult& near = *outcome_->near;
    lobes_->setData(lobesPlot(near, marksOf(*outcome_), screenLanguage()));
    parts_->setData(
        receptance::realImaginaryPlot(*outcome_->response.frf, near.frequency_of_minimum_hz, screenLanguage()));
}

void SpeedViews::retranslate()
{
    primaryViews_->setTitle("keys", tr("Operator"));
    primaryViews_->setTitle("lobes", tr("Lobes"));
    primaryViews_->setTitle("parts", tr("Real and imaginary"));
    primaryViews_->setTitle("candidates", tr("Stable speeds"));
    candidates_->setAccessibleName(tr("Stable speeds"));
    linkBar_->retranslate();
    show();
}

}  // namespace lathelier::speed_panel
