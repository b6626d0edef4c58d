#include "app/cli/frf_source.h"

#include "app/cli/shafts.h"
#include "engine/core/core_codes.h"
#include "engine/io/frf/frf_choice.h"
#include "engine/io/frf/frf_reader.h"
#include "engine/receptance/frf_checks.h"

namespace lathelier::cli {

const std::vector<Field<SourceParameters>>& fieldsOf(const SourceParameters*)
{
    static const std::vector<Field<SourceParameters>> all{
        rows("mode", &SourceParameters::mode, Range{0, 50},
             Label{LT_TEXT("Engine", "Modes"),
                   LT_TEXT("Engine", "In place of FRF: f_hz,zeta,stiffness_N_mm; several are summed.")}),
        field("shaft", &SourceParameters::shaft,
              Label{LT_TEXT("Engine", "Shaft"),
                    LT_TEXT("Engine",
                            "In place of FRF: a shaft whose receptance is computed, from FILE.json; with "
                            "--spindle on its machine.")})};
    return all;
}

namespace {

Frf fromFile(const std::string& path, const Request& request, io::InputFiles& inputs, const Progress& progress,
             Answer& answer)
{
    const io::FrfFile file =
        io::readFrf(path, inputs.open(path, progress), fromValues<io::ImportOptions>(request.parameters),
                    fromValues<io::FrfOptions>(request.parameters), progress);
    answer.notes.insert(answer.notes.end(), file.notes.begin(), file.notes.end());
    const io::MeasuredFrf& used = io::preferredResponse(file.frfs);
    const Notes chosen = io::notesOfChoice(file.frfs, used, path);
    answer.notes.insert(answer.notes.end(), chosen.begin(), chosen.end());
    const Notes checked = receptance::checkResponse(used, path);
    answer.notes.insert(answer.notes.end(), checked.begin(), checked.end());
    return io::toReceptance(used.frf);
}

FrfSource fromShaft(const std::string& path, const Request& request, io::InputFiles& inputs, const Progress& progress,
                    Answer& answer)
{
    const Shaft shaft = readShaft(path, request, inputs, progress.part(0, 0.05), answer);
    const auto spindle = readSpindle(request, inputs, progress.part(0.05, 0.1), answer);
    receptance::ShaftReceptanceResult result = namingShaft(path, shaft, [&] {
        return shaftReceptance(shaft, fromValues<receptance::ReceptanceParameters>(request.parameters), spindle,
                               progress.part(0.1, 1, LT_TEXT("Engine", "Computing")));
    });
    answer.notes.insert(answer.notes.end(), result.notes.begin(), result.notes.end());
    return {std::move(result.frf), std::move(result.used)};
}

}  // namespace

std::vector<Option> frfSourceOptions()
{
    std::vector<Option> options = optionsOf<SourceParameters>();
    for (Option& option : shaftOptions()) options.push_back(std::move(option));
    return options;
}

void checkOneSource(const Request& request, const SourceParameters& source)
{
    const bool has_file = !request.operands.empty();
    if (has_file + !source.mode.empty() + !source.shaft.empty() != 1)
        throw Error(errors::valueNotUnderstood, {{"parameter", "FRF"},
                                                 {"found", has_file ? Value(request.operands.front()) : Value()},
                                                 {"expected", LT_TEXT("Engine", "one of: a file, --mode, --shaft")}});
}

FrfSource frfSource(const Request& request, double highest_speed_rpm, io::InputFiles& inputs, const Progress& progress,
                    Answer& answer)
{
    const auto parameters = fromValues<SourceParameters>(request.parameters);
    checkOneSource(request, parameters);
    const bool has_modes = !parameters.mode.empty(), has_shaft = !parameters.shaft.empty();
    if (has_modes) return {stability::frfOf(parameters.mode, highest_speed_rpm), {}};
    if (has_shaft) return fromShaft(parameters.shaft, request, inputs, progress, answer);
    return {fromFile(request.operands.front(), request, inputs, progress, answer), {}};
}

}  // namespace lathelier::cli
