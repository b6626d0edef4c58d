#include "engine/features/comparison/nominal_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/core/units.h"
#include "engine/features/comparison/row_matching.h"
#include "engine/features/comparison/rows_on_axis.h"
#include "engine/features/nominal/iso286.h"
#include "engine/features/nominal/standards.h"

namespace lathelier::features {
namespace {

using std::optional;

/// What was measured of a cylinder along a run of rows, or at one of its ends.
struct Size {
    optional<double> value_mm, smallest_mm, largest_mm, U_mm;
};

optional<double> in_mm(optional<double> um)
{
    return um ? optional(*um / 1000) : std::nullopt;
}

/// In the middle of a row, on its arc: the chord's middle and what the arc rises above it.
double middleDiameter(const RowOnAxis& row)
{
    const double chord = (row.start_diameter_mm + row.end_diameter_mm) / 2;
    if (!row.arc_radius_mm) return chord;
    const double half =
        std::hypot(row.z_end_mm - row.z_start_mm, (row.end_diameter_mm - row.start_diameter_mm) / 2) / 2;
    const double radius = std::abs(*row.arc_radius_mm);
    const double rise = radius - std::sqrt(std::max(0.0, radius * radius - half * half));
    return chord + std::copysign(2 * rise, *row.arc_radius_mm);
}

/// Over the length, by Simpson's rule: exact for cylinders and cones, and to a millionth for the crown of a seat.
Size meanDiameter(const RowsOnAxis& rows, RowRun run)
{
    if (run.count == 0) return {};
    double sum = 0, length = 0, U_um = 0;
    double smallest = std::numeric_limits<double>::infinity(), largest = 0;
    bool known = true;
    for (std::size_t i = run.first; i < run.first + run.count; ++i) {
        const RowOnAxis& row = rows[i];
        const double weight = row.z_end_mm - row.z_start_mm;
        const double middle = middleDiameter(row);
        sum += weight * (row.start_diameter_mm + 4 * middle + row.end_diameter_mm) / 6;
        length += weight;
        smallest = std::min({smallest, row.start_diameter_mm, middle, row.end_diameter_mm});
        largest = std::max({largest, row.start_diameter_mm, middle, row.end_diameter_mm});
        for (const auto& u : {row.uncertainty.start_diameter_um, row.uncertainty.end_diameter_um}) {
            known = known && u;
            U_um = std::max(U_um, u.value_or(0));
        }
    }
    return {sum / length, smallest, largest, known ? optional(U_um / 1000) : std::nullopt};
}

Size lengthOf(const RowsOnAxis& rows, RowRun run)
{
    if (run.count == 0) return {};
    const RowOnAxis &first = rows[run.first], &last = rows[run.first + run.count - 1];
    if (!first.start_seen || !last.end_seen) return {};
    optional<double> U_um = first.uncertainty.length_um;
    if (run.count > 1 || !U_um) {
        const auto &start = first.uncertainty.z_start_um, &end = last.uncertainty.z_end_um;
        U_um = start && end ? optional(std::hypot(*start, *end)) : std::nullopt;
    }
    return {last.z_end_mm - first.z_start_mm, {}, {}, in_mm(U_um)};
}

Size endDiameter(const RowsOnAxis& rows, RowRun run, bool start)
{
    if (run.count == 0) return {};
    const RowOnAxis& row = rows[start ? run.first : run.first + run.count - 1];
    const SizeUncertainty& u = row.uncertainty;
    return {start ? row.start_diameter_mm : row.end_diameter_mm,
            {},
            {},
            in_mm(start ? u.start_diameter_um : u.end_diameter_um)};
}

Size arcRadiusOf(const RowsOnAxis& rows, RowRun run, double nominal_mm)
{
    if (run.count != 1) return {};
    const optional<double>& radius = rows[run.first].arc_radius_mm;
    if (!radius || !rows[run.first].fully_visible || *radius * nominal_mm < 0) return {};
    return {std::abs(*radius), {}, {}, in_mm(rows[run.first].uncertainty.arc_radius_um)};
}

struct LimitDeviations {
    optional<double> lower_mm, upper_mm;
};

LimitDeviations plusMinus(optional<double> tolerance_mm)
{
    if (!tolerance_mm) return {};
    return {-*tolerance_mm, *tolerance_mm};
}

/// Limits of a row's own tolerance; none: not stated or not known.
optional<LimitDeviations> ownLimits(const optional<SizeTolerance>& tolerance, double nominal_mm)
{
    if (!tolerance) return {};
    if (!tolerance->iso_class.empty()) {
        const auto limits = limitsOf(tolerance->iso_class, nominal_mm);
        if (!limits) return {};
        return LimitDeviations{limits->lower_um / 1000, limits->upper_um / 1000};
    }
    if (!tolerance->lower_um && !tolerance->upper_um) return {};
    return LimitDeviations{in_mm(tolerance->lower_um), in_mm(tolerance->upper_um)};
}

/// The verdict of one local size.
Verdict judged(double deviation_mm, const optional<double>& U_mm, const ComparedRow& row, DecisionRule rule)
{
    double excess = -std::numeric_limits<double>::infinity();
    if (row.upper_mm) excess = std::max(excess, deviation_mm - *row.upper_mm);
    if (row.lower_mm) excess = std::max(excess, *row.lower_mm - deviation_mm);
    return judge(excess, U_mm.value_or(notANumber), 0, rule);
}

/// Makes the rows of one contour.
class Comparison {
public:
    Comparison(const Shaft& nominal, DecisionRule rule)
        : general_(parseGeneralTolerance(nominal.general_tolerance)), rule_(rule)
    {
    }

    void add(const RowOnAxis& drawn, const SizeTolerance* own, const std::string& role, bool hole,
             const RowsOnAxis& measured, RowRun run, optional<std::int64_t> bore)
    {
        row_ = static_cast<std::int64_t>(drawn.index) + 1;
        bore_ = bore;
        const double start = drawn.start_diameter_mm, end = drawn.end_diameter_mm;
        const bool chamfer = role == "chamfer";
        standard_ = role == "undercut";
        const optional<SizeTolerance> tolerance = own ? optional(*own) : std::nullopt;
        const auto limits = [&](double size_mm) {
            if (const auto stated = ownLimits(tolerance, size_mm)) return *stated;
            return chamfer ? LimitDeviations{} : general(size_mm);
        };
        // Ends in the order of the drawing's row, which a bore from the chuck's end turns round.
        const bool cylinder = start == end && !drawn.arc_radius_mm;
        if (cylinder) put("diameter", start, meanDiameter(measured, run), limits(start));
        if (!cylinder && !drawn.arc_radius_mm)
            for (const bool first : {true, false}) {
                const bool at_start = first != turned_;
                const double size = at_start ? start : end;
                put(first ? "start_diameter" : "end_diameter", size, endDiameter(measured, run, at_start),
                    limits(size));
            }
        const double length = drawn.z_end_mm - drawn.z_start_mm;
        LimitDeviations along = drawn.arc_radius_mm ? LimitDeviations{} : general(length);
        if (chamfer) along = edge(length);
        put("length", length, lengthOf(measured, run), along);
        if (!drawn.arc_radius_mm) return;
        const double radius = std::abs(*drawn.arc_radius_mm);
        const bool outer = (*drawn.arc_radius_mm > 0) != hole;
        put("arc_radius", radius, arcRadiusOf(measured, run, *drawn.arc_radius_mm),
            outer ? edge(radius) : general(radius));
    }

    /// Rows that follow are those of a bore whose mouth is at the chuck's end.
    void turn(bool turned) { turned_ = turned; }
    std::vector<ComparedRow> take() { return std::move(rows_); }

private:
    LimitDeviations general(double size_mm) const
    {
        return general_ && !standard_ ? plusMinus(generalTolerance_mm(size_mm, *general_)) : LimitDeviations{};
    }
    LimitDeviations edge(double size_mm) const
    {
        return general_ && !standard_ ? plusMinus(generalEdgeTolerance_mm(size_mm, *general_)) : LimitDeviations{};
    }

    void put(const char* quantity, double nominal_mm, const Size& size, const LimitDeviations& limits)
    {
        ComparedRow one;
        one.row = row_;
        one.bore = bore_;
        one.quantity = quantity;
        one.nominal_mm = nominal_mm;
        one.lower_mm = limits.lower_mm;
        one.upper_mm = limits.upper_mm;
        one.measured_mm = size.value_mm;
        one.smallest_mm = size.smallest_mm;
        one.largest_mm = size.largest_mm;
        if (size.U_mm && *size.U_mm < nominal_mm) one.uncertainty_mm = size.U_mm;  // beyond that range it has no value
        if (size.value_mm) one.deviation_mm = *size.value_mm - nominal_mm;
        const bool limited = one.lower_mm || one.upper_mm;
        if (limited && !size.value_mm) one.verdict = Verdict::Undecided;
        if (limited)
            for (const auto& local : {size.value_mm, size.smallest_mm, size.largest_mm})
                if (local) {
                    const Verdict here = judged(*local - nominal_mm, one.uncertainty_mm, one, rule_);
                    one.verdict = one.verdict ? worse(*one.verdict, here) : here;
                }
        rows_.push_back(std::move(one));
    }

    optional<GeneralClass> general_;
    DecisionRule rule_;
    std::int64_t row_ = 0;
    optional<std::int64_t> bore_;
    bool turned_ = false;
    bool standard_ = false;  ///< the row of an undercut, whose limits are those of its standard
    std::vector<ComparedRow> rows_;
};

}  // namespace

std::vector<ComparedRow> compareRows(const Shaft& nominal, const Recognition& measured, DecisionRule decision,
                                     const std::optional<Eigen::Isometry3d>& nominal_T_part)
{
    const RowsOnAxis drawn = drawnRows(nominal.segments, 0, 1);
    Placing placing;
    RowMatch match;
    bool any = false;
    for (const Placing& tried : placings(nominal, measured, nominal_T_part)) {
        RowMatch found = matchRows(drawn, placed(measured.segments, tried, endsSeen(measured)));
        if (any && !(found.cost_mm < match.cost_mm)) continue;
        any = true;
        match = std::move(found);
        placing = tried;
    }
    Comparison comparison(nominal, decision);
    const RowsOnAxis outside = placed(measured.segments, placing, endsSeen(measured));
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        const ShaftSegment& row = nominal.segments[drawn[i].index];
        comparison.add(drawn[i], row.tolerance ? &*row.tolerance : nullptr, row.role, false, outside, match.runs[i],
                       {});
    }
    const RowsOnAxis inside = placedBores(measured, placing);
    const std::vector<ShaftBore> bores = drawnBores(nominal);
    for (std::size_t number = 0; number < bores.size(); ++number) {
        const ShaftBore& bore = bores[number];
        const bool free = bore.from == ShaftEnd::Free;
        RowsOnAxis rows = drawnRows(bore.segments, free ? 0 : nominal.length_mm(), free ? 1 : -1);
        std::vector<RowRun> runs = matchRows(rows, inside).runs;
        if (!free) {
            std::reverse(rows.begin(), rows.end());
            std::reverse(runs.begin(), runs.end());
        }
        comparison.turn(!free);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const BoreSegment& row = bore.segments[rows[i].index];
            comparison.add(rows[i], row.tolerance ? &*row.tolerance : nullptr, row.role, true, inside, runs[i],
                           static_cast<std::int64_t>(number) + 1);
        }
    }
    return comparison.take();
}

std::optional<Verdict> worstVerdict(const std::vector<ComparedRow>& rows)
{
    std::optional<Verdict> worst;
    for (const ComparedRow& row : rows)
        if (row.verdict) worst = worst ? worse(*worst, *row.verdict) : *row.verdict;
    return worst;
}

Text quantityName(const ComparedRow& row)
{
    if (row.quantity == "diameter") return LT_TEXT("Engine", "diameter");
    if (row.quantity == "start_diameter") return LT_TEXT("Engine", "diameter at the start");
    if (row.quantity == "end_diameter") return LT_TEXT("Engine", "diameter at the end");
    if (row.quantity == "length") return LT_TEXT("Engine", "length");
    return LT_TEXT("Engine", "radius");
}

const std::vector<QuantityOf<ComparedRow>>& quantitiesOf(const ComparedRow*)
{
    using C = ComparedRow;
    static const std::vector<QuantityOf<C>> all{
        quantity<C>("row", &C::row, {LT_TEXT("Engine", "Row")}),
        quantity<C>("bore", &C::bore, {LT_TEXT("Engine", "Bore")}),
        quantity<C>("quantity", &C::quantity),
        quantity<C>("named", quantityName, {LT_TEXT("Engine", "Quantity"), {}, 0, false}),
        quantity<C>("nominal_mm", &C::nominal_mm, {LT_TEXT("Engine", "Nominal"), unit::mm, 3}),
        quantity<C>("measured_mm", &C::measured_mm, {LT_TEXT("Engine", "Measured"), unit::mm, 4}),
        quantity<C>("smallest_mm", &C::smallest_mm, {LT_TEXT("Engine", "Smallest"), unit::mm, 4}),
        quantity<C>("largest_mm", &C::largest_mm, {LT_TEXT("Engine", "Largest"), unit::mm, 4}),
        quantity<C>("deviation_mm", &C::deviation_mm, {LT_TEXT("Engine", "Deviation"), unit::mm, 4}),
        quantity<C>("uncertainty_mm", &C::uncertainty_mm, {LT_TEXT("Engine", "U (k = 2)"), unit::mm, 4}),
        quantity<C>("lower_mm", &C::lower_mm, {LT_TEXT("Engine", "Lower limit"), unit::mm, 3}),
        quantity<C>("upper_mm", &C::upper_mm, {LT_TEXT("Engine", "Upper limit"), unit::mm, 3}),
        quantity<C>("verdict", verdictKey<C>),
        quantity<C>("judged", verdictName<C>, {LT_TEXT("Engine", "Verdict"), {}, 0, false})};
    return all;
}

}  // namespace lathelier::features
