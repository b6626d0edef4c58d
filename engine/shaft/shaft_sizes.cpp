#include "engine/shaft/shaft_sizes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>

#include "engine/shaft/shaft_codes.h"

namespace lathelier {
namespace {

constexpr double quarterTolerance = 1e-3;     // of the radius: tolerance for an arc to be a quarter of a circle
constexpr double halfRoundRatio = 1 + 1e-12;  // an arc's radius is no less than half its chord, rounding included
constexpr double steepestCone_deg = 89.9;

const Text sizeLength = LT_TEXT("Engine", "length");
const Text sizeDiameter = LT_TEXT("Engine", "diameter");
const Text sizeRadius = LT_TEXT("Engine", "radius");
const Text sizeAngle = LT_TEXT("Engine", "angle");
const Text aboveZero = LT_TEXT("Engine", "more than 0");

[[noreturn]] void refuseSize(std::size_t row, Text quantity, double found, Text expected)
{
    throw Error(errors::shaftRowWrong, {{"row", static_cast<std::int64_t>(row + 1)},
                                        {"contour", LT_TEXT("Engine", "outside")},
                                        {"quantity", quantity},
                                        {"found", found},
                                        {"expected", expected}});
}

void requirePositive(std::size_t row, Text quantity, double value)
{
    if (!(value > 0) || !std::isfinite(value)) refuseSize(row, quantity, value, aboveZero);
}

void requireAngle(std::size_t row, double angle_deg)
{
    if (!(angle_deg > 0 && angle_deg < steepestCone_deg))
        refuseSize(row, sizeAngle, angle_deg, LT_TEXT("Engine", "more than 0° and less than 90°"));
}

/// Enlarges the radius of an arc to half its chord at least.
void reachEnds(ShaftSegment& row)
{
    if (!row.arc_radius_mm) return;
    const double chord = std::hypot(row.length_mm, (row.end_diameter_mm - row.start_diameter_mm) / 2);
    const double least = chord / 2 * halfRoundRatio;
    if (std::abs(*row.arc_radius_mm) < least) row.arc_radius_mm = std::copysign(least, *row.arc_radius_mm);
}

/// Adds `by_mm` to the diameter of the neighbour that meets the changed end of `row`.
void followDiameter(ShaftRows& rows, std::size_t row, bool before, double old_mm, double by_mm)
{
    if (before ? row == 0 : row + 1 >= rows.size()) return;
    const std::size_t next = before ? row - 1 : row + 1;
    ShaftSegment& neighbour = rows[next];
    double& near = before ? neighbour.end_diameter_mm : neighbour.start_diameter_mm;
    double& far = before ? neighbour.start_diameter_mm : neighbour.end_diameter_mm;
    if (isCylinder(neighbour) || !isSameSize(near, old_mm)) return;
    const bool has_beyond = before ? next > 0 : next + 1 < rows.size();
    const double beyond = !has_beyond ? 0 : before ? rows[next - 1].end_diameter_mm : rows[next + 1].start_diameter_mm;
    const bool free = isMinorRow(neighbour) && !(has_beyond && isSameSize(far, beyond));
    near += by_mm;
    if (free) far = std::max(far + by_mm, 0.0);
    reachEnds(neighbour);
}

/// Sets the diameter of one row, without tied rows.
void setOne(ShaftRows& rows, std::size_t index, double diameter_mm, RowEnd end)
{
    ShaftSegment& row = rows[index];
    const double old_start = row.start_diameter_mm, old_end = row.end_diameter_mm;
    const bool both = end == RowEnd::Both || isCylinder(row);
    if (both &&
        !isCylinder(
            row)) {  // a cone or an arc: the diameter is that of its larger end; the other end is shifted equally
        const double by = diameter_mm - std::max(old_start, old_end);
        row.start_diameter_mm = old_start + by;
        row.end_diameter_mm = old_end + by;
        if (std::min(row.start_diameter_mm, row.end_diameter_mm) < 0)
            refuseSize(index, sizeDiameter, diameter_mm, aboveZero);
    } else {
        if (both || end == RowEnd::Start) row.start_diameter_mm = diameter_mm;
        if (both || end == RowEnd::End) row.end_diameter_mm = diameter_mm;
    }
    reachEnds(row);
    if (isMinorRow(row)) return;
    followDiameter(rows, index, true, old_start, row.start_diameter_mm - old_start);
    followDiameter(rows, index, false, old_end, row.end_diameter_mm - old_end);
}

/// The longest of [first, last] that is not minor; else the longest.
std::size_t longestOf(const ShaftRows& rows, std::size_t first, std::size_t last)
{
    std::size_t best = first;
    const auto rank = [&](std::size_t i) { return std::pair(!isMinorRow(rows[i]), rows[i].length_mm); };
    for (std::size_t i = first + 1; i <= last; ++i)
        if (rank(i) > rank(best)) best = i;
    return best;
}

void lengthen(ShaftRows& rows, std::size_t row, double by_mm)
{
    const double made = rows[row].length_mm + by_mm;
    requirePositive(row, sizeLength, made);
    rows[row].length_mm = made;
    reachEnds(rows[row]);
}

/// Subtracts the difference from the first row behind `last` that is not minor; without one the part becomes longer.
void holdPlaces(ShaftRows& rows, std::size_t last, double by_mm)
{
    for (std::size_t i = last + 1; i < rows.size(); ++i)
        if (!isMinorRow(rows[i])) return lengthen(rows, i, -by_mm);
}

/// Changes the length of a minor row at the cost of the neighbour that it meets, else of a neighbour that is not minor.
void setMinorLength(ShaftRows& rows, std::size_t first, std::size_t last, double length_mm)
{
    requirePositive(first, sizeLength, length_mm);
    double now = 0;
    for (std::size_t i = first; i <= last; ++i) now += rows[i].length_mm;
    const double by = length_mm - now;
    lengthen(rows, longestOf(rows, first, last), by);
    std::optional<std::size_t> giver;
    const auto considerRow = [&](std::size_t i, bool meets) {
        if (!isMinorRow(rows[i]) && (!giver || meets)) giver = i;
    };
    if (last + 1 < rows.size())
        considerRow(last + 1, isSameSize(rows[last].end_diameter_mm, rows[last + 1].start_diameter_mm));
    if (first > 0) considerRow(first - 1, isSameSize(rows[first].start_diameter_mm, rows[first - 1].end_diameter_mm));
    if (giver) lengthen(rows, *giver, -by);
}

/// Does the row meet a neighbour at its start; at its end?
bool meetsBefore(const ShaftRows& rows, std::size_t row)
{
    return row > 0 && isSameSize(rows[row - 1].end_diameter_mm, rows[row].start_diameter_mm);
}
bool meetsAfter(const ShaftRows& rows, std::size_t row)
{
    return row + 1 < rows.size() && isSameSize(rows[row].end_diameter_mm, rows[row + 1].start_diameter_mm);
}

/// Keeps one end and places the other at a diameter difference of `by_mm`, with its present sign.
void keepMeetingEnd(ShaftRows& rows, std::size_t index, double by_mm)
{
    ShaftSegment& row = rows[index];
    const bool rises = row.end_diameter_mm >= row.start_diameter_mm;
    const bool before = meetsBefore(rows, index), after = meetsAfter(rows, index);
    const bool start_stays = before != after ? before : !rises;
    double& moved = start_stays ? row.end_diameter_mm : row.start_diameter_mm;
    const double fixed = start_stays ? row.start_diameter_mm : row.end_diameter_mm;
    moved = fixed + (rises == start_stays ? by_mm : -by_mm);
    if (moved < 0) refuseSize(index, sizeDiameter, moved, LT_TEXT("Engine", "0 or more"));
}

}  // namespace

ShaftRows setDiameter(ShaftRows rows, std::size_t row, double diameter_mm, RowEnd end)
{
    requirePositive(row, sizeDiameter, diameter_mm);
    std::vector<std::size_t> all = isCylinder(rows[row]) ? tiedTo(rows, row) : std::vector<std::size_t>();
    all.push_back(row);
    for (const std::size_t one : all) setOne(rows, one, diameter_mm, end);
    return rows;
}

ShaftRows setLength(ShaftRows rows, std::size_t first, std::size_t last, double length_mm, KeepAfter keep)
{
    requirePositive(first, sizeLength, length_mm);
    double now = 0;
    for (std::size_t i = first; i <= last; ++i) now += rows[i].length_mm;
    if (std::all_of(rows.begin() + static_cast<std::ptrdiff_t>(first),
                    rows.begin() + static_cast<std::ptrdiff_t>(last) + 1, isMinorRow)) {
        setMinorLength(rows, first, last, length_mm);
        return rows;
    }
    lengthen(rows, longestOf(rows, first, last), length_mm - now);
    if (keep == KeepAfter::Places) holdPlaces(rows, last, length_mm - now);
    return rows;
}

ShaftRows moveShoulder(ShaftRows rows, std::size_t before, double z_mm, KeepAfter keep)
{
    const double by = z_mm - startOf_mm(rows, before + 1);
    std::size_t grows = before;
    for (std::size_t i = before + 1; i-- > 0;)
        if (!isMinorRow(rows[i])) {
            grows = i;
            break;
        }
    lengthen(rows, grows, by);
    if (keep == KeepAfter::Places) holdPlaces(rows, before, by);
    return rows;
}

ShaftRows setChamfer(ShaftRows rows, std::size_t row, double leg_mm, double angle_deg)
{
    requireAngle(row, angle_deg);
    setMinorLength(rows, row, row, leg_mm);
    keepMeetingEnd(rows, row, 2 * leg_mm * std::tan(angle_deg * std::numbers::pi / 180));
    return rows;
}

ShaftRows setConeAngle(ShaftRows rows, std::size_t row, double angle_deg)
{
    requireAngle(row, angle_deg);
    ShaftSegment& cone = rows[row];
    const double by = 2 * cone.length_mm * std::tan(angle_deg * std::numbers::pi / 180);
    double& small = cone.end_diameter_mm >= cone.start_diameter_mm ? cone.start_diameter_mm : cone.end_diameter_mm;
    small = std::max(cone.start_diameter_mm, cone.end_diameter_mm) - by;
    if (small < 0) refuseSize(row, sizeDiameter, small, LT_TEXT("Engine", "0 or more"));
    return rows;
}

ShaftRows setArcRadius(ShaftRows rows, std::size_t row, double radius_mm)
{
    requirePositive(row, sizeRadius, radius_mm);
    ShaftSegment& arc = rows[row];
    const double now = std::abs(arc.arc_radius_mm.value_or(0));
    const double rise = std::abs(arc.end_diameter_mm - arc.start_diameter_mm) / 2, off = quarterTolerance * now;
    const bool quarter = std::abs(arc.length_mm - now) <= off && std::abs(rise - now) <= off;
    arc.arc_radius_mm = std::copysign(radius_mm, arc.arc_radius_mm.value_or(1));
    if (quarter) {
        const double kept = *arc.arc_radius_mm;
        setMinorLength(rows, row, row, radius_mm);
        keepMeetingEnd(rows, row, 2 * radius_mm);
        rows[row].arc_radius_mm = kept;
    }
    reachEnds(rows[row]);
    return rows;
}

ShaftRows setGroove(ShaftRows rows, std::size_t first, std::size_t last, double width_mm, double bottom_mm)
{
    requirePositive(first, sizeDiameter, bottom_mm);
    setMinorLength(rows, first, last, width_mm);
    double now = rows[first].start_diameter_mm;
    for (std::size_t i = first; i <= last; ++i)
        now = std::min({now, rows[i].start_diameter_mm, rows[i].end_diameter_mm});
    for (std::size_t i = first; i <= last; ++i) {
        const bool bottom = isCylinder(rows[i]) && isSameSize(rows[i].start_diameter_mm, now);
        if (bottom || first == last) {
            const double by = bottom_mm - now;
            rows[i].start_diameter_mm += by;
            rows[i].end_diameter_mm += by;
        } else {  // a flank: its lower end follows the bottom
            for (double* end : {&rows[i].start_diameter_mm, &rows[i].end_diameter_mm})
                if (isSameSize(*end, now)) *end = bottom_mm;
            reachEnds(rows[i]);
        }
    }
    return rows;
}

std::vector<std::size_t> tiedTo(const ShaftRows& rows, std::size_t row)
{
    std::vector<std::size_t> others;
    if (rows[row].tie.empty()) return others;
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (i != row && rows[i].tie == rows[row].tie && isCylinder(rows[i])) others.push_back(i);
    return others;
}

ShaftRows tieDiameters(ShaftRows rows, std::size_t row, std::size_t other)
{
    for (const std::size_t one : {row, other})
        if (!isCylinder(rows[one]))
            refuseSize(one, sizeDiameter, rows[one].end_diameter_mm, LT_TEXT("Engine", "that of a cylinder"));
    std::set<std::string> used;
    for (const ShaftSegment& one : rows) used.insert(one.tie);
    std::string name = rows[other].tie.empty() ? rows[row].tie : rows[other].tie;
    for (int number = 1; name.empty(); ++number)
        if (!used.contains(std::to_string(number))) name = std::to_string(number);
    const std::string old = rows[row].tie;
    for (ShaftSegment& one : rows)
        if (!old.empty() && one.tie == old) one.tie = name;
    rows[row].tie = rows[other].tie = name;
    return setDiameter(rows, row, rows[other].start_diameter_mm);
}

ShaftRows untieDiameter(ShaftRows rows, std::size_t row)
{
    const std::vector<std::size_t> others = tiedTo(rows, row);
    if (others.size() == 1) rows[others.front()].tie.clear();
    rows[row].tie.clear();
    return rows;
}

ShaftRows followTies(const ShaftRows& before, ShaftRows after)
{
    if (before.size() != after.size()) return after;
    for (std::size_t i = 0; i < after.size(); ++i) {
        if (!isCylinder(after[i]) || isSameSize(before[i].start_diameter_mm, after[i].start_diameter_mm)) continue;
        for (const std::size_t other : tiedTo(after, i))
            if (isSameSize(before[other].start_diameter_mm, after[other].start_diameter_mm))
                setOne(after, other, after[i].start_diameter_mm, RowEnd::Both);
    }
    return after;
}

ShaftRows keepMeasured(const ShaftRows& before, ShaftRows after)
{
    if (before.size() != after.size()) return after;
    for (std::size_t i = 0; i < after.size(); ++i) {
        const ShaftSegment &was = before[i], &is = after[i];
        const bool edited = was.length_mm != is.length_mm || was.start_diameter_mm != is.start_diameter_mm ||
                            was.end_diameter_mm != is.end_diameter_mm || was.arc_radius_mm != is.arc_radius_mm;
        if (!edited || is.measured) continue;
        after[i].measured =
            MeasuredSize{was.length_mm, was.start_diameter_mm, was.end_diameter_mm, was.arc_radius_mm, {}};
    }
    return after;
}

}  // namespace lathelier
