// compare REFERENCE COPY: deviation of the copy from the original or the drawing, with location and uncertainty.
#include "engine/registration/compare.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/cli/any_shaft.h"
#include "app/cli/scans.h"
#include "app/cli/verbs.h"
#include "engine/core/core_codes.h"
#include "engine/features/shaft_comparison.h"
#include "engine/io/cloud/unit_choice.h"
#include "engine/io/io_codes.h"
#include "engine/io/json/json_locate.h"
#include "engine/registration/compare_quantities.h"
#include "engine/registration/compare_report.h"
#include "engine/registration/deviation_file.h"
#include "engine/registration/verdict/zone_limits.h"
#include "engine/report/plain_text.h"
#include "engine/shaft/shaft_rules.h"

namespace lathelier::cli {
namespace {

constexpr const char* deviationsOption = "--deviations";
constexpr const char* zonesKey = "zones";

/// Units of the two files, each ruling over --unit.
struct CompareUnits {
    io::LengthUnit reference_unit = io::LengthUnit::Auto;  ///< of the reference; Auto: as --unit says
    io::LengthUnit copy_unit = io::LengthUnit::Auto;       ///< of the copy; Auto: as --unit says
};

const std::vector<Field<CompareUnits>>& fieldsOf(const CompareUnits*)
{
    static const auto unitField = [](const char* key, io::LengthUnit CompareUnits::*unit, Text label, Text help) {
        return field(key, unit,
                     {{"auto", LT_TEXT("Engine", "automatic")},
                      {"mm", {"mm"}},
                      {"m", {"m"}},
                      {"inch", {"inch"}},
                      {"um", {"µm"}}},
                     {label, help});
    };
    static const std::vector<Field<CompareUnits>> all{
        unitField("reference_unit", &CompareUnits::reference_unit, LT_TEXT("Engine", "Unit of the reference"),
                  LT_TEXT("Engine", "Rules over --unit for the reference, where it states none.")),
        unitField("copy_unit", &CompareUnits::copy_unit, LT_TEXT("Engine", "Unit of the copy"),
                  LT_TEXT("Engine", "Rules over --unit for the copy, where it states none."))};
    return all;
}

/// The request with the unit of one of its files as --unit.
Request withUnit(const Request& request, io::LengthUnit CompareUnits::*of)
{
    Request own = request;
    const io::LengthUnit unit = fromValues<CompareUnits>(request.parameters).*of;
    if (unit == io::LengthUnit::Auto) return own;
    io::ImportOptions options = fromValues<io::ImportOptions>(request.parameters);
    options.unit = unit;
    for (const auto& [key, value] : toValues(options))
        if (key == "unit") set(own.parameters, key, value);
    return own;
}

/// The options of the parameters and of the units; zones come in a file.
std::vector<Option> compareOptions()
{
    std::vector<Option> options = optionsOf<registration::CompareParameters>();
    for (Option& option : options) {
        if (option.info.key != zonesKey) continue;
        option.info.kind = FieldInfo::Kind::Word;
        option.info.columns.clear();
        option.info.optional = true;
        option.info.help = LT_TEXT("Engine", "Limits of their own along the axis, from FILE.json.");
        option.standard = {};
    }
    for (Option& option : optionsOf<CompareUnits>()) options.push_back(std::move(option));
    return options;
}

/// The parameters of a request, its zones read.
registration::CompareParameters parametersOf(const Request& request, io::InputFiles& inputs, const Progress& progress,
                                             Answer& answer)
{
    Values values = request.parameters;
    std::erase_if(values, [](const auto& value) { return value.first == zonesKey; });
    auto parameters = fromValues<registration::CompareParameters>(values);
    const Value* const given = find(request.parameters, zonesKey);
    const auto* const path = given ? std::get_if<std::string>(given) : nullptr;
    if (!path) return parameters;
    try {
        parameters.zones = registration::readZones(std::string(inputs.open(*path, progress)), answer.notes);
    } catch (Error& error) {
        error.with("path", *path);
        throw;
    }
    return parameters;
}

/// Calls `compare` and adds the file to errors, in which the engine names the role of the scan; `remark` is called with
/// the error.
template <class Compare, class Remark>
auto compared(const Request& request, Compare compare, Remark remark)
{
    try {
        return compare();
    } catch (Error& error) {
        remark(error);
        const Value* const role = find(error.values(), "role");
        const auto* const name = role ? std::get_if<std::string>(role) : nullptr;
        if (name) error.with("path", request.operands.at(*name == "copy" ? 1 : 0));
        throw;
    }
}

/// Size of a shaft as sizeOf_mm() has it for points on its surface.
double sizeOf_mm(const Shaft& shaft)
{
    double area = 0, radii = 0;
    for (const ShaftSegment& segment : shaft.segments) {
        const double radius_mm = (segment.start_diameter_mm + segment.end_diameter_mm) / 4;
        area += radius_mm * segment.length_mm;
        radii += radius_mm * radius_mm * radius_mm * segment.length_mm;
    }
    const double length_mm = shaft.length_mm();
    return area > 0 ? std::sqrt(length_mm * length_mm / 12 + radii / area) : 0;
}

/// The note of parts that differ by a factor of units, for a refusal.
void noteUnits(const Error& error, double reference_mm, double copy_mm, Notes& notes)
{
    if (error.code().kind != ErrorKind::NoAnswer) return;
    if (const auto factor = io::unitFactorBetween(reference_mm, copy_mm))
        notes.push_back({notes::unitsMayDiffer, {{"factor", *factor}, {"size_ratio", copy_mm / reference_mm}}});
}

/// The shaft of a drawing; errors carry its path.
Shaft drawnShaft(std::string_view bytes, const std::string& path, const Progress& progress, Answer& answer)
{
    try {
        Json facts;
        Shaft shaft = readAnyShaft(bytes, answer.notes, facts, progress);
        const Notes remarks = checkShaft(shaft);
        answer.notes.insert(answer.notes.end(), remarks.begin(), remarks.end());
        return shaft;
    } catch (Error& error) {
        io::locateRow(error, path);
        throw error.with("path", path);
    }
}

/// Sizes and surface against a drawing. Gives the comparison of the surface.
std::shared_ptr<const registration::CompareResult> answerShaft(features::ShaftComparison found, Answer& answer)
{
    const auto result = std::make_shared<features::ShaftComparison>(std::move(found));
    Notes& notes = result->surface.notes;
    answer.notes.insert(answer.notes.end(), notes.begin(), notes.end());
    notes = answer.notes;
    answer.json = [result] { return toJson(*result); };
    answer.report = [result] { return shaftReport(*result, {}); };
    answer.pass = passed(result->verdict);
    answer.summary = report::toPlainText(surfaceSummary(*result)) + "\n" + report::toPlainText(sizesSection(*result));
    return {result, &result->surface};
}

std::shared_ptr<const registration::CompareResult> answerScan(registration::CompareResult found, Answer& answer)
{
    const auto result = std::make_shared<registration::CompareResult>(std::move(found));
    answerWith(
        answer, result, [](const auto& all) { return toJson(all); },
        [](const auto& all) { return compareReport(all, {}); },
        [](const auto& all) { return report::toPlainText(compareSummary(all)); });
    return result;
}

void runCompare(const Request& request, io::InputFiles& inputs, const Progress& progress, Answer& answer)
{
    const auto deviations = request.outputs.find(deviationsOption);
    const bool wanted = deviations != request.outputs.end();
    if (wanted && !registration::isDeviationFile(deviations->second))  // checked before the computation
        throw Error(errors::valueNotUnderstood, {{"parameter", deviationsOption},
                                                 {"found", deviations->second},
                                                 {"expected", LT_TEXT("Engine", "a name in .ply or .csv")}});
    const registration::CompareParameters parameters = parametersOf(request, inputs, progress.part(0, 0.01), answer);
    const Text reading = LT_TEXT("Engine", "Reading");
    const std::string& path = request.operands.at(0);
    const Progress first = progress.part(0, 0.15, reading);
    const std::string_view bytes = inputs.open(path, first);
    const bool is_drawn = isDrawnShaft(bytes);
    Shaft shaft;
    io::ScanFile reference;
    if (is_drawn) {
        shaft = drawnShaft(bytes, path, first, answer);
        inputs.drop();
    } else {
        reference = readScan(path, bytes, withUnit(request, &CompareUnits::reference_unit), inputs, first, answer);
    }
    const io::ScanFile copy = readScan(request.operands.at(1), withUnit(request, &CompareUnits::copy_unit), inputs,
                                       progress.part(0.15, 0.3, reading), answer);
    const Progress comparing = progress.part(0.3, wanted ? 0.9 : 1, LT_TEXT("Engine", "Comparing"));
    const auto detail = request.in_full ? registration::CompareDetail::Full : registration::CompareDetail::Summary;
    const auto remark = [&](const Error& error) {
        const double reference_mm = is_drawn ? sizeOf_mm(shaft) : io::sizeOf_mm(reference.scan.points_mm);
        noteUnits(error, reference_mm, io::sizeOf_mm(copy.scan.points_mm), answer.notes);
    };
    const auto withShaft = [&] { return features::compareWithShaft(shaft, copy.scan, parameters, comparing, detail); };
    const auto withScan = [&] { return compare(reference.scan, copy.scan, parameters, comparing, detail); };
    const auto result = is_drawn ? answerShaft(compared(request, withShaft, remark), answer)
                                 : answerScan(compared(request, withScan, remark), answer);
    if (wanted)
        writeDeviations(deviations->second, copy.scan, *result,
                        progress.part(0.9, 1, LT_TEXT("Engine", "Writing deviations")));
}

}  // namespace

Verb compareVerb()
{
    return {"compare",
            "Compare a copy with its original or its drawing: alignment, signed surface deviation, sizes, verdict.",
            {{"REFERENCE",
              "The original: a point cloud or mesh; or its drawing: a STEP file or SHAFT.json (mm). A "
              "drawing adds the sizes row by row."},
             {"COPY", "The copy: a point cloud or mesh."}},
            compareOptions(),
            {&io::scanFiles()},
            {{deviationsOption, "Write every point of the copy with its deviation (FILE.ply or FILE.csv)."}},
            true,
            runCompare};
}

}  // namespace lathelier::cli
