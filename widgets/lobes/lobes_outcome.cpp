#include "widgets/lobes/lobes_outcome.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/core/json.h"
#include "engine/core/units.h"
#include "engine/io/file.h"
#include "engine/io/io_codes.h"
#include "engine/project/project_codes.h"
#include "engine/stability/stability_codes.h"
#include "widgets/core/task/memo.h"

namespace lathelier::lobes_panel {
namespace {

constexpr double usualDepth = 1.5;  ///< default depth relative to the least limit

/// Cache of lobes by their inputs: dragging the operating point does not recompute them.
struct LobesMemo : Memo<stability::LobeResult> {};

stability::OperatingPoint pointOf(const LobesQuestion& question, const stability::LobeResult& lobes)
{
    return {question.operating_speed_rpm.value_or((lobes.speed_rpm.from + lobes.speed_rpm.to) / 2),
            question.operating_depth.value_or(usualDepth * lobes.minimum_depth_mm.value_or(1))};
}

/// Chatter marks from the panel Surface. Error itemNotThere.
void takeMarks(const project::PanelState& state, LobesOutcome& outcome)
{
    const project::Source* const source = task::sourceOf(state, marksRole);
    if (!source) return;
    const auto item = state.items.find(marksRole);
    if (item != state.items.end() && item->second.kind == stability::marksItem)
        outcome.marks = stability::marksOf(item->second.values);
    if (!outcome.marks)
        throw Error(errors::itemNotThere, {{"item", source->item}, {"kind", std::string(stability::marksItem)}});
    const std::string content = toJson(item->second.values).dump();
    outcome.inputs.push_back({source->item, static_cast<std::int64_t>(content.size()), io::sha256(content)});
    outcome.synthetic |= source->synthetic;
}

void recommend(LobesOutcome& outcome)
{
    stability::SpeedParameters asked = outcome.question.speed;
    asked.speed_rpm = outcome.point.speed_rpm;
    if (!asked.diameter_mm) asked.range_m_min.clear();
    asked.relation = outcome.question.lobes.relation;
    asked.direction_factor = outcome.question.lobes.direction_factor;
    try {
        outcome.speed = chooseSpeed(*outcome.frf, asked);
    } catch (const Error& error) {
        outcome.no_speed = error;
    }
}

}  // namespace

LobesOutcome lobesOutcome(const project::PanelState& state, Stores& stores, const Progress& progress)
{
    LobesOutcome outcome;
    outcome.question = fromValues<LobesQuestion>(state.parameters);
    outcome.question.lobes.diameter_mm = outcome.question.speed.diameter_mm;  // both refer to the same turned surface
    const LobesQuestion& question = outcome.question;
    std::string basis;  // cache key of the response
    if (auto response =
            chatter_common::takeResponse(state, stores, progress.part(0, 0.5, LT_TEXT("Engine", "Reading")))) {
        outcome.frf = std::make_shared<const Frf>(chatter_common::recordInput(outcome, std::move(response->taken)));
        basis = std::move(response->basis);
    } else {
        const double highest =
            question.lobes.speed_rpm.empty() ? stability::usualHighestSpeed_rpm : question.lobes.speed_rpm.front().to;
        outcome.frf = std::make_shared<const Frf>(stability::frfOf(question.modes, highest));
        for (const stability::Mode& mode : question.modes) basis += toJson(toValues(mode)).dump();
    }
    takeMarks(state, outcome);
    outcome.lobes = stores.of<LobesMemo>()->find(
        basis + toJson(toValues(question.lobes)).dump(), progress.part(0.5, 1, LT_TEXT("Engine", "Finding lobes")),
        [&](const Progress& computing) { return findLobes(*outcome.frf, question.lobes, computing); });
    outcome.point = pointOf(question, *outcome.lobes);
    outcome.work = pointStabilityAt(*outcome.lobes, outcome.point.speed_rpm, outcome.point.depth_mm);
    recommend(outcome);
    outcome.notes.insert(outcome.notes.end(), outcome.lobes->notes.begin(), outcome.lobes->notes.end());
    if (outcome.speed)
        for (const Note& note : outcome.speed->notes)
            if (!contains(outcome.notes, note.code)) outcome.notes.push_back(note);
    return outcome;
}

report::Answer answer(const LobesOutcome& outcome, const Language& language)
{
    const stability::LobeResult& lobes = *outcome.lobes;
    const bool relative = lobes.isRelative();
    report::Answer answer;
    answer.quantity = LT_TEXT("Engine", "Depth of cut");
    answer.value = outcome.point.depth_mm;
    if (!relative) answer.unit = unit::mm;
    answer.decimals = 3;
    if (std::isfinite(outcome.work.limit_mm)) answer.upper_limit = std::round(1000 * outcome.work.limit_mm) / 1000;
    answer.verdict = outcome.work.stable ? Verdict::Pass : Verdict::Fail;
    answer.verdict_words = outcome.work.stable ? LT_TEXT("Engine", "✓ stable") : LT_TEXT("Engine", "✗ chatter");
    answer.values = {{"speed", fixed(outcome.point.speed_rpm, 0, language)},
                     {"frequency", fixed(outcome.work.frequency_hz, 1, language)},
                     {"k", std::int64_t{outcome.work.k}},
                     {"probability", fixed(100 * outcome.work.probability_stable, 0, language)}};
    answer.sentence = !std::isfinite(outcome.work.limit_mm) ? LT_TEXT("Engine", "{speed} 1/min · no lobe limits here")
                      : lobes.band                          ? LT_TEXT("Engine",
                                                                      "{speed} 1/min · stable with a probability of {probability} % · lobe {k}, "
                                                                                               "chatter at {frequency} Hz")
                                   : LT_TEXT("Engine", "{speed} 1/min · lobe {k}, chatter at {frequency} Hz");
    if (outcome.speed) {
        const double speed = outcome.speed->recommended_rpm;
        const double limit = pointStabilityAt(lobes, speed, 0).limit_mm;
        report::Finding finding;
        finding.pattern = !std::isfinite(limit) ? LT_TEXT("Engine", "Recommended: {speed:0} 1/min")
                          : relative ? LT_TEXT("Engine", "Recommended: {speed:0} 1/min, stable up to {limit:3} ×")
                                     : LT_TEXT("Engine", "Recommended: {speed:0} 1/min, stable up to {limit_mm:3} mm");
        finding.values = {{"speed", speed}, {"limit", limit}, {"limit_mm", limit}};
        finding.offer = {{"operating_speed_rpm", std::round(speed)}};
        answer.findings.push_back(std::move(finding));
    } else if (outcome.no_speed) {
        const Value* const reason = find(outcome.no_speed->values(), "reason");
        answer.findings.push_back(
            {LT_TEXT("Engine", "No speed is recommended: {reason}"), {{"reason", reason ? *reason : Value()}}, {}, {}});
    }
    if (outcome.marks)
        if (const auto check = checkModel(*outcome.marks, lobes))
            answer.findings.push_back(modelFinding(*outcome.marks, *check, language));
    if (lobes.minimum_depth_mm && !relative)
        answer.findings.push_back({LT_TEXT("Engine", "Stable at every speed up to {depth_mm:3} mm"),
                                   {{"depth_mm", *lobes.minimum_depth_mm}},
                                   {},
                                   {}});
    return answer;
}

}  // namespace lathelier::lobes_panel
