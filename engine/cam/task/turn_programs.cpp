#include "engine/cam/task/turn_programs.h"

#include <algorithm>
#include <cmath>

#include "engine/cam/job_bodies.h"
#include "engine/cam/plan_codes.h"
#include "engine/cam/plan_outcome.h"
#include "engine/cam/task/turn_task.h"
#include "engine/core/frf_item.h"
#include "engine/core/units.h"
#include "engine/gcode/program_draft.h"
#include "engine/gcode/program_input.h"
#include "engine/gcode/program_item.h"
#include "engine/io/file.h"
#include "engine/project/project_codes.h"

namespace lathelier::cam {
namespace {

int numberOf(std::size_t setup)
{
    return static_cast<int>(setup) + 1;
}

/// The input in place of a planned program.
struct Given {
    std::size_t setup = 0;
    std::string text;
    gcode::StatedCorrection correction;
    bool is_of_post = false;  // else in the dialect that it looks like
};

double largest_um(const gcode::StatedCorrection& correction)
{
    double most = 0;
    for (const double radius_mm : correction.radius_mm) most = std::max(most, std::abs(radius_mm));
    return um_per_mm * most;
}

/// Whether this was the planned text, or an edit of it.
bool isKnown(const TurnOutcome& outcome, const std::string& sha256)
{
    const auto is = [&](const ShownProgram& program) { return program.base_sha256 == sha256; };
    const auto drafted = [&](const TurningDraft& draft) { return io::sha256(draft.text) == sha256; };
    const auto& drafts = outcome.question.drafts;
    return std::any_of(outcome.programs.begin(), outcome.programs.end(), is) ||
           std::any_of(drafts.begin(), drafts.end(), drafted);
}

std::optional<Given> takeCorrected(TurnOutcome& outcome, const project::PanelState& state, task::Sources& sources)
{
    const project::Source& source = state.inputs.at(programRole);
    const std::optional<gcode::ProgramItem> program =
        gcode::programOf(task::itemValues(state, programRole, gcode::correctedItem));
    if (!program) task::throwItemNotThere(source.item, gcode::correctedItem);
    sources.add({task::itemAsInput(source.item, program->text)}, {}, source.synthetic);
    Given given{static_cast<std::size_t>(program->clamping - 1), program->text, program->correction, true};
    const Value clamping = std::int64_t{program->clamping};
    if (given.setup >= outcome.programs.size()) {
        sources.notes.push_back({notes::programNotUsed, {{"clamping", clamping}, {"item", source.item}}});
        return std::nullopt;
    }
    sources.notes.push_back(
        {notes::programCorrected,
         {{"clamping", clamping}, {"item", source.item}, {"correction_um", largest_um(given.correction)}}});
    given.is_of_post = isKnown(outcome, program->corrected_from);
    if (!given.is_of_post) sources.notes.push_back({notes::correctedFromOther, {{"item", source.item}}});
    return given;
}

std::optional<Given> takeInput(TurnOutcome& outcome, const project::PanelState& state, Stores& stores,
                               task::Sources& sources, const Progress& progress)
{
    const project::Source* const source = task::sourceOf(state, programRole);
    if (!source) return std::nullopt;
    if (!source->item.empty()) return takeCorrected(outcome, state, sources);
    const gcode::ProgramText read = *task::take<gcode::ProgramInput>(state, programRole, stores, progress, sources);
    sources.notes.push_back({notes::programGiven, {{"clamping", std::int64_t{1}}, {"path", source->path}}});
    return Given{0, gcode::toUtf8(read.text), {}, false};
}

const TurningDraft* draftOf(const TurningQuestion& question, std::size_t setup)
{
    const auto& drafts = question.drafts;
    const auto found = std::find_if(drafts.begin(), drafts.end(),
                                    [&](const TurningDraft& draft) { return draft.setup == numberOf(setup); });
    return found == drafts.end() ? nullptr : &*found;
}

void setDrafts(project::PanelState& state, const TurningQuestion& question)
{
    lathelier::set(state.parameters, draftsKey, *lathelier::find(toValues(question), draftsKey));
}

}  // namespace

std::vector<GivenProgram> chooseProgram(TurnOutcome& outcome, const TurningPlan& planned,
                                        const project::PanelState& state, Stores& stores, task::Sources& sources,
                                        const Progress& progress)
{
    for (const SetupPlan& setup : planned.setups) {
        ShownProgram& shown = outcome.programs.emplace_back();
        shown.base = setup.text;
        shown.base_sha256 = shown.sha256 = io::sha256(setup.text);
    }
    const std::optional<Given> input = takeInput(outcome, state, stores, sources, progress);
    std::vector<GivenProgram> all;
    for (std::size_t i = 0; i < planned.setups.size(); ++i) {
        ShownProgram& shown = outcome.programs[i];
        GivenProgram given{i, shown.base, {}, true, true};
        if (input && input->setup == i) {
            const project::Source& source = state.inputs.at(programRole);
            shown.origin = source.item.empty() ? ProgramOrigin::File : ProgramOrigin::Corrected;
            shown.name = source.item.empty() ? source.path : source.item;
            shown.base = given.text = input->text;
            shown.base_sha256 = shown.sha256 = io::sha256(shown.base);
            given.correction = input->correction;
            given.is_of_post = input->is_of_post;
        }
        if (const TurningDraft* draft = draftOf(outcome.question, i)) {
            if (draft->of_sha256 == shown.base_sha256) {
                given.text = draft->text;
                shown.is_changed = true;
                shown.sha256 = io::sha256(draft->text);
                shown.is_void = draft->checked_sha256 != shown.sha256;
                given.is_checked = !shown.is_void;
                sources.notes.push_back({notes::programChangedByHand, {{"clamping", std::int64_t{numberOf(i)}}}});
            } else {
                sources.notes.push_back({notes::changesOfOtherProgram, {{"clamping", std::int64_t{numberOf(i)}}}});
            }
        }
        if (shown.is_changed || shown.origin != ProgramOrigin::Planned) all.push_back(std::move(given));
    }
    return all;
}

namespace {

/// A program with the bar that it is planned for. Without the bar in a second clamping, where the stock is what the
/// first one leaves.
gcode::ProgramItem itemOf(const TurningPlan& plan, std::size_t setup)
{
    gcode::ProgramItem item;
    item.text = plan.setups.at(setup).text;
    item.clamping = numberOf(setup);
    if (setup > 0) return item;
    const Job& job = plan.setups.front().clamping.job;
    Shaft bar = stockOf(job);
    // The beam ends at the chuck's face.
    const double beyond_mm = bar.length_mm() - (job.setup.chuck_face_z_mm + job.stock.face_allowance_mm);
    if (beyond_mm > 0 && !bar.segments.empty()) bar.segments.back().length_mm -= beyond_mm;
    item.stock = std::move(bar);
    item.z_zero_mm = job.stock.face_allowance_mm;
    return item;
}

}  // namespace

std::vector<task::Product> productsOf(const std::shared_ptr<const TurnOutcome>& outcome, const Language& language)
{
    std::vector<task::Product> all;
    const TurningPlan& plan = *outcome->plan;
    std::string name = plan.job.title.empty() ? plan.part.name : plan.job.title;
    if (name.empty()) name = text(LT_TEXT("Engine", "turning program"), language);
    for (std::size_t i = 0; i < outcome->programs.size(); ++i) {
        if (!isSound(*outcome, i)) continue;
        const Values of = {{"part", name}, {"clamping", std::int64_t{numberOf(i)}}};
        all.push_back({gcode::programItem, std::to_string(i),
                       outcome->programs.size() == 1
                           ? name
                           : fill(text(LT_TEXT("Engine", "{part}, clamping {clamping}"), language), of, language),
                       [outcome, i] { return gcode::toValues(itemOf(*outcome->plan, i)); }});
    }
    for (std::size_t i = 0; i < plan.sections.size(); ++i) {
        const SectionSpeed& section = plan.sections[i];
        if (!section.receptance) continue;
        const Values at = {{"from_mm", section.z_start_mm}, {"to_mm", section.z_end_mm}};
        all.push_back({frfItem, std::to_string(i),
                       fill(text(LT_TEXT("Engine", "part at z {from_mm:1}-{to_mm:1} mm"), language), at, language),
                       [outcome, i] { return toValues(*outcome->plan->sections[i].receptance); }});
    }
    return all;
}

bool isSound(const TurnOutcome& outcome, std::size_t setup)
{
    const CheckResult& check = outcome.plan->setups.at(setup).check;
    return !outcome.programs.at(setup).is_void && check.stock.has_value() && check.findings.empty() &&
           unknownToolOf(check) == 0 && check.gouge_um <= um_per_mm * gougeLimit_mm;
}

void setDraft(project::PanelState& state, const TurnOutcome& outcome, std::size_t setup,
              const std::optional<std::string>& utf8)
{
    auto question = fromValues<TurningQuestion>(state.parameters);
    const TurningDraft* before = draftOf(question, setup);
    TurningDraft draft{numberOf(setup), outcome.programs.at(setup).base_sha256, utf8.value_or(std::string()),
                       before ? before->checked_sha256 : std::string()};
    std::erase_if(question.drafts, [&](const TurningDraft& each) { return each.setup == draft.setup; });
    if (utf8 && *utf8 != outcome.programs[setup].base) question.drafts.push_back(std::move(draft));
    setDrafts(state, question);
}

void askForCheck(project::PanelState& state, const TurnOutcome& outcome, std::size_t setup)
{
    auto question = fromValues<TurningQuestion>(state.parameters);
    for (TurningDraft& draft : question.drafts)
        if (draft.setup == numberOf(setup) && draft.of_sha256 == outcome.programs.at(setup).base_sha256)
            draft.checked_sha256 = io::sha256(draft.text);
    setDrafts(state, question);
}

}  // namespace lathelier::cam
