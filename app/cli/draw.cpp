// draw SHAFT.json|PART.step|TABLE.csv: checks a shaft and writes it as drawing and CAD.
#include <nlohmann/json.hpp>

#include "app/cli/any_shaft.h"
#include "app/cli/shaft_outputs.h"
#include "app/cli/verbs.h"
#include "engine/io/json/json_locate.h"
#include "engine/shaft/shaft_contour.h"
#include "engine/shaft/shaft_rules.h"

namespace lathelier::cli {
namespace {

constexpr const char* checkKey = "check";

Json rowsOf(const Shaft& shaft)
{
    Json rows = Json::array();
    double z_mm = 0;
    for (const ShaftSegment& row : shaft.segments) {
        Json one = {{"kind", row.arc_radius_mm                              ? "arc"
                             : row.start_diameter_mm == row.end_diameter_mm ? "cylinder"
                                                                            : "cone"},
                    {"role", row.role},
                    {"z_start_mm", z_mm},
                    {"z_end_mm", z_mm + row.length_mm},
                    {"start_diameter_mm", row.start_diameter_mm},
                    {"end_diameter_mm", row.end_diameter_mm},
                    {"arc_radius_mm", row.arc_radius_mm ? Json(*row.arc_radius_mm) : Json(nullptr)}};
        z_mm += row.length_mm;
        rows.push_back(one);
    }
    return rows;
}

void runDraw(const Request& request, io::InputFiles& inputs, const Progress& progress, Answer& answer)
{
    const std::string& path = request.operands.at(0);
    auto json = std::make_shared<Json>(Json::object());
    Shaft shaft;
    try {
        shaft = readAnyShaft(inputs.open(path, progress.part(0, 0.1)), answer.notes, *json, progress.part(0.1, 0.6));
        const Notes remarks = checkShaft(shaft);
        answer.notes.insert(answer.notes.end(), remarks.begin(), remarks.end());
    } catch (Error& error) {
        io::locateRow(error, path);
        error.with("path", path);
        throw;
    }
    (*json)["name"] = shaft.name;
    (*json)["length_mm"] = shaft.length_mm();
    (*json)["volume_mm3"] = volume_mm3(shaft);
    (*json)["segments"] = rowsOf(shaft);
    (*json)["bores"] = static_cast<std::int64_t>(shaft.bores.size());
    (*json)["marks"] = static_cast<std::int64_t>(shaft.marks.size());
    (*json)["steps"] = stepsJson(shaft);
    answer.json = [json] { return *json; };
    answer.summary = shaftSummary(shaft);
    const Value* const only_check = find(request.parameters, checkKey);
    if (only_check && *only_check == Value(true)) return;
    writeShaftOutputs(request, {shaft}, progress.part(0.6, 1), answer);
}

}  // namespace

Verb drawVerb()
{
    FieldInfo check;
    check.key = checkKey;
    check.kind = FieldInfo::Kind::Flag;
    check.label = LT_TEXT("Engine", "Check only");
    check.help = LT_TEXT("Engine", "Check the shaft and write nothing.");
    std::vector<Option> options = cadOptions();
    options.push_back({check, false});
    return {"draw",
            "Check a shaft and write it as CAD, drawing and tables.",
            {{"SHAFT", "SHAFT.json, a STEP file of a turned part, or a table as CSV."}},
            options,
            {},
            shaftOutputs(),
            false,
            runDraw};
}

}  // namespace lathelier::cli
