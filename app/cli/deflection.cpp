// deflection PROGRAM --setup SETUP.json: the diameter error that the bending work leaves, and the program without it.
#include <nlohmann/json.hpp>

#include "app/cli/programs.h"
#include "app/cli/shafts.h"
#include "app/cli/verbs.h"
#include "engine/core/core_codes.h"
#include "engine/deflection/deflection_codes.h"
#include "engine/deflection/setup_file.h"
#include "engine/deflection/turning_study.h"
#include "engine/gcode/program_kind.h"
#include "engine/io/file.h"
#include "engine/report/plain_text.h"

namespace lathelier::cli {
namespace {

constexpr const char* compensateOption = "--compensate";

/// Files that options name.
struct TurningFiles {
    std::string setup;  ///< path
    std::string stock;  ///< path; empty: as the set-up states
};

const std::vector<Field<TurningFiles>>& fieldsOf(const TurningFiles*)
{
    Label setup{LT_TEXT("Engine", "Set-up"), LT_TEXT("Engine", "Machine, tool, material and stock, from SETUP.json.")};
    setup.required = true;
    static const std::vector<Field<TurningFiles>> all{
        field("setup", &TurningFiles::setup, setup),
        field("stock", &TurningFiles::stock,
              Label{LT_TEXT("Engine", "Stock"),
                    LT_TEXT("Engine", "From FILE (a stock file or SHAFT.json), instead of the one in the set-up.")})};
    return all;
}

std::vector<Option> deflectionOptions()
{
    std::vector<Option> options = optionsOf<TurningFiles>();
    const auto add = [&options](std::vector<Option> more) {
        for (Option& option : more) options.push_back(std::move(option));
    };
    add(optionsOf<deflection::StudyParameters>());
    add(optionsOf<deflection::CompensationParameters>());
    add(optionsOf<deflection::BandParameters>());
    add(optionsOf<deflection::MapParameters>());
    add(optionsOf<deflection::IdentificationParameters>());
    add(programOptions());
    return options;
}

deflection::SetupFile readSetup(const Request& request, io::InputFiles& inputs, const Progress& progress,
                                Answer& answer)
{
    const std::string path = wordOf(request, "setup");
    if (path.empty())
        throw Error(
            errors::valueNotUnderstood,
            {{"parameter", "--setup"}, {"found", ""}, {"expected", LT_TEXT("Engine", "a set-up (SETUP.json)")}});
    deflection::SetupFile file =
        deflection::loadSetup({path, inputs.open(path, progress), request.parameters, inputs, progress});
    if (const std::string stock = wordOf(request, "stock"); !stock.empty())
        file.stock = readShaft(stock, request, inputs, progress, answer);
    if (!file.stock) throw Error(errors::stockMissing, {{"path", path}});
    answer.notes.insert(answer.notes.end(), file.notes.begin(), file.notes.end());
    return file;
}

void runDeflection(const Request& request, io::InputFiles& inputs, const Progress& progress, Answer& answer)
{
    deflection::SetupFile machine = readSetup(request, inputs, progress.part(0, 0.05), answer);
    const std::string& path = request.operands.front();
    ProgramRead read = readProgram(path, request, inputs, progress.part(0.05, 0.3));
    if (auto error = firstError(read.path, path)) throw Error(*error);
    auto parameters = fromValues<deflection::StudyParameters>(request.parameters);
    const auto output = request.outputs.find(compensateOption);
    parameters.correction = output != request.outputs.end();
    const auto map = fromValues<deflection::MapParameters>(request.parameters);
    const deflection::StudyDetails details{fromValues<deflection::BandParameters>(request.parameters),
                                           map,
                                           {0, map.least_feed_mm_rev, map.largest_feed_mm_rev},
                                           fromValues<deflection::IdentificationParameters>(request.parameters),
                                           fromValues<deflection::CompensationParameters>(request.parameters)};
    std::shared_ptr<deflection::TurningStudy> study;
    try {
        const deflection::TurningJob job =
            deflection::turningJob(std::move(read.program), std::move(read.path), std::move(*machine.stock),
                                   std::move(machine.setup), std::move(read.tools));
        study = std::make_shared<deflection::TurningStudy>(
            deflection::studyTurning(job, parameters, details, progress.part(0.3, 1)));
    } catch (Error& error) {
        throw error.with("path", path);
    }
    answerWith(
        answer, study, [](const auto& found) { return deflection::toJson(found); },
        [](const auto& found) { return deflection::studyReport(found); },
        [](const auto& found) { return report::toPlainText(deflection::studySummary(found)); });
    if (output != request.outputs.end()) io::writeFile(output->second, study->corrected->text);
}

}  // namespace

Verb deflectionVerb()
{
    return {"deflection",
            "Predict how far slender work bends under the tool, and write the program that allows for it.",
            {{"PROGRAM", "An NC program (Fanuc, Haas, Sinumerik, LinuxCNC)."}},
            deflectionOptions(),
            {&gcode::programFiles(), &deflection::setupFiles()},
            {{compensateOption, "Write the corrected program as FILE."}},
            true,
            runDeflection};
}

}  // namespace lathelier::cli
