#include "widgets/speed/speed_outcome.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/core/json.h"
#include "engine/io/frf/frf_lines.h"
#include "engine/receptance/shaft_receptance.h"
#include "engine/report/result_json.h"
#include "engine/stability/stability_codes.h"
#include "engine/stability/stability_quantities.h"
#include "engine/stability/stability_report.h"
#include "widgets/core/task/memo.h"

namespace lathelier::speed_panel {
namespace {

/// Cache of responses by their inputs: another cutting speed does not recompute them.
struct ResponseMemo : Memo<receptance::ShaftReceptanceResult> {};

Error needed(const char* key)
{
    for (const FieldInfo& info : infos<SpeedQuestion>())
        if (info.key == key) return Error(errors::valueNeeded, {{"value", info.label}});
    return Error(errors::valueNeeded, {{"value", std::string(key)}});
}

std::optional<Error> firstMissing(const SpeedQuestion& question, bool has_shaft)
{
    if (!question.speed.diameter_mm) return needed(diameterKey);
    if (!has_shaft && !question.length_mm) return needed(lengthKey);
    if (!question.speed.cutting_speed_m_min) return needed(cuttingSpeedKey);
    return std::nullopt;
}

/// The bar D × L, in place of a shaft.
Shaft barOf(const SpeedQuestion& question)
{
    const double diameter = *question.speed.diameter_mm;
    Shaft bar;
    bar.segments = {{*question.length_mm, diameter, diameter, 0, {}, {}}};
    bar.material = question.material;
    return bar;
}

void respond(SpeedOutcome& outcome, const Shaft& shaft, const receptance::SpindleReceptance& spindle, Stores& stores,
             const Progress& progress)
{
    const receptance::ReceptanceParameters asked = chatter_common::withinTable({}, spindle);
    const std::string key = toJson(toValues(shaft)).dump() + outcome.inputs.back().sha256;
    const auto response = stores.of<ResponseMemo>()->find(
        key, progress, [&](const Progress& part) { return shaftReceptance(shaft, asked, spindle, part); });
    outcome.notes.insert(outcome.notes.end(), response->notes.begin(), response->notes.end());
    outcome.used = response->used;
    Frf frf = response->frf;
    io::dropUnusableLines(frf);
    outcome.frf = std::make_shared<const Frf>(std::move(frf));
}

/// The selected and the recommended speed, and what lies about them.
stability::LobeParameters shownLobes(const SpeedOutcome& outcome)
{
    const stability::SpeedParameters& speed = outcome.question.speed;
    const double selected = stability::spindleSpeed(*speed.cutting_speed_m_min, *speed.diameter_mm);
    const double other = outcome.speed ? outcome.speed->recommended_rpm : selected;
    stability::LobeParameters shown;
    shown.relation = speed.relation;
    shown.speed_rpm = {{0.6 * std::fmin(selected, other), 1.5 * std::fmax(selected, other)}};
    return shown;
}

}  // namespace

SpeedOutcome speedOutcome(const project::PanelState& state, Stores& stores, const Progress& progress)
{
    SpeedOutcome outcome;
    outcome.question = fromValues<SpeedQuestion>(state.parameters);
    outcome.question.speed.range_m_min = rangeOf(outcome.question);
    auto shaft = chatter_common::takeShaft(state, stores, progress.part(0, 0.1, LT_TEXT("Engine", "Reading")));
    outcome.problem = firstMissing(outcome.question, shaft.has_value());
    if (outcome.problem) return outcome;
    const Shaft held = shaft ? chatter_common::recordInput(outcome, *std::move(shaft)) : barOf(outcome.question);
    const auto spindle =
        chatter_common::recordInput(outcome, *chatter_common::takeSpindle(state, stores, progress.part(0.1, 0.2)));
    respond(outcome, held, spindle, stores, progress.part(0.2, 0.8, LT_TEXT("Engine", "Computing")));
    try {
        outcome.speed = chooseSpeed(*outcome.frf, outcome.question.speed);
        outcome.notes.insert(outcome.notes.end(), outcome.speed->notes.begin(), outcome.speed->notes.end());
    } catch (const Error& error) {
        outcome.problem = error;
    }
    outcome.lobes = std::make_shared<const stability::LobeResult>(
        findLobes(*outcome.frf, shownLobes(outcome), progress.part(0.8, 1)));
    if (contains(outcome.lobes->notes, notes::publishedRelation))
        outcome.notes.push_back({notes::publishedRelation, {}});
    return outcome;
}

report::Document reportOf(const SpeedOutcome& outcome, const Language& language)
{
    stability::SpeedResult speed = *outcome.speed;
    speed.notes = outcome.notes;  // those of the files as well
    report::Document document = speedReport(speed, *outcome.frf, outcome.used, language);
    document.inputs = outcome.inputs;
    document.synthetic = outcome.synthetic;
    document.results = {
        report::toText(report::wholeResult("speed", outcome.inputs, toValues(outcome.question),
                                           nestedJson(describedValues(*outcome.speed)), outcome.notes))};
    return document;
}

}  // namespace lathelier::speed_panel
