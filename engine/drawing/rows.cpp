#include "engine/drawing/rows.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/units.h"
#include "engine/shaft/shaft_contour.h"

namespace lathelier::drawing {
namespace {

RowKind kindOf(const ContourRow& row, const std::string& role)
{
    const double length = row.length_mm(), large = std::max(row.start_diameter_mm, row.end_diameter_mm);
    const bool cylinder = row.arc_radius_mm == 0 && std::abs(row.start_diameter_mm - row.end_diameter_mm) < same_mm;
    if (role == "groove") return RowKind::Groove;
    if (role == "undercut") return RowKind::Undercut;
    if (length < same_mm) return RowKind::Face;
    if (cylinder) return RowKind::Cylinder;
    if (row.arc_radius_mm != 0) {
        if (role == "saddle") return RowKind::Curve;
        if (role == "fillet" || role == "edge_round") return RowKind::Radius;
        return length <= 0.15 * large ? RowKind::Radius : RowKind::Curve;
    }
    if (role == "chamfer") return RowKind::Chamfer;
    const bool short_and_steep = row.angle_deg() >= 10 && length <= 0.1 * large;
    return role.empty() && short_and_steep ? RowKind::Chamfer : RowKind::Taper;
}

template <class Segment>
ContourRow rowOf(const Segment& segment, double z_mm, double sense, std::size_t index)
{
    ContourRow row;
    row.start_z_mm = z_mm;
    row.end_z_mm = z_mm + sense * segment.length_mm;
    row.start_diameter_mm = segment.start_diameter_mm;
    row.end_diameter_mm = segment.end_diameter_mm;
    row.arc_radius_mm = segment.arc_radius_mm.value_or(0);
    row.index = index;
    row.kind = kindOf(row, segment.role);
    row.tolerance = segment.tolerance;
    row.measured = segment.measured;
    return row;
}

/// Rows one after the other from `z_mm` on; `sense` is that of z.
template <class Segment>
std::vector<ContourRow> rowsFrom(const std::vector<Segment>& segments, double z_mm, double sense)
{
    const bool any = std::any_of(segments.begin(), segments.end(),
                                 [](const Segment& one) { return one.measured && one.measured->length_mm; });
    std::vector<ContourRow> rows;
    double measured_mm = z_mm;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const Segment& segment = segments[i];
        rows.push_back(rowOf(segment, z_mm, sense, i));
        ContourRow& row = rows.back();
        z_mm = row.end_z_mm;
        if (!any) continue;
        row.measured_start_z_mm = measured_mm;
        measured_mm +=
            sense * (segment.measured ? segment.measured->length_mm.value_or(segment.length_mm) : segment.length_mm);
        row.measured_end_z_mm = measured_mm;
    }
    return rows;
}

}  // namespace

double ContourRow::length_mm() const
{
    return std::abs(end_z_mm - start_z_mm);
}

Eigen::Vector2d ContourRow::middle_mm() const
{
    const double sense = end_z_mm < start_z_mm ? -1 : 1;
    const ContourPiece piece{
        {start_z_mm, start_diameter_mm / 2}, {end_z_mm, end_diameter_mm / 2}, sense * arc_radius_mm};
    if (!piece.isArc()) return (piece.from_mm + piece.to_mm) / 2;
    const auto [start, end] = piece.arcAngles();
    const double middle = (start + end) / 2;
    return piece.centre_mm() + std::abs(arc_radius_mm) * Eigen::Vector2d(std::cos(middle), std::sin(middle));
}

double ContourRow::crestDiameter_mm() const
{
    const double ends_mm = std::max(start_diameter_mm, end_diameter_mm);
    if (!(arc_radius_mm > 0)) return ends_mm;
    const double sense = end_z_mm < start_z_mm ? -1 : 1;
    const ContourPiece piece{
        {start_z_mm, start_diameter_mm / 2}, {end_z_mm, end_diameter_mm / 2}, sense * arc_radius_mm};
    if (!piece.isArc()) return ends_mm;
    const double z = piece.centre_mm().x();
    const bool has_crest = (z - start_z_mm) * (z - end_z_mm) < 0;
    return has_crest ? std::max(ends_mm, 2 * (piece.centre_mm().y() + arc_radius_mm)) : ends_mm;
}

double ContourRow::angle_deg() const
{
    return std::atan2(std::abs(end_diameter_mm - start_diameter_mm) / 2, length_mm()) * 180 / std::numbers::pi;
}

bool ContourRow::isBall() const
{
    const bool starts = start_diameter_mm < meet_mm, ends = end_diameter_mm < meet_mm;
    if (!(arc_radius_mm > 0) || starts == ends) return false;
    // The circle through the pole and the other end: ρ = (l² + r²)/2l.
    const double length = length_mm(), r = std::max(start_diameter_mm, end_diameter_mm) / 2;
    return std::abs(length * length + r * r - 2 * length * arc_radius_mm) < meet_mm * arc_radius_mm;
}

bool ContourRow::isMinor() const
{
    return kind == RowKind::Chamfer || kind == RowKind::Radius || kind == RowKind::Groove || kind == RowKind::Undercut;
}

Shaft withStatedBores(const Shaft& shaft)
{
    Shaft result = shaft;
    if (!shaft.bores.empty()) return result;
    for (std::ptrdiff_t number = 0; number < 2; ++number) {
        std::vector<ContourPiece> pieces;
        for (const ContourPiece& piece : closedContour(shaft))
            if (piece.bore == number && piece.row != ContourPiece::none) pieces.push_back(piece);
        if (pieces.empty()) continue;
        const auto low = [](const ContourPiece& piece) { return std::min(piece.from_mm.x(), piece.to_mm.x()); };
        std::sort(pieces.begin(), pieces.end(),
                  [&](const ContourPiece& a, const ContourPiece& b) { return low(a) < low(b); });
        ShaftBore bore{low(pieces.front()) < same_mm ? ShaftEnd::Free : ShaftEnd::Chuck, {}};
        if (bore.from == ShaftEnd::Chuck) std::reverse(pieces.begin(), pieces.end());
        for (const ContourPiece& piece : pieces) {
            const double length = std::abs(piece.to_mm.x() - piece.from_mm.x()), diameter = 2 * piece.from_mm.y();
            if (!bore.segments.empty() && std::abs(bore.segments.back().end_diameter_mm - diameter) < same_mm)
                bore.segments.back().length_mm += length;
            else
                bore.segments.push_back({length, diameter, diameter, {}, {}});
        }
        result.bores.push_back(bore);
    }
    for (ShaftSegment& segment : result.segments) segment.bore_diameter_mm = 0;
    return result;
}

std::vector<ContourRow> outerRows(const Shaft& shaft)
{
    return rowsFrom(shaft.segments, 0, 1);
}

std::vector<ContourRow> boreRows(const Shaft& shaft, std::size_t bore)
{
    const ShaftBore& stated = shaft.bores.at(bore);
    const bool free = stated.from == ShaftEnd::Free;
    return rowsFrom(stated.segments, free ? 0 : shaft.length_mm(), free ? 1 : -1);
}

double outerRadius(const std::vector<ContourRow>& rows, double z_mm)
{
    double radius = 0;
    for (const ContourRow& row : rows) {
        if (z_mm < std::min(row.start_z_mm, row.end_z_mm) - same_mm ||
            z_mm > std::max(row.start_z_mm, row.end_z_mm) + same_mm)
            continue;
        const double length = row.end_z_mm - row.start_z_mm;
        const double share = length == 0 ? 1 : (z_mm - row.start_z_mm) / length;
        radius = std::max(radius, (row.start_diameter_mm + share * (row.end_diameter_mm - row.start_diameter_mm)) / 2);
    }
    return radius;
}

}  // namespace lathelier::drawing
