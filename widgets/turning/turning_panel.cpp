#include "widgets/turning/turning_panel.h"

#include <algorithm>

#include "engine/cad/part_input.h"
#include "engine/cam/drawn/plan_charts.h"
#include "engine/cam/task/job_input.h"
#include "engine/cam/task/setup_sheet.h"
#include "engine/core/frf_item.h"
#include "engine/gcode/controls/controls.h"
#include "engine/gcode/program_input.h"
#include "widgets/chatter_common/understood_models.h"
#include "widgets/core/form/form.h"
#include "widgets/core/form/input_box.h"
#include "widgets/core/form/input_column.h"
#include "widgets/core/language.h"
#include "widgets/core/session.h"
#include "widgets/program_common/program_editor.h"
#include "widgets/turning/turning_exports.h"
#include "widgets/turning/turning_state.h"
#include "widgets/turning/turning_views.h"

namespace lathelier::turning_panel {
namespace {

constexpr const char* clampingKey = "clamping";
constexpr const char* coursesKey = "courses";

const std::vector<std::string> roles{cam::jobRole, cam::partRole, cam::spindleRole, cam::postRole, cam::programRole};

PanelInputs panelInputs()
{
    PanelInputs inputs = inputsOf(cam::turnTask(), roles, {}, false,
                                  LT_TEXT("Engine",
                                          "Drop a job (JOB.json) and a shaft here: its turning program follows, read "
                                          "back and checked."));
    const auto& hidden = {cam::jobOfKey, cam::skippedKey, cam::orderKey, cam::draftsKey};
    for (FieldInfo& info : infos<cam::TurningQuestion>())
        if (std::find(hidden.begin(), hidden.end(), info.key) == hidden.end()) inputs.fields.push_back(std::move(info));
    foldAllBut(inputs, {"post", "setups", "stock.diameter_mm", "setup.chuck_face_z_mm", "setup.tailstock",
                        cam::toolsKey, "cutting.material"});
    for (InputRole& role : inputs.roles) {
        role.required = false;  // either may hold the part: missingInputs()
        role.takes_next = role.role == cam::partRole;
    }
    return inputs;
}

}  // namespace

PanelFacts turningPanelFacts()
{
    PanelFacts facts = factsOf(cam::turnTask(), "turning", "turning", roles, {});
    facts.kinds = {&cam::jobFiles()};
    facts.roles = panelInputs().roles;
    facts.answer = answeredBy(cam::turningOutcome);
    facts.make = [](Session& session) -> PanelBase* { return new TurningPanel(session); };
    facts.missing = missingInputs;
    facts.has_work = [](const project::PanelState& state) { return missingInputs(state).empty(); };
    facts.report = [](const project::PanelState& state, Stores& stores, task::Sources& sources,
                      const Language& language, const Progress& progress) {
        return reportOf(cam::turningOutcome(state, stores, sources, progress), language);
    };
    return facts;
}

TurningPanel::TurningPanel(Session& owner, QWidget* parent)
    : TaskPanel(owner, turningPanelFacts(), panelInputs(), parent), views_(new TurningViews)
{
    setViews(views_, views_->primaryViews());
    connect(views_, &TurningViews::operationSwitched, this, &TurningPanel::switchOperation);
    connect(views_->order(), &OperationsPane::orderRequested, this,
            [this](const std::vector<cam::OperationStep>& order, const cam::OperationStep& moved) {
                setOrder(tr("Move: %1").arg(screenText(cam::nameOf(moved.kind))), moved.setup, order);
            });
    connect(views_->order(), &OperationsPane::orderReset, this,
            [this] { setOrder(tr("Reset the order of operations"), static_cast<int>(views_->clamping()) + 1, {}); });
    connect(views_, &TurningViews::programEdited, this,
            [this](int clamping, const std::string& utf8) { keepDraft(clamping, utf8); });
    connect(views_, &TurningViews::takeBackRequested, this,
            [this](int clamping) { keepDraft(clamping, std::nullopt); });
    connect(views_, &TurningViews::checkRequested, this, &TurningPanel::checkAgain);
    connect(views_, &TurningViews::useRequested, this, [this](int clamping) { offer(gcode::programItem, clamping); });
    connect(views_, &TurningViews::lobesRequested, this, [this](int section) { offer(frfItem, section); });
    connect(views_, &TurningViews::notWritten, this, &TurningPanel::reportWriteFailure);
    connect(&inputColumn(), &InputColumn::parameterEdited, this, &TurningPanel::followForm);
}

/// A job edited by hand is assigned to the present file, within the same undo step. Once the form rules, nothing of the
/// file is taken any more.
void TurningPanel::followForm(const std::string& key, const Value& value, int gesture, const QString& step)
{
    const auto outcome = result();
    if (!isOfJob(key) || !outcome || cam::identity(state()).empty()) return;
    Values job = toValues(outcome->plan->stated);
    lathelier::set(job, key, value);
    change(
        step,
        [&](project::PanelState& state) {
            if (!formRules(state)) setJob(state, job);
        },
        QString("turning/%1/%2").arg(QString::fromStdString(key)).arg(gesture));
}

/// Reports an error caused by a parameter of the project file.
void TurningPanel::change(const QString& step, const std::function<void(project::PanelState&)>& how,
                          const QString& merge_key)
{
    try {
        editState(step, how, merge_key);
    } catch (const Error& error) {
        emit messageRaised({error, facts().title});
    }
}

void TurningPanel::switchOperation(const cam::SkippedOperation& operation, bool on)
{
    const QString name = screenText(cam::nameOf(operation.kind));
    change(on ? tr("Switch on: %1").arg(name) : tr("Switch off: %1").arg(name), [&](project::PanelState& state) {
        cam::TurningParameters plan = fromValues<cam::TurningQuestion>(state.parameters).plan;
        std::erase(plan.skipped, operation);
        if (!on) plan.skipped.push_back(operation);
        lathelier::set(state.parameters, cam::skippedKey, *lathelier::find(toValues(plan), cam::skippedKey));
    });
}

/// Of one clamping; the order of the other one stays. Empty: the usual one.
void TurningPanel::setOrder(const QString& step, int clamping, const std::vector<cam::OperationStep>& order)
{
    change(step, [&](project::PanelState& state) {
        cam::TurningParameters plan = fromValues<cam::TurningQuestion>(state.parameters).plan;
        std::erase_if(plan.order, [clamping](const cam::OperationStep& each) { return each.setup == clamping; });
        plan.order.insert(plan.order.end(), order.begin(), order.end());
        lathelier::set(state.parameters, cam::orderKey, *lathelier::find(toValues(plan), cam::orderKey));
    });
}

/// Typing is one undo step until something else is done.
void TurningPanel::keepDraft(int clamping, const std::optional<std::string>& utf8)
{
    const auto outcome = result();
    if (!outcome || clamping >= static_cast<int>(outcome->programs.size())) return;
    change(
        utf8 ? tr("Edit the program") : tr("Take back the changes of the program"),
        [&](project::PanelState& state) { setDraft(state, *outcome, static_cast<std::size_t>(clamping), utf8); },
        utf8 ? QString("turning.program.%1").arg(clamping) : QString());
}

void TurningPanel::checkAgain(int clamping)
{
    const auto outcome = result();
    if (!outcome || clamping >= static_cast<int>(outcome->programs.size())) return;
    change(tr("Check the program again"),
           [&](project::PanelState& state) { askForCheck(state, *outcome, static_cast<std::size_t>(clamping)); });
}

void TurningPanel::assignFiles(project::PanelState& state, const std::vector<FoundFile>& files) const
{
    for (const FoundFile& file : files) {
        if (file.kind == &cam::jobFiles())
            openJob(state, file.path);
        else
            assignByKind(state, inputs().roles, {file});
    }
}

QString TurningPanel::understood(const InputRole& role, const project::Source& source) const
{
    Stores& stores = session().stores();
    if (role.role == cam::spindleRole) return chatter_common::understoodModel(source, stores);
    if (role.role == cam::jobRole) {
        const auto loaded = stores.of<task::CacheOf<cam::JobInput>>()->known(source);
        if (!loaded) return {};
        const cam::Job& job = loaded->file.job;
        return understoodText(loaded->file.facts, job.shaft ? tr("%L1 tools, with its shaft").arg(job.tools.size())
                                                            : tr("%L1 tools").arg(job.tools.size()));
    }
    if (role.role == cam::postRole) {
        const auto loaded = stores.of<task::CacheOf<cam::PostInput>>()->known(source);
        return loaded ? understoodText(loaded->file.facts, QString::fromStdString(loaded->file.post.name)) : QString();
    }
    if (role.role == cam::programRole) {
        const auto loaded = stores.of<task::CacheOf<gcode::ProgramFacts>>()->known(source);
        if (!loaded) return {};
        return understoodText(loaded->file.facts, tr("%L1 blocks").arg(loaded->file.facts.rows));
    }
    const auto loaded = stores.of<task::CacheOf<cad::PartInput>>()->known(source);
    if (!loaded) return {};
    const Shaft& shaft = loaded->file.shaft;
    return understoodText(
        loaded->file.facts,
        tr("%L1 segments · %2").arg(shaft.segments.size()).arg(screenQuantity(shaft.length_mm(), millimetre, 1)));
}

void TurningPanel::showResult(const std::shared_ptr<const cam::TurningOutcome>& outcome)
{
    inputColumn().form().setValues(toValues(outcome->plan->stated));  // also those of a file
    bool is_newest = false;
    try {
        is_newest = outcome->question.drafts == fromValues<cam::TurningQuestion>(state().parameters).drafts;
    } catch (const Error&) {
        is_newest = false;  // the present request is invalid and reports its error
    }
    views_->setOutcome(outcome, is_newest && !views_->editor()->isTyping());
}

report::Document TurningPanel::document(const cam::TurningOutcome& outcome) const
{
    return reportOf(outcome, screenLanguage());
}

std::vector<PanelExport> TurningPanel::exports() const
{
    const auto outcome = result();
    if (!outcome) return {};
    const bool two = outcome->plan->setups.size() > 1;
    std::vector<PanelExport> all{
        {two ? tr("Programs of both clampings…") : tr("Turning program…"), tr("NC program (*.nc *.ngc *.mpf *.tap)"),
         QString::fromStdString(gcode::extensionOf(outcome->plan->setups.front().check.program.control)).mid(1),
         [this, outcome](const QString& path) { writePrograms(*outcome, path, window()); }}};
    all.push_back({tr("Set-up sheet (HTML)…"), tr("Page (*.html)"), "html", [outcome](const QString& path) {
                       writeSetupSheet(*outcome, path.toStdString(), screenLanguage());
                   }});
    for (std::size_t i = 0; i < outcome->plan->setups.size(); ++i)
        all.push_back({two ? tr("Moves of the tool, clamping %1 (CSV)…").arg(i + 1) : tr("Moves of the tool (CSV)…"),
                       tr("Table (*.csv)"), "csv",
                       [outcome, i](const QString& path) { writeMovesOf(outcome->plan->setups[i], path); }});
    return all;
}

/// A line is one of the clamping in whose check it was found.
void TurningPanel::showPlace(const report::Place& place)
{
    const auto outcome = result();
    if (!outcome) return;
    if (place.line) {
        const auto& setups = outcome->plan->setups;
        const auto has = [&](const cam::SetupPlan& setup) {
            const auto& found = setup.check.findings;
            return std::any_of(found.begin(), found.end(),
                               [&](const cam::CheckFinding& each) { return each.line == *place.line; });
        };
        if (!has(setups[views_->clamping()]))
            if (const auto setup = std::find_if(setups.begin(), setups.end(), has); setup != setups.end())
                views_->setClamping(static_cast<std::size_t>(setup - setups.begin()));
        views_->primaryViews()->setPrimary("program");
        views_->goToLine(*place.line);
    } else if (place.z_mm) {
        views_->primaryViews()->setPrimary("contour");
        const auto& rests = outcome->plan->rest;
        const auto rest = std::find_if(rests.begin(), rests.end(), [&](const cam::RestInterval& each) {
            return Interval{each.z_start_mm, each.z_end_mm} == *place.z_mm;
        });
        if (rest != rests.end())
            views_->showRest(static_cast<std::size_t>(rest - rests.begin()));
        else
            views_->showStretch(*place.z_mm);
    }
}

Values TurningPanel::view() const
{
    return {{clampingKey, static_cast<std::int64_t>(views_->clamping())}, {coursesKey, views_->courses()->shown()}};
}

void TurningPanel::restoreView(const Values& kept)
{
    const auto number = [&](const char* key, std::int64_t most) {
        const Value* const value = lathelier::find(kept, key);
        const auto* stated = value ? std::get_if<std::int64_t>(value) : nullptr;
        return stated ? std::clamp<std::int64_t>(*stated, 0, most) : 0;
    };
    views_->setClamping(static_cast<std::size_t>(number(clampingKey, 1)));
    views_->courses()->setShown(number(coursesKey, (1 << CourseCharts::count) - 1));
}

void TurningPanel::setPresenting(bool presenting)
{
    Panel::setPresenting(presenting);
    views_->setPresenting(presenting);
}

void TurningPanel::retranslate()
{
    views_->retranslate();
}

}  // namespace lathelier::turning_panel
