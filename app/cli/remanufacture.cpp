// remanufacture SCAN: the whole chain from the scan of a worn part to its program and the proof of its copy.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/cli/verb_answer.h"
#include "app/cli/verbs.h"
#include "engine/cam/job_file.h"
#include "engine/chain/dossier_kind.h"
#include "engine/chain/dossier_read.h"
#include "engine/chain/dossier_report.h"
#include "engine/chain/remanufacture.h"
#include "engine/core/core_codes.h"
#include "engine/deflection/setup_file.h"
#include "engine/features/recognition.h"
#include "engine/io/image/image_kind.h"
#include "engine/receptance/spindle_kind.h"
#include "engine/report/plain_text.h"

namespace lathelier::cli {
namespace {

using chain::ChainQuestion;

/// Options of the recognition but those of the published method, which a chain does not need.
std::vector<Option> chainOptions()
{
    std::vector<Option> options = optionsOf<ChainQuestion>();
    const std::vector<std::string>& keys = chain::recognitionKeys();
    for (Option& option : optionsOf<features::RecognitionParameters>())
        if (std::find(keys.begin(), keys.end(), option.info.key) != keys.end()) options.push_back(option);
    return options;
}

void requireFiles(const ChainQuestion& question)
{
    const auto require = [](const std::string& given, const char* option, Text expected) {
        if (given.empty())
            throw Error(errors::valueNotUnderstood, {{"parameter", option}, {"found", ""}, {"expected", expected}});
    };
    require(question.out, "--out", LT_TEXT("Engine", "a folder"));
    require(question.machine, "--machine", LT_TEXT("Engine", "a spindle (SPINDLE.json)"));
    require(question.job, "--job", LT_TEXT("Engine", "a job (JOB.json)"));
}

ChainQuestion questionOf(const Request& request)
{
    auto question = fromValues<ChainQuestion>(request.parameters);
    requireFiles(question);
    question.scan = request.operands.front();
    // Default values are omitted, as in the window, so that equal questions are recognised.
    const auto take = [&request](Values& values, const Option& option) {
        const Value* const given = find(request.parameters, option.info.key);
        if (given && *given != option.standard) set(values, option.info.key, *given);
    };
    const std::vector<std::string>& keys = chain::recognitionKeys();
    for (const Option& option : optionsOf<features::RecognitionParameters>())
        if (std::find(keys.begin(), keys.end(), option.info.key) != keys.end()) take(question.recognition, option);
    for (const Option& option : readingOptions(remanufactureVerb())) take(question.reading, option);
    return question;
}

void runRemanufacture(const Request& request, io::InputFiles& inputs, const Progress& progress, Answer& answer)
{
    const ChainQuestion question = questionOf(request);
    std::shared_ptr<const chain::Dossier> earlier;
    if (question.resume)
        if (auto found = chain::dossierIn(question.out, progress))
            earlier = std::make_shared<const chain::Dossier>(*std::move(found));
    inputs.open(question.scan, progress);
    inputs.drop();
    const chain::RunMode mode = question.resume ? chain::RunMode::OutOfDate : chain::RunMode::Everything;
    const auto dossier = std::make_shared<const chain::Dossier>(
        chain::remanufacture(question, runVerbByName, mode, earlier, inputs, progress));
    answer.notes = dossier->notes;
    answer.json = [dossier] { return chain::toJson(*dossier); };
    answer.report = [dossier] { return chain::dossierReport(*dossier); };
    answer.summary = report::toPlainText({{}, {chain::answer(*dossier), chain::stepsTable(*dossier)}});
    if (dossier->verdict) answer.pass = passed(dossier->verdict);
    // Dossier and report are in the folder in any case.
    chain::writeDossier(question, *dossier, inputs.list(), request.parameters);
    if (const auto error = dossier->error()) answer.errors.push_back(*error);
}

}  // namespace

Verb remanufactureVerb()
{
    return {"remanufacture",
            "From the scan of a worn part to its drawing, its program and the proof of its copy, in one folder.",
            {{"SCAN", "The worn part: a point cloud or mesh."}},
            chainOptions(),
            {&io::scanFiles(), &cam::jobFiles(), &receptance::spindleFiles(), &deflection::setupFiles(),
             &chain::dossierFiles()},
            {},
            true,
            runRemanufacture};
}

}  // namespace lathelier::cli
