#include "widgets/training/training_views.h"

#include <QVBoxLayout>
#include <cmath>

#include "engine/receptance/frf_plots.h"
#include "engine/stability/simulation/cut_views.h"
#include "engine/stability/simulation/growth_chart.h"
#include "engine/stability/simulation/simulation_report.h"
#include "engine/stability/simulation/why.h"
#include "widgets/core/language.h"

namespace lathelier::training_panel {
namespace {

QString escaped(const std::string& text)
{
    return QString::fromStdString(text).toHtmlEscaped();
}

/// The response with a line at the frequency of the vibration.
report::Plot responseAt(const Frf& frf, double frequency_hz, const Language& language)
{
    report::Plot plot = receptance::magnitudePlot(frf);
    plot.limits.push_back({report::Limit::Direction::Vertical, frequency_hz,
                           fill(text(LT_TEXT("Engine", "the cut vibrates at {frequency} Hz"), language),
                                {{"frequency", fixed(frequency_hz, 1, language)}}, language)});
    return plot;
}

}  // namespace

TrainingViews::TrainingViews(QWidget* parent)
    : QWidget(parent),
      primaryViews_(new PrimaryViews),
      lobes_(new plot::ChartView),
      growth_(new plot::ChartView),
      waveform_(new plot::ChartView),
      waves_(new plot::ChartView),
      surface_(new plot::MapView),
      frf_(new plot::ChartView),
      spindle_(new SpindleView),
      spectrum_(new plot::ChartView),
      comparison_(new plot::ChartView),
      why_(new QTextBrowser),
      exercise_(new QWidget),
      heardWave_(new plot::ChartView),
      heardTurn_(new plot::ChartView)
{
    why_->setObjectName("why");
    why_->setFrameShape(QFrame::NoFrame);
    exercise_->setObjectName("exercise");
    auto* heard = new QVBoxLayout(exercise_);
    heard->setContentsMargins(0, 0, 0, 0);
    heard->addWidget(heardWave_, 1);
    heard->addWidget(heardTurn_, 1);
    QWidget* const views[] = {lobes_, growth_,  waveform_, waves_,      surface_,
                              frf_,   spindle_, spectrum_, comparison_, why_};
    for (std::size_t i = 0; i < std::size(views); ++i)
        primaryViews_->add(QString::fromStdString(training::viewChoices()[i].key), views[i]);
    primaryViews_->add("exercise", exercise_);
    primaryViews_->setAvailable("exercise", false);
    for (const auto& [key, view] : plots()) {
        view->setObjectName("training_" + key);
        connect(view, &plot::PlotWidget::notWritten, this, &TrainingViews::notWritten);
    }
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(primaryViews_, 1);
    for (plot::ChartView* chart : {lobes_, comparison_})
        connect(chart, &plot::ChartView::handleMoved, this,
                [this](const QString& key, double speed_rpm, double depth_mm, bool dropped) {
                    if (key == stability::operatingPointKey) emit pointMoved(speed_rpm, depth_mm, dropped);
                });
    connect(surface_, &plot::MapView::limitEdited, this,
            [this](double upper_um, double) { surface_->setColours(report::DeviationColours{upper_um}); });
    connect(&filler_, &RasterFiller::filled, this, &TrainingViews::showLobes);
    retranslate();
}

std::vector<std::pair<QString, plot::PlotWidget*>> TrainingViews::plots() const
{
    return {{"lobes", lobes_},        {"growth", growth_},         {"waveform", waveform_},
            {"waves", waves_},        {"surface", surface_},       {"frf", frf_},
            {"spectrum", spectrum_},  {"comparison", comparison_}, {"heardWave", heardWave_},
            {"heardTurn", heardTurn_}};
}

void TrainingViews::setOutcome(const std::shared_ptr<const training::TrainingOutcome>& outcome)
{
    const bool same_chart = outcome_ && outcome_->limits == outcome->limits &&
                            outcome_->question.relation == outcome->question.relation &&
                            outcome_->scenario.greatest_depth_mm == outcome->scenario.greatest_depth_mm;
    outcome_ = outcome;
    showCharts();
    if (isOpen()) filler_.ask(outcome->scenario.modes, training::rasterOf(*outcome));
    if (same_chart) {
        for (plot::ChartView* chart : {lobes_, comparison_})
            chart->setHandle(stability::operatingPointKey, outcome->point.speed_rpm, outcome->point.depth_mm);
    } else {
        showLobes();
    }
    showCut();
}

bool TrainingViews::isOpen() const
{
    return !isExercising_ && !(outcome_ && outcome_->question.hide_chart);
}

void TrainingViews::showCharts()
{
    for (const char* key : {"lobes", "growth", "frf", "comparison", "why"}) primaryViews_->setAvailable(key, isOpen());
}

void TrainingViews::setExercising(bool exercising)
{
    isExercising_ = exercising;
    showCharts();
    if (outcome_ && isOpen()) filler_.ask(outcome_->scenario.modes, training::rasterOf(*outcome_));
}

QString TrainingViews::alwaysShown()
{
    return QString::fromStdString(training::viewChoices().front().key);
}

void TrainingViews::showStep(const QStringList& keys)
{
    const QString lobes = alwaysShown();
    QStringList others = keys;
    others.removeAll(lobes);
    lobes_->setGlow(!keys.isEmpty());
    primaryViews_->setBeside(keys.isEmpty() ? QString() : lobes);
    if (!keys.isEmpty()) primaryViews_->setPrimary(others.isEmpty() ? lobes : others.front());
}

void TrainingViews::setTime(double time_s)
{
    time_s_ = time_s;
    if (!outcome_) return;
    waveform_->setMarker(time_s);
    spindle_->setTime(time_s);
    showRevolution();
}

void TrainingViews::setListened(std::shared_ptr<const stability::SimulationResult> cut)
{
    listened_ = std::move(cut);
    blow_.reset();
    primaryViews_->setAvailable("exercise", true);
    primaryViews_->setPrimary("exercise");
    showListened();
}

void TrainingViews::setBlow(const training::Decay& blow)
{
    listened_.reset();
    blow_ = blow;
    primaryViews_->setAvailable("exercise", true);
    primaryViews_->setPrimary("exercise");
    showListened();
}

void TrainingViews::clearExercise()
{
    listened_.reset();
    blow_.reset();
    primaryViews_->setAvailable("exercise", false);
}

/// All that follows the operating point.
void TrainingViews::showCut()
{
    if (!outcome_) return;
    const stability::SimulationResult& cut = *outcome_->cut;
    growth_->setData(amplitudePlot(cut));
    waveform_->setData(waveformPlot(cut));
    frf_->setData(responseAt(*outcome_->frf, cut.frequency_hz, screenLanguage()));
    spectrum_->setData(spectrumPlot(cut, training::highestShown(*outcome_), screenLanguage()));
    spindle_->setCut(outcome_->cut);
    revolution_ = -1;
    setTime(time_s_);
    showWhy();
}

void TrainingViews::showLobes()
{
    if (!outcome_) return;
    const stability::RasterResult* const raster = filler_.raster();
    const auto within = [&](report::Plot plot) {
        plot.x.range = outcome_->scenario.speed_rpm;
        plot.y.range = Interval{0, outcome_->scenario.greatest_depth_mm};
        for (report::Handle& handle : plot.handles) {
            handle.x_range = plot.x.range;
            handle.y_range = plot.y.range;
        }
        return plot;
    };
    const Language language = screenLanguage();
    lobes_->setData(within(growthChart(outcome_->lobes(), raster, outcome_->point, language)));
    comparison_->setData(within(
        comparisonChart(outcome_->limits->exact, outcome_->limits->published, raster, outcome_->point, language)));
}

/// Waves and surface of the revolution that the time lies in.
void TrainingViews::showRevolution()
{
    const stability::SimulationResult& cut = *outcome_->cut;
    const int revolution = static_cast<int>(time_s_ / (cut.step_s * cut.steps_per_revolution));
    if (revolution == revolution_) return;
    revolution_ = revolution;
    waves_->setData(wavesPlot(cut, wavesOf(cut, revolution), screenLanguage()));
    report::ColourMap map = surfaceMap(cut, revolution);
    surface_->setColours(report::coloursOf(map));
    surface_->setData(std::move(map));
}

void TrainingViews::showListened()
{
    if (blow_) heardWave_->setData(decayPlot(*blow_));
    heardTurn_->setVisible(listened_ != nullptr);
    if (!listened_) return;
    heardWave_->setData(waveformPlot(*listened_));
    report::Plot turn = wavesPlot(*listened_, listened_->waves, screenLanguage());
    turn.remark = report::Caption{};  // would reveal the answer
    heardTurn_->setData(std::move(turn));
}

void TrainingViews::showWhy()
{
    const Language language = screenLanguage();
    QString html;
    for (const stability::WhyLine& line : whyOf(*outcome_->cut, outcome_->limits->exact, *outcome_->frf, language))
        html += QString(
                    "<p style='margin-bottom:2px'>%1</p><p style='margin-left:24px;margin-top:0px'><b>%2</b>"
                    "<br/>%3</p>")
                    .arg(escaped(text(line.idea, language)), escaped(line.formula), escaped(line.numbers));
    why_->setHtml(html);
}

void TrainingViews::retranslate()
{
    for (const FieldChoice& view : training::viewChoices())
        primaryViews_->setTitle(QString::fromStdString(view.key), screenText(view.label));
    primaryViews_->setTitle("exercise", tr("Cut of the exercise"));
    why_->setAccessibleName(tr("Why?"));
    spindle_->retranslate();
    showLobes();
    showCut();
    showListened();
}

}  // namespace lathelier::training_panel
