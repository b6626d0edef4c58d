#include "widgets/lobes/lobes_picture.h"

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

constexpr double usualDepth = 1.5;  ///< of the least limit

/// Lobes by what they rest on: a drag of the operating point computes none anew.
struct LobesMemo : Memo<stability::LobeResult> {};

stability::OperatingPoint pointOf(const LobesQuestion& question, const stability::LobeResult& lobes)
{
    return {question.operating_speed_rpm.value_or((lobes.speed_rpm.from + lobes.speed_rpm.to) / 2),
            question.operating_depth.value_or(usualDepth * lobes.minimum_depth_mm.value_or(1))};
}

/// Marks of chatter that another panel has read off a surface. Error itemNotThere.
void takeMarks(const project::PanelState& state, LobesPicture& picture)
{
    const project::Source* const source = chatter_common::sourceOf(state, marksRole);
    if (!source) return;
    const auto item = state.items.find(marksRole);
    if (item != state.items.end() && item->second.kind == stability::marksItem)
        picture.marks = stability::marksOf(item->second.values);
    if (!picture.marks)
        throw Error(errors::itemNotThere, {{"item", source->item}, {"kind", std::string(stability::marksItem)}});
    const std::string content = toJson(item->second.values).dump();
    picture.inputs.push_back({source->item, static_cast<std::int64_t>(content.size()), io::sha256(content)});
    picture.synthetic |= source->synthetic;
}

void recommend(LobesPicture& picture)
{
    stability::SpeedParameters asked = picture.question.speed;
    asked.speed_rpm = picture.point.speed_rpm;
    if (!asked.diameter_mm) asked.range_m_min.clear();
    asked.relation = picture.question.lobes.relation;
    asked.direction_factor = picture.question.lobes.direction_factor;
    try {
        picture.speed = chooseSpeed(*picture.frf, asked);
    } catch (const Error& error) {
        picture.no_speed = error;
    }
}

}  // namespace

LobesPicture lobesPicture(const project::PanelState& state, Stores& stores, const Progress& progress)
{
    LobesPicture picture;
    picture.question = fromValues<LobesQuestion>(state.parameters);
    picture.question.lobes.diameter_mm = picture.question.speed.diameter_mm;  // one surface is turned
    const LobesQuestion& question = picture.question;
    std::string basis;  // tells responses apart
    if (auto response =
            chatter_common::takeResponse(state, stores, progress.part(0, 0.5, LT_TEXT("Engine", "Reading")))) {
        picture.frf = std::make_shared<const Frf>(chatter_common::noted(picture, std::move(response->taken)));
        basis = std::move(response->basis);
    } else {
        const double highest =
            question.lobes.speed_rpm.empty() ? stability::usualHighestSpeed_rpm : question.lobes.speed_rpm.front().to;
        picture.frf = std::make_shared<const Frf>(stability::frfOf(question.modes, highest));
        for (const stability::Mode& mode : question.modes) basis += toJson(toValues(mode)).dump();
    }
    takeMarks(state, picture);
    picture.lobes = stores.of<LobesMemo>()->find(
        basis + toJson(toValues(question.lobes)).dump(), progress.part(0.5, 1, LT_TEXT("Engine", "Finding lobes")),
        [&](const Progress& computing) { return findLobes(*picture.frf, question.lobes, computing); });
    picture.point = pointOf(question, *picture.lobes);
    picture.work = pointOfWork(*picture.lobes, picture.point.speed_rpm, picture.point.depth_mm);
    recommend(picture);
    picture.notes.insert(picture.notes.end(), picture.lobes->notes.begin(), picture.lobes->notes.end());
    if (picture.speed)
        for (const Note& note : picture.speed->notes)
            if (!contains(picture.notes, note.code)) picture.notes.push_back(note);
    return picture;
}

report::Answer answer(const LobesPicture& picture, const Language& language)
{
    const stability::LobeResult& lobes = *picture.lobes;
    const bool relative = lobes.isRelative();
    report::Answer answer;
    answer.quantity = LT_TEXT("Engine", "Depth of cut");
    answer.value = picture.point.depth_mm;
    if (!relative) answer.unit = unit::mm;
    answer.decimals = 3;
    if (std::isfinite(picture.work.limit_mm)) answer.upper_limit = std::round(1000 * picture.work.limit_mm) / 1000;
    answer.verdict = picture.work.stable ? Verdict::Pass : Verdict::Fail;
    answer.verdict_words = picture.work.stable ? LT_TEXT("Engine", "✓ stable") : LT_TEXT("Engine", "✗ chatter");
    answer.values = {{"speed", fixed(picture.point.speed_rpm, 0, language)},
                     {"frequency", fixed(picture.work.frequency_hz, 1, language)},
                     {"k", std::int64_t{picture.work.k}},
                     {"probability", fixed(100 * picture.work.probability_stable, 0, language)}};
    answer.sentence = !std::isfinite(picture.work.limit_mm) ? LT_TEXT("Engine", "{speed} 1/min · no lobe limits here")
                      : lobes.band                          ? LT_TEXT("Engine",
                                                                      "{speed} 1/min · stable with a probability of {probability} % · lobe {k}, "
                                                                                               "chatter at {frequency} Hz")
                                   : LT_TEXT("Engine", "{speed} 1/min · lobe {k}, chatter at {frequency} Hz");
    if (picture.speed) {
        const double speed = picture.speed->recommended_rpm;
        const double limit = pointOfWork(lobes, speed, 0).limit_mm;
        report::Finding finding;
        finding.pattern = !std::isfinite(limit) ? LT_TEXT("Engine", "Recommended: {speed:0} 1/min")
                          : relative ? LT_TEXT("Engine", "Recommended: {speed:0} 1/min, stable up to {limit:3} ×")
                                     : LT_TEXT("Engine", "Recommended: {speed:0} 1/min, stable up to {limit_mm:3} mm");
        finding.values = {{"speed", speed}, {"limit", limit}, {"limit_mm", limit}};
        finding.offer = {{"operating_speed_rpm", std::round(speed)}};
        answer.findings.push_back(std::move(finding));
    } else if (picture.no_speed) {
        const Value* const reason = find(picture.no_speed->values(), "reason");
        answer.findings.push_back(
            {LT_TEXT("Engine", "No speed is recommended: {reason}"), {{"reason", reason ? *reason : Value()}}, {}, {}});
    }
    if (picture.marks)
        if (const auto check = checkModel(*picture.marks, lobes))
            answer.findings.push_back(modelFinding(*picture.marks, *check, language));
    if (lobes.minimum_depth_mm && !relative)
        answer.findings.push_back({LT_TEXT("Engine", "Stable at every speed up to {depth_mm:3} mm"),
                                   {{"depth_mm", *lobes.minimum_depth_mm}},
                                   {},
                                   {}});
    return answer;
}

}  // namespace lathelier::lobes_panel
