#include "widgets/turning/turning_programs.h"

#include <algorithm>
#include <cmath>

#include "engine/cam/job_bodies.h"
#include "engine/cam/plan_codes.h"
#include "engine/cam/plan_outcome.h"
#include "engine/io/file.h"
#include "engine/project/project_codes.h"
#include "widgets/deflection_common/turning_files.h"
#include "widgets/turning/turning_outcome.h"

namespace lathelier::turning_panel {
namespace {

using deflection_common::ProgramStore;

int numberOf(std::size_t setup)
{
    return static_cast<int>(setup) + 1;
}

/// The input in place of a planned program.
struct Given {
    std::size_t setup = 0;
    std::string text;
    cam::StatedCorrection correction;
    bool is_of_post = false;  // else in the dialect that it looks like
};

double largest_um(const cam::StatedCorrection& correction)
{
    double most = 0;
    for (const double radius_mm : correction.radius_mm) most = std::max(most, std::abs(radius_mm));
    return um_per_mm * most;
}

/// Whether this was the planned text, or an edit of it.
bool isKnown(const TurningOutcome& outcome, const std::string& sha256)
{
    const auto is = [&](const ShownProgram& program) { return program.base_sha256 == sha256; };
    const auto drafted = [&](const TurningDraft& draft) { return io::sha256(draft.text) == sha256; };
    const auto& drafts = outcome.question.drafts;
    return std::any_of(outcome.programs.begin(), outcome.programs.end(), is) ||
           std::any_of(drafts.begin(), drafts.end(), drafted);
}

std::optional<Given> takeItem(TurningOutcome& outcome, const project::PanelState& state, const project::Source& source)
{
    const auto item = state.items.find(programRole);
    std::optional<gcode::ProgramItem> program;
    if (item != state.items.end() && item->second.kind == gcode::correctedItem)
        program = gcode::programOf(item->second.values);
    if (!program)
        throw Error(errors::itemNotThere, {{"item", source.item}, {"kind", std::string(gcode::correctedItem)}});
    outcome.inputs.push_back({source.item, static_cast<std::int64_t>(program->text.size()), io::sha256(program->text)});
    Given given{static_cast<std::size_t>(program->clamping - 1),
                program->text,
                {program->correction_z_mm, program->correction_radius_mm},
                true};
    const Value clamping = std::int64_t{program->clamping};
    if (given.setup >= outcome.programs.size()) {
        outcome.notes.push_back({notes::programNotUsed, {{"clamping", clamping}, {"item", source.item}}});
        return std::nullopt;
    }
    outcome.notes.push_back(
        {notes::programCorrected,
         {{"clamping", clamping}, {"item", source.item}, {"correction_um", largest_um(given.correction)}}});
    given.is_of_post = isKnown(outcome, program->corrected_from);
    if (!given.is_of_post) outcome.notes.push_back({notes::correctedFromOther, {{"item", source.item}}});
    return given;
}

std::optional<Given> takeInput(TurningOutcome& outcome, const project::PanelState& state, Stores& stores,
                               const Progress& progress)
{
    const auto source = state.inputs.find(programRole);
    if (source == state.inputs.end()) return std::nullopt;
    outcome.synthetic = outcome.synthetic || source->second.synthetic;
    if (!source->second.item.empty()) return takeItem(outcome, state, source->second);
    const auto loaded = stores.of<ProgramStore>()->load(source->second, progress);
    outcome.inputs.push_back(loaded->inputs.front());
    outcome.notes.insert(outcome.notes.end(), loaded->file.notes.begin(), loaded->file.notes.end());
    outcome.notes.push_back({notes::programGiven, {{"clamping", std::int64_t{1}}, {"path", source->second.path}}});
    return Given{0, deflection_common::toUtf8(loaded->file.text), {}, false};
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

std::vector<cam::GivenProgram> chooseProgram(TurningOutcome& outcome, const cam::TurningPlan& planned,
                                             const project::PanelState& state, Stores& stores, const Progress& progress)
{
    for (const cam::SetupPlan& setup : planned.setups) {
        ShownProgram& shown = outcome.programs.emplace_back();
        shown.base = setup.text;
        shown.base_sha256 = shown.sha256 = io::sha256(setup.text);
    }
    const std::optional<Given> input = takeInput(outcome, state, stores, progress);
    std::vector<cam::GivenProgram> all;
    for (std::size_t i = 0; i < planned.setups.size(); ++i) {
        ShownProgram& shown = outcome.programs[i];
        cam::GivenProgram given{i, shown.base, {}, true, true};
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
                outcome.notes.push_back({notes::programChangedByHand, {{"clamping", std::int64_t{numberOf(i)}}}});
            } else {
                outcome.notes.push_back({notes::changesOfOtherProgram, {{"clamping", std::int64_t{numberOf(i)}}}});
            }
        }
        if (shown.is_changed || shown.origin != ProgramOrigin::Planned) all.push_back(std::move(given));
    }
    return all;
}

gcode::ProgramItem itemOf(const TurningOutcome& outcome, std::size_t setup)
{
    const cam::TurningPlan& plan = *outcome.plan;
    gcode::ProgramItem item;
    item.text = plan.setups.at(setup).text;
    item.clamping = numberOf(setup);
    if (setup > 0) return item;
    const cam::Job& job = plan.setups.front().clamping.job;
    Shaft bar = cam::stockOf(job);
    // The beam ends at the chuck's face.
    const double beyond_mm = bar.length_mm() - (job.setup.chuck_face_z_mm + job.stock.face_allowance_mm);
    if (beyond_mm > 0 && !bar.segments.empty()) bar.segments.back().length_mm -= beyond_mm;
    item.stock = std::move(bar);
    item.z_zero_mm = job.stock.face_allowance_mm;
    return item;
}

std::string nameOf(const TurningOutcome& outcome)
{
    return outcome.plan->job.title.empty() ? outcome.plan->part.name : outcome.plan->job.title;
}

bool isSound(const TurningOutcome& outcome, std::size_t setup)
{
    const cam::CheckResult& check = outcome.plan->setups.at(setup).check;
    return !outcome.programs.at(setup).is_void && check.stock.has_value() && check.findings.empty() &&
           cam::unknownToolOf(check) == 0 && check.gouge_um <= um_per_mm * cam::gougeLimit_mm;
}

void setDraft(project::PanelState& state, const TurningOutcome& outcome, std::size_t setup,
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

void askForCheck(project::PanelState& state, const TurningOutcome& outcome, std::size_t setup)
{
    auto question = fromValues<TurningQuestion>(state.parameters);
    for (TurningDraft& draft : question.drafts)
        if (draft.setup == numberOf(setup) && draft.of_sha256 == outcome.programs.at(setup).base_sha256)
            draft.checked_sha256 = io::sha256(draft.text);
    setDrafts(state, question);
}

}  // namespace lathelier::turning_panel
