#include "engine/features/report/recognized_rows.h"

#include <nlohmann/json.hpp>

#include "engine/core/units.h"

namespace lathelier::features {
namespace {

/// U of a row by the keys of SizeUncertainty.
std::vector<QuantityOf<RecognizedRow>> uncertainties()
{
    using R = RecognizedRow;
    const auto of = [](const char* name, std::optional<double> SizeUncertainty::*member, Text label, Text unit) {
        return quantity<R>(name, [member](const R& row) { return row.uncertainty.*member; }, {label, unit, 1});
    };
    return {of("uncertainty.z_start_um", &SizeUncertainty::z_start_um, LT_TEXT("Engine", "U of its start"), unit::um),
            of("uncertainty.z_end_um", &SizeUncertainty::z_end_um, LT_TEXT("Engine", "U of its end"), unit::um),
            of("uncertainty.length_um", &SizeUncertainty::length_um, LT_TEXT("Engine", "U of its length"), unit::um),
            of("uncertainty.start_diameter_um", &SizeUncertainty::start_diameter_um,
               LT_TEXT("Engine", "U of the start ⌀"), unit::um),
            of("uncertainty.end_diameter_um", &SizeUncertainty::end_diameter_um, LT_TEXT("Engine", "U of the end ⌀"),
               unit::um),
            of("uncertainty.arc_radius_um", &SizeUncertainty::arc_radius_um, LT_TEXT("Engine", "U of the radius"),
               unit::um),
            of("uncertainty.angle_deg", &SizeUncertainty::angle_deg, LT_TEXT("Engine", "U of the angle"), unit::deg)};
}

template <class T>
Json listOf(const std::vector<T>& items)
{
    Json list = Json::array();
    for (const T& item : items) list.push_back(nestedJson(describedValues(item)));
    return list;
}

Json rowsJson(const std::vector<RecognizedRow>& rows)
{
    Json list = Json::array();
    for (const RecognizedRow& row : rows) {
        Json one = nestedJson(describedValues(row));
        one["suggestions"] = Json::array();
        for (const Suggestion& suggestion : row.suggestions) {
            Json suggested = nestedJson(describedValues(suggestion));
            suggested["fits"] = suggestion.fits;
            suggested["agrees"] = suggestion.agrees;
            one["suggestions"].push_back(suggested);
        }
        list.push_back(one);
    }
    return list;
}

Json markJson(const ShaftMark& mark)
{
    Json one = Json::object();
    for (const auto& [name, value] : lathelier::toValues(mark))
        if (!std::holds_alternative<std::monostate>(value)) one[name] = lathelier::toJson(value);
    return one;
}

template <class V>
Json numbers(const V& vector)
{
    return Json{vector[0], vector[1], vector[2]};
}

Json sceneJson(const std::vector<SceneGroup>& groups)
{
    Json list = Json::array();
    for (const SceneGroup& group : groups) {
        Json one = nestedJson(describedValues(group));
        one["min_mm"] = numbers(group.min_mm);
        one["max_mm"] = numbers(group.max_mm);
        list.push_back(one);
    }
    return list;
}

}  // namespace

const char* key(RowKind kind)
{
    switch (kind) {
        case RowKind::Cylinder: return "cylinder";
        case RowKind::Cone: return "cone";
        case RowKind::Arc: return "arc";
    }
    return "";
}

const std::vector<QuantityOf<Suggestion>>& quantitiesOf(const Suggestion*)
{
    using S = Suggestion;
    static const auto all = describedBy<S>(
        quantity<S>("quantity", &S::quantity, {LT_TEXT("Engine", "Quantity")}),
        quantity<S>("measured_mm", &S::measured_mm, {LT_TEXT("Engine", "Measured"), unit::mm, 4}),
        quantity<S>("nominal_mm", &S::nominal_mm, {LT_TEXT("Engine", "Nominal"), unit::mm, 3}),
        quantity<S>("difference_um", &S::difference_um, {LT_TEXT("Engine", "Difference"), unit::um, 1}),
        quantity<S>("grid_mm", &S::grid_mm, {LT_TEXT("Engine", "Grid"), unit::mm, 2}),
        quantity<S>("chance_percent", &S::chance_percent, {LT_TEXT("Engine", "Chance"), unit::percent, 1}),
        quantity<S>("designation", &S::designation, {LT_TEXT("Engine", "Designation")}),
        quantity<S>("tolerance", &S::tolerance, {LT_TEXT("Engine", "Tolerance")}));
    return all;
}

const std::vector<QuantityOf<RecognizedRow>>& quantitiesOf(const RecognizedRow*)
{
    using R = RecognizedRow;
    static const auto all = describedBy<R>(
        quantity<R>("kind", [](const R& row) { return key(row.kind); }, {LT_TEXT("Engine", "Kind")}),
        quantity<R>("role", &R::role, {LT_TEXT("Engine", "Role")}),
        quantity<R>("z_start_mm", &R::z_start_mm, {LT_TEXT("Engine", "Start z"), unit::mm, 3}),
        quantity<R>("z_end_mm", &R::z_end_mm, {LT_TEXT("Engine", "End z"), unit::mm, 3}),
        quantity<R>("start_diameter_mm", &R::start_diameter_mm, {LT_TEXT("Engine", "Start ⌀"), unit::mm, 4}),
        quantity<R>("end_diameter_mm", &R::end_diameter_mm, {LT_TEXT("Engine", "End ⌀"), unit::mm, 4}),
        quantity<R>("arc_radius_mm", &R::arc_radius_mm, {LT_TEXT("Engine", "Arc radius"), unit::mm, 3}),
        quantity<R>("half_angle_deg", &R::half_angle_deg, {LT_TEXT("Engine", "Half angle"), unit::deg, 3}),
        quantity<R>("ties", &R::ties), quantity<R>("points", &R::points, {LT_TEXT("Engine", "Points")}),
        quantity<R>("coverage_deg", &R::coverage_deg, {LT_TEXT("Engine", "Seen of the circle"), unit::deg, 0}),
        quantity<R>("residual_um", &R::residual_um, {LT_TEXT("Engine", "Residual"), unit::um, 1}),
        quantity<R>("form_pv_um", &R::form_pv_um, {LT_TEXT("Engine", "Form"), unit::um, 1}),
        quantity<R>("taper_um", &R::taper_um, {LT_TEXT("Engine", "Taper of the radius"), unit::um, 1}),
        quantity<R>("offset_mm", [](const R& row) { return row.lobes.offset_mm; },
                    {LT_TEXT("Engine", "Off the axis"), unit::mm, 4}),
        quantity<R>("lobes", [](const R& row) { return row.lobes.lobes; }, {LT_TEXT("Engine", "Lobes")}),
        quantity<R>("lobes_um", [](const R& row) { return row.lobes.height_um; },
                    {LT_TEXT("Engine", "Height of the lobes"), unit::um, 1}),
        quantity<R>("fully_visible", &R::fully_visible), uncertainties());
    return all;
}

const std::vector<QuantityOf<RecognizedFeature>>& quantitiesOf(const RecognizedFeature*)
{
    using F = RecognizedFeature;
    static const auto all =
        describedBy<F>(quantity<F>("kind", &F::kind, {LT_TEXT("Engine", "Kind")}),
                       quantity<F>("z_start_mm", &F::z_start_mm, {LT_TEXT("Engine", "Start z"), unit::mm, 3}),
                       quantity<F>("z_end_mm", &F::z_end_mm, {LT_TEXT("Engine", "End z"), unit::mm, 3}),
                       quantity<F>("rows", &F::rows, {LT_TEXT("Engine", "Rows")}),
                       quantity<F>("designation", &F::designation, {LT_TEXT("Engine", "Designation")}));
    return all;
}

const std::vector<QuantityOf<RecognizedEnd>>& quantitiesOf(const RecognizedEnd*)
{
    using E = RecognizedEnd;
    static const auto all =
        describedBy<E>(quantity<E>("z_mm", &E::z_mm, {LT_TEXT("Engine", "z"), unit::mm, 3}),
                       quantity<E>("uncertainty_mm", &E::uncertainty_mm, {LT_TEXT("Engine", "U"), unit::mm, 3}),
                       quantity<E>("closed_by", &E::closed_by, {LT_TEXT("Engine", "Closed by")}),
                       quantity<E>("span_mm",
                                   [](const E& e) {
                                       return e.span_mm ? Value(std::vector{e.span_mm->from, e.span_mm->to}) : Value();
                                   },
                                   {LT_TEXT("Engine", "Lies between"), unit::mm, 3}));
    return all;
}

const std::vector<QuantityOf<Gap>>& quantitiesOf(const Gap*)
{
    static const auto all =
        describedBy<Gap>(quantity<Gap>("z_start_mm", &Gap::z_start_mm, {LT_TEXT("Engine", "Start z"), unit::mm, 3}),
                         quantity<Gap>("z_end_mm", &Gap::z_end_mm, {LT_TEXT("Engine", "End z"), unit::mm, 3}));
    return all;
}

const char* key(StructureKind kind)
{
    switch (kind) {
        case StructureKind::Raised: return "raised";
        case StructureKind::Sunken: return "sunken";
        case StructureKind::NoPoints: return "no_points";
        case StructureKind::Rough: return "rough";
        case StructureKind::Eccentric: return "eccentric";
    }
    return "";
}

const std::vector<QuantityOf<UnexplainedStructure>>& quantitiesOf(const UnexplainedStructure*)
{
    using U = UnexplainedStructure;
    static const auto all =
        describedBy<U>(quantity<U>("kind", [](const U& u) { return key(u.kind); }, {LT_TEXT("Engine", "Kind")}),
                       quantity<U>("z_start_mm", &U::z_start_mm, {LT_TEXT("Engine", "Start z"), unit::mm, 1}),
                       quantity<U>("z_end_mm", &U::z_end_mm, {LT_TEXT("Engine", "End z"), unit::mm, 1}),
                       quantity<U>("places", &U::places, {LT_TEXT("Engine", "Places")}),
                       quantity<U>("angle_deg", &U::angle_deg, {LT_TEXT("Engine", "Direction"), unit::deg, 0}),
                       quantity<U>("span_deg", &U::span_deg, {LT_TEXT("Engine", "Width"), unit::deg, 0}),
                       quantity<U>("area_mm2", &U::area_mm2, {LT_TEXT("Engine", "Area"), LT_TEXT("Engine", "mm²"), 1}),
                       quantity<U>("height_mm", &U::height_mm, {LT_TEXT("Engine", "Height"), unit::mm, 3}));
    return all;
}

const std::vector<QuantityOf<MergedJunction>>& quantitiesOf(const MergedJunction*)
{
    using M = MergedJunction;
    static const auto all =
        describedBy<M>(quantity<M>("z_mm", &M::z_mm, {LT_TEXT("Engine", "z"), unit::mm, 3}),
                       quantity<M>("step_um", &M::step_um, {LT_TEXT("Engine", "Step"), unit::um, 1}),
                       quantity<M>("angle_deg", &M::angle_deg, {LT_TEXT("Engine", "Bend"), unit::deg, 3}));
    return all;
}

Json toJson(const Recognition& result)
{
    Json json = Json::object();
    json["method_used"] = result.method_used;
    json["axis"] = {{"point_mm", numbers(result.axis_point_mm)}, {"direction", numbers(result.axis_direction)}};
    json["length_mm"] = nullptr;
    if (result.length_mm)
        json["length_mm"] = {{"value", *result.length_mm}, {"uncertainty", result.length_uncertainty_mm}};
    json["ends"] = listOf(result.ends);
    json["segments"] = rowsJson(result.segments);
    json["bores"] = Json::array();
    for (std::size_t i = 0; i < result.bores.size(); ++i)
        json["bores"].push_back(
            {{"from",
              i < result.shaft.bores.size() && result.shaft.bores[i].from == ShaftEnd::Chuck ? "chuck" : "free"},
             {"segments", rowsJson(result.bores[i])}});
    json["features"] = listOf(result.features);
    json["marks"] = Json::array();
    for (const ShaftMark& mark : result.marks) json["marks"].push_back(markJson(mark));
    json["unexplained"] = listOf(result.unexplained);
    json["gaps"] = listOf(result.gaps);
    json["scene"] = sceneJson(result.scene);
    json["merged"] = listOf(result.merged);
    json["coverage_percent"] = result.coverage_percent;
    json["residual_rmse_mm"] = result.residual_rmse_mm;
    json["chi2_per_bin"] = result.chi2_per_bin;
    json["spot_mm"] = result.spot_mm;
    json["noise_mm"] = result.noise_mm;
    json["variance_ratio"] = result.variance_ratio;
    json["passes_differ_um"] = result.passes_differ_um;
    json["volume_mm3"] = result.volume_mm3 ? Json(*result.volume_mm3) : Json(nullptr);
    if (result.parameters.method == RecognitionMethod::Paper) {
        json["steps"] = listOf(result.paper_steps);
        json["axis_off_robust_deg"] = result.paper_axis_off_deg;
    }
    json["points_used"] = result.points_used;
    json["complete"] = result.complete;
    return json;
}

}  // namespace lathelier::features
