#include <cmath>

#include "engine/form/roundness_report.h"
#include "engine/io/io_codes.h"
#include "engine/report/cells.h"
#include "engine/report/parameters_table.h"

namespace lathelier::form {
namespace {

const Text mm = LT_TEXT("Engine", "mm");
const Text um = LT_TEXT("Engine", "µm");

QuantityTable deviationsTable(const CylindricityResult& result)
{
    QuantityTable table{LT_TEXT("Engine", "Cylindricity"),
                        {{"CYLt(MZCY)", result.MZCY.CYLt_um, um},
                         {"CYLt(LSCY)", result.LSCY.CYLt_um, um},
                         {"CYLp(LSCY)", result.LSCY.CYLp_um, um},
                         {"CYLv(LSCY)", result.LSCY.CYLv_um, um},
                         {"CYLq(LSCY)", result.LSCY.CYLq_um, um}}};
    if (std::isfinite(result.axis_straightness_um))
        table.rows.push_back(
            {LT_TEXT("Engine", "Straightness of the axis of the sections"), result.axis_straightness_um, um});
    table.rows.push_back({LT_TEXT("Engine", "Radius (least squares)"), result.LSCY.radius_mm, mm, 5});
    table.rows.push_back({LT_TEXT("Engine", "Length"), result.length_mm, mm});
    table.rows.push_back({LT_TEXT("Engine", "Points"), static_cast<std::int64_t>(result.points), {}});
    return table;
}

QuantityTable verdictTable(const CylindricityResult& result)
{
    QuantityTable table{LT_TEXT("Engine", "Verdict"), {}};
    Value verdict = LT_TEXT("Engine", "none: no tolerance was given");
    if (result.verdict) verdict = verdictName(*result.verdict);
    table.rows.push_back({LT_TEXT("Engine", "Verdict"), verdict, {}});
    if (result.parameters.tolerance_um)
        table.rows.push_back({LT_TEXT("Engine", "Tolerance"), *result.parameters.tolerance_um, um});
    return table;
}

Table axesTable(const CylindricityResult& result)
{
    Table table{
        LT_TEXT("Engine", "Axes"),
        {LT_TEXT("Engine", "cylinder"), LT_TEXT("Engine", "x (mm)"), LT_TEXT("Engine", "y (mm)"),
         LT_TEXT("Engine", "z (mm)"), LT_TEXT("Engine", "direction x"), LT_TEXT("Engine", "y"), LT_TEXT("Engine", "z")},
        {},
        {0, 5, 5, 5, 9, 9, 9}};
    const auto add = [&table](const char* name, const FittedCylinder& cylinder) {
        const Eigen::Vector3d& p = cylinder.axis_point_mm;
        const Eigen::Vector3d& d = cylinder.axis_direction;
        table.rows.push_back({std::string(name), p.x(), p.y(), p.z(), d.x(), d.y(), d.z()});
    };
    add("LSCY", result.LSCY);
    add("MZCY", result.MZCY);
    return table;
}

}  // namespace

Headline headline(const CylindricityResult& result, const Language& language)
{
    Headline answer;
    answer.text = "CYLt(MZCY) " + fixed(result.MZCY.CYLt_um, 2, language) + " µm · CYLt(LSCY) " +
                  fixed(result.LSCY.CYLt_um, 2, language) + " µm";
    answer.text = keptTogether(answer.text);
    if (!result.verdict || !result.parameters.tolerance_um) return answer;
    const Text words = *result.verdict == FormVerdict::Pass   ? LT_TEXT("Engine", "within {tolerance} µm")
                       : *result.verdict == FormVerdict::Fail ? LT_TEXT("Engine", "above {tolerance} µm")
                                                              : LT_TEXT("Engine", "? not decided at {tolerance} µm");
    answer.text +=
        keptTogether(" · " + fill(text(words, language), {{"tolerance", *result.parameters.tolerance_um}}, language));
    if (*result.verdict != FormVerdict::Undecided) answer.verdict = *result.verdict == FormVerdict::Pass;
    return answer;
}

Section cylindricitySummary(const CylindricityResult& result, const Language& language)
{
    Section section{LT_TEXT("Engine", "Result"),
                    {headline(result, language), deviationsTable(result), verdictTable(result)}};
    if (!result.notes.empty()) section.blocks.push_back(result.notes);
    return section;
}

Document cylindricityReport(const CylindricityResult& result, const std::vector<InputFile>& inputs,
                            const Language& language)
{
    Document document;
    document.title = LT_TEXT("Engine", "Cylindricity");
    document.inputs = inputs;
    document.synthetic = contains(result.notes, notes::syntheticData);
    document.sections = {
        cylindricitySummary(result, language),
        {LT_TEXT("Engine", "Method and parameters"),
         {Paragraph{LT_TEXT("Engine",
                            "ISO 12180: CYLt is the largest minus the smallest distance of the points from the axis of "
                            "the reference cylinder. The minimum zone is locally optimal, found from several starts."),
                    {}},
          axesTable(result), parametersTable(result.parameters, language)}}};
    return document;
}

}  // namespace lathelier::form
