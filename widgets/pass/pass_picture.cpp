#include "widgets/pass/pass_picture.h"

#include <nlohmann/json.hpp>

#include "engine/core/core_codes.h"
#include "engine/core/json.h"
#include "engine/report/result_json.h"
#include "engine/stability/stability_codes.h"
#include "widgets/core/task/memo.h"

namespace lathelier::pass_panel {
namespace {

/// Passes by what they rest on: another speed computes none anew.
struct PassMemo : Memo<stability::PassResult> {};

}  // namespace

PassPicture passPicture(const project::PanelState& state, Stores& stores, const Progress& progress)
{
    PassPicture picture;
    picture.question = fromValues<PassQuestion>(state.parameters);
    const Progress reading = progress.part(0, 0.1, LT_TEXT("Engine", "Reading"));
    const Shaft shaft = chatter_common::noted(picture, *chatter_common::takeShaft(state, stores, reading));
    const auto spindle = chatter_common::noted(picture, *chatter_common::takeSpindle(state, stores, reading));
    const receptance::ReceptanceParameters asked = chatter_common::withinTable(picture.question.computing, spindle);
    Values basis = toValues(picture.question);
    lathelier::set(basis, speedKey, Value());
    std::string key = toJson(basis).dump();
    for (const InputFile& input : picture.inputs) key += input.sha256;
    picture.pass = stores.of<PassMemo>()->find(
        key, progress.part(0.1, 1, LT_TEXT("Engine", "Finding lobes")), [&](const Progress& part) {
            return lobesOverPass(shaft, picture.question.pass, asked, spindle, picture.question.lobes, part);
        });
    const std::vector<double>& speeds = picture.pass->speed_rpm;
    picture.speed_rpm = picture.question.operating_speed_rpm.value_or(bestOfPass(*picture.pass).speed_rpm);
    if (picture.speed_rpm < speeds.front() || picture.speed_rpm > speeds.back())
        throw Error(errors::valueOutOfRange, {{"parameter", speedKey},
                                              {"found", picture.speed_rpm},
                                              {"expected", LT_TEXT("Engine", "a number")},
                                              {"minimum", speeds.front()},
                                              {"maximum", speeds.back()}});
    picture.notes.insert(picture.notes.end(), picture.pass->notes.begin(), picture.pass->notes.end());
    if (picture.question.lobes.relation == stability::SpeedRelation::Published)
        picture.notes.push_back({notes::publishedRelation, {}});
    return picture;
}

report::Document reportOf(const PassPicture& picture, const Language& language)
{
    stability::PassResult result = *picture.pass;
    result.notes = picture.notes;  // those of the files as well
    report::Document document = passReport(result, picture.speed_rpm, picture.question.lobes, language);
    document.inputs = picture.inputs;
    document.synthetic = picture.synthetic;
    document.results = {report::toText(report::wholeResult("lobes", picture.inputs, toValues(picture.question),
                                                           Json{{"pass", passJson(result)}}, picture.notes))};
    return document;
}

}  // namespace lathelier::pass_panel
