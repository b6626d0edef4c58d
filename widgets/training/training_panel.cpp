#include "widgets/training/training_panel.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QSplitter>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/core/json.h"
#include "engine/io/file.h"
#include "engine/io/io_codes.h"
#include "engine/report/html.h"
#include "engine/stability/simulation/simulation_files.h"
#include "engine/training/lesson_kind.h"
#include "widgets/chatter_common/understood_models.h"
#include "widgets/core/language.h"
#include "widgets/core/session.h"

namespace lathelier::training_panel {
namespace {

constexpr int listening_ms = 500;
constexpr int demonstrationFrames = 250;  ///< ten seconds of film

const std::vector<std::string> roles{training::responseRole};

PanelInputs panelInputs()
{
    PanelInputs inputs =
        inputsOf(training::trainingTask(), roles, {}, false,
                 LT_TEXT("Engine", "Choose a scenario, or drop a frequency response of your own here."));
    inputs.fields = training::trainingTask().fields;
    return inputs;
}

bool isTouched(const project::PanelState& state)
{
    const Value* const speed = find(state.parameters, "operating_speed_rpm");
    return !state.inputs.empty() || (speed && !std::holds_alternative<std::monostate>(*speed));
}

}  // namespace

PanelFacts trainingPanelFacts()
{
    PanelFacts facts = factsOf(training::trainingTask(), "training", "training", roles, {});
    facts.kinds.push_back(&training::lessonFiles());
    facts.has_work = isTouched;
    facts.answer = answeredBy(training::answerTraining);
    facts.make = [](Session& session) -> PanelBase* { return new TrainingPanel(session); };
    return facts;
}

TrainingPanel::TrainingPanel(Session& owner, QWidget* parent)
    : TaskPanel(owner, trainingPanelFacts(), panelInputs(), parent),
      frames_(new FrameWriter(this)),
      views_(new TrainingViews),
      tour_(new TourPane),
      exercises_(new ExercisePane),
      panes_(new QTabWidget),
      transport_(new TransportBar(player_))
{
    panes_->setObjectName("panes");
    panes_->addTab(tour_, {});
    panes_->addTab(exercises_, {});
    auto* split = new QSplitter(Qt::Horizontal);
    split->setChildrenCollapsible(true);
    split->addWidget(views_);
    split->addWidget(panes_);
    split->setStretchFactor(0, 3);
    split->setStretchFactor(1, 1);
    auto* page = new QWidget;
    auto* layout = new QVBoxLayout(page);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addWidget(split, 1);
    layout->addWidget(transport_);
    setViews(page, views_->primaryViews());
    connect(views_, &TrainingViews::pointMoved, this, &TrainingPanel::movePoint);
    connect(views_, &TrainingViews::notWritten, this, &TrainingPanel::reportWriteFailure);
    connect(views_->primaryViews(), &PrimaryViews::primaryChanged, this, &TrainingPanel::updateTour);
    connect(transport_, &TransportBar::timeChanged, views_, &TrainingViews::setTime);
    connect(tour_, &TourPane::settingRequested, this, &TrainingPanel::takeSetting);
    connect(tour_, &TourPane::viewsRequested, views_, &TrainingViews::showStep);
    connect(tour_, &TourPane::stepBegun, this, [this] {
        views_->setExercising(false);
        player_.resetHeard();
        score_ = training::LessonState::unknown;
    });
    connect(tour_, &TourPane::lessonRequested, this, &TrainingPanel::askForLesson);
    connect(exercises_, &ExercisePane::begun, this, [this] {
        views_->clearExercise();
        views_->setExercising(true);
        panes_->setCurrentWidget(exercises_);
    });
    connect(exercises_, &ExercisePane::cutHeard, this,
            [this](const std::shared_ptr<const stability::SimulationResult>& cut) {
                views_->setListened(cut);
                playCut(*cut, exercises_->exercise()->hidden.modes);
            });
    connect(exercises_, &ExercisePane::blowHeard, views_, &TrainingViews::setBlow);
    connect(exercises_, &ExercisePane::graded, this, [this](double points) {
        score_ = points;
        views_->setExercising(false);
        playPicture();
        updateTour();
    });
    connect(exercises_, &ExercisePane::refused, this, [this](const Error& error) {
        emit messageRaised({error, facts().title});
    });
    connect(exercises_, &ExercisePane::sheetRequested, this, &TrainingPanel::askForSheet);
    connect(frames_, &FrameWriter::notWritten, this, &TrainingPanel::reportWriteFailure);
    connect(frames_, &FrameWriter::written, transport_, &TransportBar::showWriting);
    connect(transport_, &TransportBar::writingStopped, frames_, &FrameWriter::cancel);
    listening_.setInterval(listening_ms);
    connect(&listening_, &QTimer::timeout, this, [this] {
        if (player_.isOn()) updateTour();
    });
    connect(this, &PanelBase::resultShown, this, &TrainingPanel::updateTour);
    listening_.start();
    TrainingPanel::retranslate();
}

void TrainingPanel::setPresenting(bool presenting)
{
    panes_->setVisible(!presenting);
    Panel::setPresenting(presenting);
}

void TrainingPanel::movePoint(double speed_rpm, double depth_mm, bool dropped)
{
    constexpr double least = 1e-3;  // a depth that is cut; also the step
    depth_mm = std::max(least, std::round(depth_mm / least) * least);
    player_.moveTo(speed_rpm, depth_mm);  // heard before it is seen
    editState(
        tr("Move the operating point"),
        [&](project::PanelState& state) {
            lathelier::set(state.parameters, "operating_speed_rpm", std::round(speed_rpm));
            lathelier::set(state.parameters, "operating_depth", depth_mm);
        },
        QString("training/operating_point/%1").arg(gesture_));
    gesture_ += dropped;
}

void TrainingPanel::takeSetting(const training::Setting& setting)
{
    const bool is_own = setting.scenario == training::ownScenario;
    editState(tr("Step of the tour"), [&](project::PanelState& state) {
        if (!setting.scenario.empty() && !is_own) {
            lathelier::set(state.parameters, "scenario", setting.scenario);
            lathelier::set(state.parameters, "modes", Rows{});
            state.inputs.erase(training::responseRole);
            for (const char* key :
                 {"operating_speed_rpm", "operating_depth", "cutting_coefficient_N_mm2", "feed_mm_rev"})
                lathelier::set(state.parameters, key, Value());
        }
        if (setting.speed_rpm) lathelier::set(state.parameters, "operating_speed_rpm", *setting.speed_rpm);
        if (setting.depth_mm) lathelier::set(state.parameters, "operating_depth", *setting.depth_mm);
        if (setting.relation)
            lathelier::set(state.parameters, "relation",
                           training::relationChoices()[static_cast<std::size_t>(*setting.relation)].key);
    });
    if (setting.exercise) {
        exercises_->begin(*setting.exercise, setting.seed.value_or(1));
        panes_->setCurrentWidget(tour_);
    }
}

void TrainingPanel::updateTour()
{
    if (!isCurrent()) return;  // a new step is not completed by an earlier state
    training::LessonState state = result()->state;
    const auto& views = training::viewChoices();
    const std::string primary = views_->primaryViews()->primary().toStdString();
    for (std::size_t i = 0; i < views.size(); ++i)
        if (views[i].key == primary) state.view = static_cast<training::View>(i);
    state.heard_s = player_.isOn() ? player_.heard_s() : 0;
    state.score = score_;
    tour_->setState(state);
}

void TrainingPanel::playCut(const stability::SimulationResult& cut, const std::vector<stability::Mode>& modes)
{
    const stability::SimulationParameters& p = cut.parameters;
    stability::StreamParameters stream;
    stream.speed_rpm = *p.speed_rpm;
    stream.depth_mm = *p.depth_mm;
    stream.cutting_coefficient_N_mm2 = *p.cutting_coefficient_N_mm2;
    stream.feed_mm_rev = p.feed_mm_rev;
    stream.direction_factor = p.direction_factor;
    player_.setCut(modes, stream);
    sounding_.clear();
}

/// The machine on screen; while it stays the same the sound only moves along.
void TrainingPanel::playPicture()
{
    const training::TrainingOutcome& outcome = *result();
    const Json cut = {outcome.scenario.cutting_coefficient_N_mm2, outcome.scenario.feed_mm_rev};
    std::string name = cut.dump() + keyOf(outcome.scenario.modes);
    if (name != sounding_) playCut(*outcome.cut, outcome.scenario.modes);
    player_.moveTo(outcome.point.speed_rpm, outcome.point.depth_mm);
    sounding_ = std::move(name);
}

QString TrainingPanel::understood(const InputRole&, const project::Source& source) const
{
    return chatter_common::understoodModel(source, session().stores());
}

void TrainingPanel::showResult(const std::shared_ptr<const training::TrainingOutcome>& outcome)
{
    views_->setOutcome(outcome);
    transport_->setCut(outcome->cut->seconds(), outcome->cut->step_s * outcome->cut->steps_per_revolution);
    playPicture();
}

std::vector<PanelExport> TrainingPanel::exports() const
{
    std::vector<PanelExport> all = TaskPanel::exports();
    if (!result()) return all;
    all.push_back({tr("Demonstration (sound and a folder of pictures)…"), tr("Sound (*.wav)"), "wav",
                   [this](const QString& path) { writeDemonstration(path); }});
    all.push_back({tr("Pictures of all views (SVG)…"), tr("Pictures (*.svg)"), "svg",
                   [this](const QString& path) { writePictures(path); }});
    return all;
}

/// One file for each view that is shown, named after it.
void TrainingPanel::writePictures(const QString& path) const
{
    const QFileInfo file(path);
    for (const auto& [key, view] : views_->plots()) {
        if (!views_->primaryViews()->keys().contains(key)) continue;
        const QString name = file.dir().filePath(file.completeBaseName() + "_" + key + ".svg");
        if (!view->savePicture(name))
            throw Error(errors::fileNotWritable, {{"path", name.toStdString()}, {"reason", std::string()}});
    }
}

/// The large view in slow motion, and the sound beside it.
void TrainingPanel::writeDemonstration(const QString& path) const
{
    io::writeFile(path.toStdString(), stability::soundOf(*result()->cut).bytes);
    const QFileInfo file(path);
    QWidget* view = views_->primaryViews();
    transport_->setPlaying(false);
    const double length_s = result()->cut->seconds();
    frames_->begin(*view, file.dir().filePath(file.completeBaseName() + "_frames"), demonstrationFrames,
                   [this, length_s](int frame) { transport_->setTime(length_s * frame / demonstrationFrames); });
}

/// A lesson is no input: it opens in the tour.
void TrainingPanel::openFound(const std::vector<FoundFile>& files)
{
    std::vector<FoundFile> others;
    for (const FoundFile& file : files)
        if (io::findKind({&training::lessonFiles()}, file.path).likeness >= io::Likeness::Likely)
            openLesson(QString::fromStdString(file.path));
        else
            others.push_back(file);
    if (!others.empty()) Panel::openFound(others);
}

void TrainingPanel::askForLesson()
{
    const QString path = QFileDialog::getOpenFileName(this, tr("Open a lesson"), {}, tr("Lesson (*.md)"));
    if (!path.isEmpty()) openLesson(path);
}

void TrainingPanel::openLesson(const QString& path)
{
    panes_->setCurrentWidget(tour_);
    try {
        tour_->open(path);
    } catch (const Error& error) {
        emit messageRaised({error, facts().title});
    }
}

void TrainingPanel::askForSheet()
{
    const QString path = QFileDialog::getSaveFileName(this, tr("Sheet of results"), tr("results") + ".html",
                                                      tr("Report (*.html);;Table (*.csv)"));
    if (path.isEmpty()) return;
    try {
        const training::Sheet sheet = training::sheetOf(exercises_->answers());
        io::writeFile(path.toStdString(), path.endsWith(".csv", Qt::CaseInsensitive)
                                              ? sheetCsv(sheet)
                                              : report::toHtml(sheetReport(sheet), screenLanguage()));
    } catch (const Error& error) {
        emit messageRaised({error, facts().title});
    }
}

Values TrainingPanel::view() const
{
    return {{"tour_step", std::int64_t{tour_->step()}}};
}

void TrainingPanel::restoreView(const Values& kept)
{
    const Value* const step = lathelier::find(kept, "tour_step");
    const auto* const number = step ? std::get_if<std::int64_t>(step) : nullptr;
    const QSignalBlocker quiet(tour_);  // the step's settings are already in the project
    views_->primaryViews()->setBeside(number && *number >= 0 ? TrainingViews::alwaysShown() : QString());
    tour_->goTo(number ? static_cast<int>(std::clamp<std::int64_t>(*number, -1, tour_->steps() - 1)) : -1);
}

void TrainingPanel::retranslate()
{
    panes_->setTabText(0, tr("Tour"));
    panes_->setTabText(1, tr("Exercises"));
    views_->retranslate();
    transport_->retranslate();
    tour_->retranslate();
    exercises_->retranslate();
}

}  // namespace lathelier::training_panel
