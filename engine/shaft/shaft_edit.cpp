#include "engine/shaft/shaft_edit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/units.h"
#include "engine/shaft/shaft_codes.h"
#include "engine/shaft/shaft_contour.h"

namespace lathelier {
namespace {

constexpr double minorLengthShare = 0.15;
constexpr double openConeSlope = 0.1;     // of a cone whose neighbours do not determine it: diameter over length
constexpr double grooveDepthShare = 0.5;  // of a groove's width

std::ptrdiff_t at(std::size_t row)
{
    return static_cast<std::ptrdiff_t>(row);
}

/// Weighted by lengths; of two planes half of each.
double mean(double a, double b, double weight_a, double weight_b)
{
    const double sum = weight_a + weight_b;
    return sum > 0 ? (a * weight_a + b * weight_b) / sum : (a + b) / 2;
}

std::optional<double> mean(const std::optional<double>& a, const std::optional<double>& b, double weight_a,
                           double weight_b)
{
    return a && b ? std::optional(mean(*a, *b, weight_a, weight_b)) : std::nullopt;
}

std::optional<MeasuredSize> joined(const ShaftSegment& a, const ShaftSegment& b, bool cylinder)
{
    if (!a.measured || !b.measured) return std::nullopt;
    MeasuredSize both;
    if (a.measured->length_mm && b.measured->length_mm)
        both.length_mm = *a.measured->length_mm + *b.measured->length_mm;
    both.start_diameter_mm =
        cylinder ? mean(a.measured->start_diameter_mm, b.measured->start_diameter_mm, a.length_mm, b.length_mm)
                 : a.measured->start_diameter_mm;
    both.end_diameter_mm = cylinder ? both.start_diameter_mm : b.measured->end_diameter_mm;
    return both;
}

/// Index of the neighbour that is lengthened when the row is deleted.
std::size_t rowToLengthen(const ShaftRows& rows, std::size_t row)
{
    if (row == 0) return 1;
    if (row + 1 == rows.size()) return row - 1;
    const ShaftSegment &before = rows[row - 1], &after = rows[row + 1];
    const bool goes_on_before = isCylinder(before) && isSameSize(before.end_diameter_mm, rows[row].start_diameter_mm);
    const bool goes_on_after = isCylinder(after) && isSameSize(after.start_diameter_mm, rows[row].end_diameter_mm);
    if (goes_on_before != goes_on_after) return goes_on_before ? row - 1 : row + 1;
    return isMinorRow(before) && !isMinorRow(after) ? row + 1 : row - 1;
}

/// Diameters at the ends of a row, from its neighbours.
void meetNeighbours(const ShaftRows& rows, std::size_t row, ShaftSegment& made)
{
    const double own = (rows[row].start_diameter_mm + rows[row].end_diameter_mm) / 2;
    made.start_diameter_mm = row > 0 ? rows[row - 1].end_diameter_mm : own;
    made.end_diameter_mm = row + 1 < rows.size() ? rows[row + 1].start_diameter_mm : own;
}

/// The row falls toward the nearer end of the part by so much on the diameter, its larger one stays.
void fall(const ShaftRows& rows, std::size_t row, double by_mm, ShaftSegment& made)
{
    const double large = std::max(rows[row].start_diameter_mm, rows[row].end_diameter_mm);
    const double small = large - std::min(by_mm, large / 2);
    const bool toward_free = row < (rows.size() + 1) / 2;
    made.start_diameter_mm = toward_free ? small : large;
    made.end_diameter_mm = toward_free ? large : small;
}

void makeGroove(const ShaftRows& rows, std::size_t row, ShaftSegment& made)
{
    double edge = std::max(made.start_diameter_mm, made.end_diameter_mm);
    if (row > 0) edge = std::min(edge, rows[row - 1].end_diameter_mm);
    if (row + 1 < rows.size()) edge = std::min(edge, rows[row + 1].start_diameter_mm);
    double bottom = std::min(made.start_diameter_mm, made.end_diameter_mm);
    if (bottom > edge - same_mm) bottom = edge - std::min(2 * grooveDepthShare * made.length_mm, edge / 4);
    made.start_diameter_mm = made.end_diameter_mm = bottom;
}

}  // namespace

bool isCylinder(const ShaftSegment& row)
{
    return !row.arc_radius_mm && isSameSize(row.start_diameter_mm, row.end_diameter_mm);
}

bool isMinorRow(const ShaftSegment& row)
{
    for (const char* minor : {"chamfer", "fillet", "edge_round", "groove", "undercut"})
        if (row.role == minor) return true;
    return row.role.empty() && !isCylinder(row) &&
           row.length_mm <= minorLengthShare * std::max(row.start_diameter_mm, row.end_diameter_mm);
}

double startOf_mm(const ShaftRows& rows, std::size_t row)
{
    double z_mm = 0;
    for (std::size_t i = 0; i < row && i < rows.size(); ++i) z_mm += rows[i].length_mm;
    return z_mm;
}

ShaftRows deleteRow(ShaftRows rows, std::size_t row, KeepAfter keep)
{
    if (keep == KeepAfter::Places) rows[rowToLengthen(rows, row)].length_mm += rows[row].length_mm;
    rows.erase(rows.begin() + at(row));
    return rows;
}

ShaftRows mergeWithNext(ShaftRows rows, std::size_t row)
{
    const ShaftSegment a = rows[row], b = rows[row + 1];
    ShaftSegment& both = rows[row];
    both.length_mm = a.length_mm + b.length_mm;
    both.arc_radius_mm.reset();
    const bool cylinder = isCylinder(a) && isCylinder(b);
    if (cylinder) {
        both.start_diameter_mm = both.end_diameter_mm =
            mean(a.start_diameter_mm, b.start_diameter_mm, a.length_mm, b.length_mm);
    } else {
        both.end_diameter_mm = b.end_diameter_mm;
        const bool one_arc = a.arc_radius_mm && b.arc_radius_mm && isSameSize(a.end_diameter_mm, b.start_diameter_mm) &&
                             isSameSize(*a.arc_radius_mm, *b.arc_radius_mm);
        const double chord = std::hypot(both.length_mm, (both.end_diameter_mm - both.start_diameter_mm) / 2);
        if (one_arc && 2 * std::abs(*a.arc_radius_mm) > chord) both.arc_radius_mm = a.arc_radius_mm;
    }
    both.bore_diameter_mm = std::min(a.bore_diameter_mm, b.bore_diameter_mm);
    if (a.role != b.role) both.role.clear();
    if (a.tie != b.tie) both.tie.clear();
    if (a.tolerance != b.tolerance) both.tolerance.reset();
    both.measured = joined(a, b, cylinder);
    rows.erase(rows.begin() + at(row + 1));
    return rows;
}

ShaftRows splitRow(ShaftRows rows, std::size_t row, double at_mm)
{
    ShaftSegment first = rows[row], second = rows[row];
    if (!(at_mm > 0 && at_mm < first.length_mm))
        throw Error(errors::shaftRowWrong, {{"row", static_cast<std::int64_t>(row + 1)},
                                            {"contour", LT_TEXT("Engine", "outside")},
                                            {"quantity", LT_TEXT("Engine", "place of the cut")},
                                            {"found", at_mm},
                                            {"expected", LT_TEXT("Engine", "a place inside the row")}});
    const ContourPiece piece{{0, first.start_diameter_mm / 2},
                             {first.length_mm, first.end_diameter_mm / 2},
                             first.arc_radius_mm.value_or(0)};
    first.length_mm = at_mm;
    second.length_mm -= at_mm;
    if (!isCylinder(first)) first.end_diameter_mm = second.start_diameter_mm = 2 * piece.radiusAt_mm(at_mm);
    for (ShaftSegment* part : {&first, &second}) {
        if (!part->measured) continue;
        part->measured->length_mm.reset();
        part->measured->uncertainty.length_um.reset();
    }
    if (first.measured && !isCylinder(rows[row])) {
        first.measured->end_diameter_mm.reset();
        second.measured->start_diameter_mm.reset();
    }
    rows[row] = first;
    rows.insert(rows.begin() + at(row + 1), second);
    return rows;
}

ShaftRows changeForm(ShaftRows rows, std::size_t row, RowForm form)
{
    ShaftSegment made = rows[row];
    made.arc_radius_mm.reset();
    made.role.clear();
    if (form == RowForm::Cylinder) {
        made.start_diameter_mm = made.end_diameter_mm = (made.start_diameter_mm + made.end_diameter_mm) / 2;
    } else if (form == RowForm::Groove) {
        makeGroove(rows, row, made);
        made.role = "groove";
    } else {
        made.tie.clear();
        if (isCylinder(rows[row])) meetNeighbours(rows, row, made);
        if (isCylinder(made)) {
            const double leg = 2 * made.length_mm;
            fall(rows, row, form == RowForm::Cone ? openConeSlope * made.length_mm : leg, made);
        }
        if (form == RowForm::Chamfer) made.role = "chamfer";
        const double chord = std::hypot(made.length_mm, (made.end_diameter_mm - made.start_diameter_mm) / 2);
        if (form == RowForm::Round || form == RowForm::Fillet) {
            made.arc_radius_mm = (form == RowForm::Round ? 1 : -1) * chord / std::numbers::sqrt2;
            made.role = form == RowForm::Round ? "edge_round" : "fillet";
        }
    }
    rows[row] = made;
    return rows;
}

}  // namespace lathelier
