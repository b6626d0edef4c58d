#include "engine/features/recognition_quantities.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace lathelier::features {
namespace {

const Text mm = LT_TEXT("Engine", "mm");
const Text um = LT_TEXT("Engine", "µm");
const Text degree = LT_TEXT("Engine", "°");
const Text percent = LT_TEXT("Engine", "%");

const char* keyOf(RowKind kind)
{
    switch (kind) {
        case RowKind::Cylinder: return "cylinder";
        case RowKind::Cone: return "cone";
        case RowKind::Arc: return "arc";
    }
    return "";
}

Value named(const std::string& key, const std::vector<std::pair<const char*, Text>>& names)
{
    const auto found = std::find_if(names.begin(), names.end(), [&key](const auto& name) { return key == name.first; });
    return found == names.end() ? Value(key) : Value(found->second);
}

Rows valuesOf(const std::vector<ShaftMark>& marks)
{
    Rows rows;
    for (const ShaftMark& mark : marks) rows.rows.push_back({toValues(mark)});
    return rows;
}

Value listOf(const std::vector<std::string>& words)
{
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
    return text;
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
                        {"sphere", LT_TEXT("Engine", "sphere")},
                        {"keyway", LT_TEXT("Engine", "keyway")},
                        {"flat", LT_TEXT("Engine", "flat")},
                        {"cross_hole", LT_TEXT("Engine", "cross hole")},
                        {"free_form", LT_TEXT("Engine", "free form")}});
}

Value endName(const std::string& closed_by)
{
    return named(closed_by, {{"face", LT_TEXT("Engine", "face")},
                             {"chamfer", LT_TEXT("Engine", "chamfer")},
                             {"round", LT_TEXT("Engine", "round")},
                             {"edge", LT_TEXT("Engine", "edge")},
                             {"data", LT_TEXT("Engine", "end of the data")}});
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

const std::vector<QuantityOf<Suggestion>>& quantitiesOf(const Suggestion*)
{
    using S = Suggestion;
    static const auto all = describedBy<S>(
        quantity<S>("quantity", &S::quantity), quantity<S>("measured_mm", &S::measured_mm),
        quantity<S>("nominal_mm", &S::nominal_mm), quantity<S>("difference_um", &S::difference_um),
        quantity<S>("grid_mm", &S::grid_mm), quantity<S>("chance_percent", &S::chance_percent),
        quantity<S>("fits", [](const S& s) { return listOf(s.fits); }), quantity<S>("designation", &S::designation));
    return all;
}

const std::vector<QuantityOf<RecognizedRow>>& quantitiesOf(const RecognizedRow*)
{
    using R = RecognizedRow;
    const auto of = [](std::optional<double> SizeUncertainty::*member) {
        return [member](const R& row) { return row.uncertainty.*member; };
    };
    using U = SizeUncertainty;
    static const auto all = describedBy<R>(
        quantity<R>("kind", [](const R& row) { return keyOf(row.kind); }),
        quantity<R>("kind_name", [](const R& row) { return kindName(row.kind); },
                    {LT_TEXT("Engine", "Kind"), {}, 0, false}),
        quantity<R>("role", &R::role),
        quantity<R>("role_name", [](const R& row) { return roleName(row.role); },
                    {LT_TEXT("Engine", "Role"), {}, 0, false}),
        quantity<R>("z_start_mm", &R::z_start_mm, {LT_TEXT("Engine", "z from"), mm, 4}),
        quantity<R>("z_end_mm", &R::z_end_mm, {LT_TEXT("Engine", "z to"), mm, 4}),
        quantity<R>("start_diameter_mm", &R::start_diameter_mm, {LT_TEXT("Engine", "⌀ at its start"), mm, 4}),
        quantity<R>("end_diameter_mm", &R::end_diameter_mm, {LT_TEXT("Engine", "⌀ at its end"), mm, 4}),
        quantity<R>("arc_radius_mm", &R::arc_radius_mm, {LT_TEXT("Engine", "Radius"), mm, 4}),
        quantity<R>("half_angle_deg", &R::half_angle_deg, {LT_TEXT("Engine", "Half angle"), degree, 3}),
        quantity<R>("ties", &R::ties), quantity<R>("points", &R::points, {LT_TEXT("Engine", "Points"), {}, 0}),
        quantity<R>("coverage_deg", &R::coverage_deg, {LT_TEXT("Engine", "Seen of the circle"), degree, 0}),
        quantity<R>("residual_um", &R::residual_um, {LT_TEXT("Engine", "Residual (RMS)"), um, 2}),
        quantity<R>("form_pv_um", &R::form_pv_um, {LT_TEXT("Engine", "Form, peak to valley"), um, 1}),
        quantity<R>("taper_um", &R::taper_um, {LT_TEXT("Engine", "Change of the radius along it"), um, 1}),
        quantity<R>("fully_visible", &R::fully_visible),
        quantity<R>("uncertainty.z_start_um", of(&U::z_start_um), {LT_TEXT("Engine", "± of its start"), um, 2}),
        quantity<R>("uncertainty.z_end_um", of(&U::z_end_um), {LT_TEXT("Engine", "± of its end"), um, 2}),
        quantity<R>("uncertainty.length_um", of(&U::length_um), {LT_TEXT("Engine", "± of its length"), um, 2}),
        quantity<R>("uncertainty.start_diameter_um", of(&U::start_diameter_um),
                    {LT_TEXT("Engine", "± of ⌀ at its start"), um, 2}),
        quantity<R>("uncertainty.end_diameter_um", of(&U::end_diameter_um),
                    {LT_TEXT("Engine", "± of ⌀ at its end"), um, 2}),
        quantity<R>("uncertainty.arc_radius_um", of(&U::arc_radius_um), {LT_TEXT("Engine", "± of the radius"), um, 2}),
        quantity<R>("uncertainty.angle_deg", of(&U::angle_deg), {LT_TEXT("Engine", "± of the angle"), degree, 3}),
        quantity<R>("suggestions", [](const R& row) { return listed(row.suggestions); }));
    return all;
}

const std::vector<QuantityOf<RecognizedFeature>>& quantitiesOf(const RecognizedFeature*)
{
    using F = RecognizedFeature;
    static const auto all = describedBy<F>(
        quantity<F>("kind", &F::kind),
        quantity<F>("kind_name", [](const F& f) { return roleName(f.kind); },
                    {LT_TEXT("Engine", "Feature"), {}, 0, false}),
        quantity<F>("z_start_mm", &F::z_start_mm, {LT_TEXT("Engine", "z from"), mm, 3}),
        quantity<F>("z_end_mm", &F::z_end_mm, {LT_TEXT("Engine", "z to"), mm, 3}), quantity<F>("rows", &F::rows),
        quantity<F>("row_numbers", &F::rows, {LT_TEXT("Engine", "Rows"), {}, 0, false}),
        quantity<F>("designation", &F::designation, {LT_TEXT("Engine", "Designation"), {}, 0}));
    return all;
}

const std::vector<QuantityOf<RecognizedEnd>>& quantitiesOf(const RecognizedEnd*)
{
    using E = RecognizedEnd;
    static const auto all =
        describedBy<E>(quantity<E>("z_mm", &E::z_mm, {LT_TEXT("Engine", "z"), mm, 4}),
                       quantity<E>("uncertainty_mm", &E::uncertainty_mm, {LT_TEXT("Engine", "± (k = 2)"), mm, 4}),
                       quantity<E>("closed_by", &E::closed_by),
                       quantity<E>("closed_by_name", [](const E& e) { return endName(e.closed_by); },
                                   {LT_TEXT("Engine", "Closed by"), {}, 0, false}));
    return all;
}

const std::vector<QuantityOf<Gap>>& quantitiesOf(const Gap*)
{
    static const auto all =
        describedBy<Gap>(quantity<Gap>("z_start_mm", &Gap::z_start_mm, {LT_TEXT("Engine", "z from"), mm, 3}),
                         quantity<Gap>("z_end_mm", &Gap::z_end_mm, {LT_TEXT("Engine", "z to"), mm, 3}));
    return all;
}

const std::vector<QuantityOf<MergedJunction>>& quantitiesOf(const MergedJunction*)
{
    using J = MergedJunction;
    static const auto all =
        describedBy<J>(quantity<J>("z_mm", &J::z_mm, {LT_TEXT("Engine", "z"), mm, 3}),
                       quantity<J>("step_um", &J::step_um, {LT_TEXT("Engine", "Step of the radius"), um, 1}),
                       quantity<J>("angle_deg", &J::angle_deg, {LT_TEXT("Engine", "Bend"), degree, 4}));
    return all;
}

const std::vector<QuantityOf<PaperStep>>& quantitiesOf(const PaperStep*)
{
    using S = PaperStep;
    static const auto all = describedBy<S>(
        quantity<S>("row", &S::row, {LT_TEXT("Engine", "Row"), {}, 0, false}),
        quantity<S>("x_mm", &S::x_mm, {LT_TEXT("Engine", "x"), mm, 4}),
        quantity<S>("y_mm", &S::y_mm, {LT_TEXT("Engine", "y"), mm, 4}),
        quantity<S>("radius_mm", &S::radius_mm, {LT_TEXT("Engine", "Radius"), mm, 4}),
        quantity<S>("z_start_mm", &S::z_start_mm, {LT_TEXT("Engine", "z from"), mm, 3}),
        quantity<S>("z_end_mm", &S::z_end_mm, {LT_TEXT("Engine", "z to"), mm, 3}),
        quantity<S>("chamfer_start_mm", &S::chamfer_start_mm, {LT_TEXT("Engine", "Chamfer, start"), mm, 3}),
        quantity<S>("chamfer_end_mm", &S::chamfer_end_mm, {LT_TEXT("Engine", "Chamfer, end"), mm, 3}));
    return all;
}

const std::vector<QuantityOf<Recognition>>& quantitiesOf(const Recognition*)
{
    using R = Recognition;
    const QuantityOf<R> length{{"length_mm", {}, {}, 0, true, true, {}},
                               [](const R& r) -> Value { return r.length_mm.has_value(); }};
    static const auto all = describedBy<R>(
        quantity<R>("method_used", &R::method_used), quantity<R>("axis.point_mm", &R::axis_point_mm),
        quantity<R>("axis.direction", &R::axis_direction), length,
        quantity<R>("length_mm.value", &R::length_mm, {LT_TEXT("Engine", "Length"), mm, 4}),
        quantity<R>("length_mm.uncertainty",
                    [](const R& r) { return r.length_mm ? Value(r.length_uncertainty_mm) : Value(); },
                    {LT_TEXT("Engine", "Its expanded uncertainty (k = 2)"), mm, 4}),
        quantity<R>("largest_diameter_mm",
                    [](const R& r) {
                        const auto largest = largestDiameter(r);
                        return largest ? Value(largest->diameter_mm) : Value();
                    },
                    {LT_TEXT("Engine", "Largest diameter"), mm, 4, false}),
        quantity<R>("row_count", [](const R& r) { return static_cast<std::int64_t>(r.segments.size()); },
                    {LT_TEXT("Engine", "Rows"), {}, 0, false}),
        quantity<R>("ends", [](const R& r) { return listed(r.ends); }),
        quantity<R>("steps", [](const R& r) { return listed(paperTable(r).steps); }),
        quantity<R>("segments", [](const R& r) { return listed(r.segments); }),
        quantity<R>("bores",
                    [](const R& r) {
                        Rows rows;
                        for (const auto& bore : r.bores)
                            for (Row& row : listed(bore).rows) rows.rows.push_back(std::move(row));
                        return rows;
                    }),
        quantity<R>("features", [](const R& r) { return listed(r.features); }),
        quantity<R>("marks", [](const R& r) { return valuesOf(r.marks); }),
        quantity<R>("gaps", [](const R& r) { return listed(r.gaps); }),
        quantity<R>("merged", [](const R& r) { return listed(r.merged); }),
        quantity<R>("coverage_percent", &R::coverage_percent,
                    {LT_TEXT("Engine", "Share of the length that rows cover"), percent, 1}),
        quantity<R>("residual_rmse_mm", &R::residual_rmse_mm,
                    {LT_TEXT("Engine", "Residual of the meridian (RMS)"), mm, 5}),
        quantity<R>("chi2_per_bin", &R::chi2_per_bin, {LT_TEXT("Engine", "χ² per bin"), {}, 2}),
        quantity<R>("spot_mm", &R::spot_mm, {LT_TEXT("Engine", "Width that edges are blurred by"), mm, 3}),
        quantity<R>("noise_mm", &R::noise_mm, {LT_TEXT("Engine", "Noise of single points"), mm, 4}),
        quantity<R>("volume_mm3", &R::volume_mm3, {LT_TEXT("Engine", "Volume"), LT_TEXT("Engine", "mm³"), 1}),
        quantity<R>("points_used", &R::points_used, {LT_TEXT("Engine", "Points"), {}, 0}));
    return all;
}

}  // namespace lathelier::features
