#include "widgets/pass/pass_outcome.h"

#include <nlohmann/json.hpp>

#include "engine/core/core_codes.h"
#include "engine/core/json.h"
#include "engine/report/result_json.h"
#include "engine/stability/stability_codes.h"
#include "widgets/core/task/memo.h"

namespace lathelier::pass_panel {
namespace {

/// Cache of passes by their inputs: another speed does not recompute them.
struct PassMemo : Memo<stability::PassResult> {};

}  // namespace

PassOutcome passOutcome(const project::PanelState& state, Stores& stores, const Progress& progress)
{
    PassOutcome outcome;
    outcome.question = fromValues<PassQuestion>(state.parameters);
    const Progress reading = progress.part(0, 0.1, LT_TEXT("Engine", "Reading"));
    const Shaft shaft = chatter_common::recordInput(outcome, *chatter_common::takeShaft(state, stores, reading));
    const auto spindle = chatter_common::recordInput(outcome, *chatter_common::takeSpindle(state, stores, reading));
    const receptance::ReceptanceParameters asked = chatter_common::withinTable(outcome.question.computing, spindle);
    Values basis = toValues(outcome.question);
    lathelier::set(basis, speedKey, Value());
    std::string key = toJson(basis).dump();
    for (const InputFile& input : outcome.inputs) key += input.sha256;
    outcome.pass = stores.of<PassMemo>()->find(
        key, progress.part(0.1, 1, LT_TEXT("Engine", "Finding lobes")), [&](const Progress& part) {
            return lobesOverPass(shaft, outcome.question.pass, asked, spindle, outcome.question.lobes, part);
        });
    const std::vector<double>& speeds = outcome.pass->speed_rpm;
    outcome.speed_rpm = outcome.question.operating_speed_rpm.value_or(bestOfPass(*outcome.pass).speed_rpm);
    if (outcome.speed_rpm < speeds.front() || outcome.speed_rpm > speeds.back())
        throw Error(errors::valueOutOfRange, {{"parameter", speedKey},
                                              {"found", outcome.speed_rpm},
                                              {"expected", LT_TEXT("Engine", "a number")},
                                              {"minimum", speeds.front()},
                                              {"maximum", speeds.back()}});
    outcome.notes.insert(outcome.notes.end(), outcome.pass->notes.begin(), outcome.pass->notes.end());
    if (outcome.question.lobes.relation == stability::SpeedRelation::Published)
        outcome.notes.push_back({notes::publishedRelation, {}});
    return outcome;
}

report::Document reportOf(const PassOutcome& outcome, const Language& language)
{
    stability::PassResult result = *outcome.pass;
    result.notes = outcome.notes;  // those of the files as well
    report::Document document = passReport(result, outcome.speed_rpm, outcome.question.lobes, language);
    document.inputs = outcome.inputs;
    document.synthetic = outcome.synthetic;
    document.results = {report::toText(report::wholeResult("lobes", outcome.inputs, toValues(outcome.question),
                                                           Json{{"pass", passJson(result)}}, outcome.notes))};
    return document;
}

}  // namespace lathelier::pass_panel
