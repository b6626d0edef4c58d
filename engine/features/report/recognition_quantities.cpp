#include "engine/features/report/recognition_quantities.h"

#include <algorithm>

#include "engine/core/units.h"

namespace lathelier::features {
namespace {

Value named(const std::string& key, const std::vector<std::pair<const char*, Text>>& names)
{
    const auto found = std::find_if(names.begin(), names.end(), [&key](const auto& name) { return key == name.first; });
    return found == names.end() ? Value(key) : Value(found->second);
}

}  // namespace

Text kindName(RowKind kind)
{
    switch (kind) {
        case RowKind::Cylinder: return LT_TEXT("Engine", "cylinder");
        case RowKind::Cone: return LT_TEXT("Engine", "cone");
        case RowKind::Arc: return LT_TEXT("Engine", "arc");
    }
    return {};
}

Text structureName(StructureKind kind)
{
    switch (kind) {
        case StructureKind::Raised: return LT_TEXT("Engine", "raised");
        case StructureKind::Sunken: return LT_TEXT("Engine", "sunken");
        case StructureKind::NoPoints: return LT_TEXT("Engine", "without points");
        case StructureKind::Rough: return LT_TEXT("Engine", "rough");
        case StructureKind::Eccentric: return LT_TEXT("Engine", "eccentric");
    }
    return {};
}

Value roleName(const std::string& role)
{
    return named(role, {{"chamfer", LT_TEXT("Engine", "chamfer")},
                        {"fillet", LT_TEXT("Engine", "fillet")},
                        {"edge_round", LT_TEXT("Engine", "rounded edge")},
                        {"edge_break", LT_TEXT("Engine", "broken edge")},
                        {"shoulder", LT_TEXT("Engine", "shoulder")},
                        {"groove", LT_TEXT("Engine", "groove")},
                        {"undercut", LT_TEXT("Engine", "undercut")},
                        {"thread", LT_TEXT("Engine", "thread")},
                        {"knurl", LT_TEXT("Engine", "knurl")},
                        {"taper", LT_TEXT("Engine", "tapered stretch")},
                        {"saddle", LT_TEXT("Engine", "saddle")},
                        {"sphere", LT_TEXT("Engine", "sphere")}});
}

Value endName(const std::string& closed_by)
{
    return named(closed_by, {{"face", LT_TEXT("Engine", "face")},
                             {"chamfer", LT_TEXT("Engine", "chamfer")},
                             {"round", LT_TEXT("Engine", "round")},
                             {"edge", LT_TEXT("Engine", "edge")},
                             {"data", LT_TEXT("Engine", "end of the data")},
                             {"undecided", LT_TEXT("Engine", "undecided")}});
}

std::optional<LargestDiameter> largestDiameter(const Recognition& result)
{
    std::optional<LargestDiameter> largest;
    const auto look = [&largest](double diameter_mm, const std::optional<double>& uncertainty_um, std::size_t row) {
        if (!largest || diameter_mm > largest->diameter_mm) largest = {diameter_mm, uncertainty_um, row};
    };
    for (std::size_t i = 0; i < result.segments.size(); ++i) {
        const RecognizedRow& row = result.segments[i];
        look(row.start_diameter_mm, row.uncertainty.start_diameter_um, i);
        look(row.end_diameter_mm, row.uncertainty.end_diameter_um, i);
    }
    return largest;
}

const std::vector<QuantityOf<Recognition>>& quantitiesOf(const Recognition*)
{
    using R = Recognition;
    static const auto all = describedBy<R>(
        quantity<R>("length_mm", &R::length_mm, {LT_TEXT("Engine", "Length"), unit::mm, 4}),
        quantity<R>("length_uncertainty_mm",
                    [](const R& r) { return r.length_mm ? Value(r.length_uncertainty_mm) : Value(); },
                    {LT_TEXT("Engine", "Its expanded uncertainty (k = 2)"), unit::mm, 4}),
        quantity<R>("largest_diameter_mm",
                    [](const R& r) {
                        const auto largest = largestDiameter(r);
                        return largest ? Value(largest->diameter_mm) : Value();
                    },
                    {LT_TEXT("Engine", "Largest diameter"), unit::mm, 4}),
        quantity<R>("coverage_percent", &R::coverage_percent,
                    {LT_TEXT("Engine", "Share of the length that rows cover"), unit::percent, 1}),
        quantity<R>("residual_rmse_mm", &R::residual_rmse_mm,
                    {LT_TEXT("Engine", "Residual of the meridian (RMS)"), unit::mm, 5}),
        quantity<R>("chi2_per_bin", &R::chi2_per_bin, {LT_TEXT("Engine", "χ² per bin"), {}, 2}),
        quantity<R>("spot_mm", &R::spot_mm, {LT_TEXT("Engine", "Width that edges are blurred by"), unit::mm, 3}),
        quantity<R>("noise_mm", &R::noise_mm, {LT_TEXT("Engine", "Noise of single points"), unit::mm, 4}),
        quantity<R>("variance_ratio", &R::variance_ratio,
                    {LT_TEXT("Engine", "Variance of a row's mean over that of independent points"), {}, 1}),
        quantity<R>("passes_differ_um", &R::passes_differ_um,
                    {LT_TEXT("Engine", "Half of the difference between passes, on the radius"), unit::um, 1}),
        quantity<R>("volume_mm3", &R::volume_mm3, {LT_TEXT("Engine", "Volume"), unit::mm3, 1}),
        quantity<R>("points_used", &R::points_used, {LT_TEXT("Engine", "Points"), {}, 0}));
    return all;
}

}  // namespace lathelier::features
