#include "widgets/speed/speed_picture.h"

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

/// Responses by what they are of: another cutting speed computes none anew.
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

void respond(SpeedPicture& picture, const Shaft& shaft, const receptance::SpindleReceptance& spindle, Stores& stores,
             const Progress& progress)
{
    const receptance::ReceptanceParameters asked = chatter_common::withinTable({}, spindle);
    const std::string key = toJson(toValues(shaft)).dump() + picture.inputs.back().sha256;
    const auto response = stores.of<ResponseMemo>()->find(
        key, progress, [&](const Progress& part) { return shaftReceptance(shaft, asked, spindle, part); });
    picture.notes.insert(picture.notes.end(), response->notes.begin(), response->notes.end());
    picture.used = response->used;
    Frf frf = response->frf;
    io::dropUnusableLines(frf);
    picture.frf = std::make_shared<const Frf>(std::move(frf));
}

/// The selected and the recommended speed, and what lies about them.
stability::LobeParameters shownLobes(const SpeedPicture& picture)
{
    const stability::SpeedParameters& speed = picture.question.speed;
    const double selected = stability::spindleSpeed(*speed.cutting_speed_m_min, *speed.diameter_mm);
    const double other = picture.speed ? picture.speed->recommended_rpm : selected;
    stability::LobeParameters shown;
    shown.relation = speed.relation;
    shown.speed_rpm = {{0.6 * std::fmin(selected, other), 1.5 * std::fmax(selected, other)}};
    return shown;
}

}  // namespace

SpeedPicture speedPicture(const project::PanelState& state, Stores& stores, const Progress& progress)
{
    SpeedPicture picture;
    picture.question = fromValues<SpeedQuestion>(state.parameters);
    picture.question.speed.range_m_min = rangeOf(picture.question);
    auto shaft = chatter_common::takeShaft(state, stores, progress.part(0, 0.1, LT_TEXT("Engine", "Reading")));
    picture.problem = firstMissing(picture.question, shaft.has_value());
    if (picture.problem) return picture;
    const Shaft held = shaft ? chatter_common::noted(picture, *std::move(shaft)) : barOf(picture.question);
    const auto spindle =
        chatter_common::noted(picture, *chatter_common::takeSpindle(state, stores, progress.part(0.1, 0.2)));
    respond(picture, held, spindle, stores, progress.part(0.2, 0.8, LT_TEXT("Engine", "Computing")));
    try {
        picture.speed = chooseSpeed(*picture.frf, picture.question.speed);
        picture.notes.insert(picture.notes.end(), picture.speed->notes.begin(), picture.speed->notes.end());
    } catch (const Error& error) {
        picture.problem = error;
    }
    picture.lobes = std::make_shared<const stability::LobeResult>(
        findLobes(*picture.frf, shownLobes(picture), progress.part(0.8, 1)));
    if (contains(picture.lobes->notes, notes::publishedRelation))
        picture.notes.push_back({notes::publishedRelation, {}});
    return picture;
}

report::Document reportOf(const SpeedPicture& picture, const Language& language)
{
    stability::SpeedResult speed = *picture.speed;
    speed.notes = picture.notes;  // those of the files as well
    report::Document document = speedReport(speed, *picture.frf, picture.used, language);
    document.inputs = picture.inputs;
    document.synthetic = picture.synthetic;
    document.results = {
        report::toText(report::wholeResult("speed", picture.inputs, toValues(picture.question),
                                           nestedJson(describedValues(*picture.speed)), picture.notes))};
    return document;
}

}  // namespace lathelier::speed_panel
