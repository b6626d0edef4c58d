#include "engine/shaft/shaft_rules.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/core/units.h"
#include "engine/shaft/shaft_codes.h"
#include "engine/shaft/shaft_contour.h"
#include "engine/shaft/turned_marks.h"

namespace lathelier {
namespace {

using Eigen::Vector2d;

constexpr double shortRow_mm = 0.05;
constexpr double thinWall_mm = 0.01;
constexpr double touchingRatio = 1 + 1e-9;  // a half round: its chord is twice its radius

const Text outside = LT_TEXT("Engine", "outside");
const Text freeBore = LT_TEXT("Engine", "bore from the free end");
const Text chuckBore = LT_TEXT("Engine", "bore from the chuck end");

Text nameOf(const Shaft& shaft, std::ptrdiff_t bore)
{
    if (bore == ContourPiece::none) return outside;
    return shaft.bores[static_cast<std::size_t>(bore)].from == ShaftEnd::Free ? freeBore : chuckBore;
}

[[noreturn]] void refuseRow(std::size_t row, Text contour, Text quantity, double found, Text expected)
{
    throw Error(errors::shaftRowWrong, {{"row", static_cast<std::int64_t>(row + 1)},
                                        {"contour", contour},
                                        {"quantity", quantity},
                                        {"found", found},
                                        {"expected", expected}});
}

/// A row that runs back: the relieved face of an undercut, between a hollow arc and the face it cuts under.
template <class Segment>
bool isFaceUndercut(const std::vector<Segment>& rows, std::size_t i)
{
    return i > 0 && i + 1 < rows.size() && rows[i - 1].arc_radius_mm.value_or(0) < 0 && !rows[i].arc_radius_mm &&
           -rows[i].length_mm < rows[i - 1].length_mm + std::abs(*rows[i - 1].arc_radius_mm) &&
           rows[i].end_diameter_mm > rows[i].start_diameter_mm;
}

template <class Segment>
void checkContourRows(const std::vector<Segment>& rows, Text contour, bool bore, Notes& notes)
{
    const Text length = LT_TEXT("Engine", "the length in mm");
    const Text start = LT_TEXT("Engine", "the start diameter in mm");
    const Text end = LT_TEXT("Engine", "the end diameter in mm");
    const Text radius = LT_TEXT("Engine", "the arc radius in mm");
    const Text number = LT_TEXT("Engine", "a finite number");
    if (rows.empty())
        refuseRow(0, contour, LT_TEXT("Engine", "the number of rows"), 0, LT_TEXT("Engine", "one or more"));
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Segment& row = rows[i];
        if (!std::isfinite(row.length_mm)) refuseRow(i, contour, length, row.length_mm, number);
        for (const auto& [value, name, inner] : {std::tuple(row.start_diameter_mm, start, i > 0),
                                                 std::tuple(row.end_diameter_mm, end, i + 1 < rows.size())}) {
            if (!std::isfinite(value)) refuseRow(i, contour, name, value, number);
            if (value < 0) refuseRow(i, contour, name, value, LT_TEXT("Engine", "0 or more"));
            if (value == 0 && inner && !bore)
                refuseRow(i, contour, name, value, LT_TEXT("Engine", "more than 0 inside the part"));
        }
        if (row.length_mm < 0 && !isFaceUndercut(rows, i))
            refuseRow(i, contour, length, row.length_mm,
                      LT_TEXT("Engine", "0 or more, but for the face of an undercut after a hollow arc"));
        if (row.arc_radius_mm) {
            const double chord = std::hypot(row.length_mm, (row.end_diameter_mm - row.start_diameter_mm) / 2);
            if (!std::isfinite(*row.arc_radius_mm) || *row.arc_radius_mm == 0)
                refuseRow(i, contour, radius, *row.arc_radius_mm, LT_TEXT("Engine", "a finite number that is not 0"));
            if (std::abs(*row.arc_radius_mm) * 2 * touchingRatio < chord)
                refuseRow(i, contour, radius, *row.arc_radius_mm,
                          LT_TEXT("Engine", "at least half the distance between the ends of the row"));
        }
        if (row.length_mm > 0 && row.length_mm < shortRow_mm)
            notes.push_back(
                {notes::shaftRowShort,
                 {{"row", static_cast<std::int64_t>(i + 1)}, {"contour", contour}, {"length_mm", row.length_mm}}});
        if (i == 0 || row.arc_radius_mm || rows[i - 1].arc_radius_mm) continue;
        const Segment& before = rows[i - 1];
        if (!(row.length_mm > 0) || !(before.length_mm > 0)) continue;
        const double slope = (row.end_diameter_mm - row.start_diameter_mm) / row.length_mm;
        const double slope_before = (before.end_diameter_mm - before.start_diameter_mm) / before.length_mm;
        if (std::abs(before.end_diameter_mm - row.start_diameter_mm) < same_mm &&
            std::abs(slope - slope_before) * std::min(row.length_mm, before.length_mm) < same_mm)
            notes.push_back({notes::shaftRowsInLine,
                             {{"row", static_cast<std::int64_t>(i)},
                              {"other_row", static_cast<std::int64_t>(i + 1)},
                              {"contour", contour}}});
    }
}

struct Box {
    Vector2d low, high;
};

Box boxOf(const ContourPiece& piece)
{
    Box box{piece.from_mm.cwiseMin(piece.to_mm), piece.from_mm.cwiseMax(piece.to_mm)};
    if (!piece.isArc()) return box;
    const auto [start, end] = piece.arcAngles();
    const Vector2d centre = piece.centre_mm();
    const double radius = std::abs(piece.arc_radius_mm);
    for (int quarter = -4; quarter <= 4; ++quarter) {
        const double angle = quarter * std::acos(0.0);
        if (angle < std::min(start, end) || angle > std::max(start, end)) continue;
        const Vector2d point = centre + radius * Vector2d(std::cos(angle), std::sin(angle));
        box.low = box.low.cwiseMin(point);
        box.high = box.high.cwiseMax(point);
    }
    return box;
}

/// Row of a piece, counted from 1; of a face the row that it leads to.
std::int64_t rowOf(const Contour& contour, std::size_t piece)
{
    for (std::size_t i = piece; i < contour.size(); ++i)
        if (contour[i].row != ContourPiece::none) return contour[i].row + 1;
    return contour.empty() ? 1 : contour.back().row + 1;
}

void checkCrossings(const Shaft& shaft, const Contour& contour)
{
    std::vector<Box> boxes;
    for (const ContourPiece& piece : contour) boxes.push_back(boxOf(piece));
    std::vector<std::size_t> order(contour.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return boxes[a].low.x() < boxes[b].low.x(); });
    for (std::size_t a = 0; a < order.size(); ++a)
        for (std::size_t b = a + 1; b < order.size() && boxes[order[b]].low.x() <= boxes[order[a]].high.x() + same_mm;
             ++b) {
            const std::size_t i = std::min(order[a], order[b]), j = std::max(order[a], order[b]);
            if (boxes[i].low.y() > boxes[j].high.y() + same_mm || boxes[j].low.y() > boxes[i].high.y() + same_mm)
                continue;
            const bool next = j == i + 1 || (i == 0 && j + 1 == contour.size());
            for (const Vector2d& point : meetingPoints(contour[i], contour[j])) {
                // Neighbours share one end.
                const Vector2d shared = j == i + 1 ? contour[i].to_mm : contour[i].from_mm;
                if (next && (point - shared).norm() < same_mm) continue;
                throw Error(errors::shaftCrosses, {{"row", rowOf(contour, i)},
                                                   {"contour", nameOf(shaft, contour[i].bore)},
                                                   {"other_row", rowOf(contour, j)},
                                                   {"other_contour", nameOf(shaft, contour[j].bore)},
                                                   {"z_mm", point.x()},
                                                   {"diameter_mm", 2 * point.y()}});
            }
        }
}

/// The thinnest wall between outside and bores, evaluated at the ends and middles of pieces.
void remarkThinWall(const Contour& contour, Notes& notes)
{
    double wall_mm = std::numeric_limits<double>::infinity(), z_mm = 0;
    const auto isRow = [](const ContourPiece& piece) {
        return piece.row != ContourPiece::none && piece.to_mm.x() != piece.from_mm.x();
    };
    std::vector<ContourPiece> holes;
    for (const ContourPiece& piece : contour)
        if (piece.bore != ContourPiece::none && isRow(piece)) holes.push_back(piece);
    if (holes.empty()) return;
    for (const ContourPiece& piece : contour) {
        if (piece.bore != ContourPiece::none || !isRow(piece)) continue;
        for (const ContourPiece& hole : holes) {
            const double low =
                std::max(std::min(hole.from_mm.x(), hole.to_mm.x()), std::min(piece.from_mm.x(), piece.to_mm.x()));
            const double high =
                std::min(std::max(hole.from_mm.x(), hole.to_mm.x()), std::max(piece.from_mm.x(), piece.to_mm.x()));
            if (!(low < high)) continue;
            for (const double z : {low, (low + high) / 2, high}) {
                const double wall = piece.radiusAt_mm(z) - hole.radiusAt_mm(z);
                if (wall < wall_mm) wall_mm = wall, z_mm = z;
            }
        }
    }
    if (wall_mm < thinWall_mm) notes.push_back({notes::shaftWallThin, {{"wall_mm", wall_mm}, {"z_mm", z_mm}}});
}

void remarkMarks(const Shaft& shaft, Notes& notes)
{
    for (const ShaftMark& mark : shaft.marks) {
        if (!mark.z_start_mm || !mark.z_end_mm) continue;
        double z = 0;
        bool inside = false;
        for (const ShaftSegment& row : shaft.segments) {
            inside |= *mark.z_start_mm >= z - 0.5 && *mark.z_end_mm <= z + row.length_mm + 0.5;
            z += row.length_mm;
        }
        // A thread, teeth or faces may begin on the chamfer before their row.
        const bool isOfOneRow = mark.kind != MarkKind::Thread && mark.kind != MarkKind::Knurl &&
                                mark.kind != MarkKind::FreeForm && mark.kind != MarkKind::Unexplained &&
                                !isOtherThanTurned(mark.kind);
        if (!inside && isOfOneRow)
            notes.push_back({notes::markOutsideRow,
                             {{"kind", key(mark)}, {"z_start_mm", *mark.z_start_mm}, {"z_end_mm", *mark.z_end_mm}}});
    }
}

}  // namespace

void checkBores(const Shaft& shaft)
{
    if (!shaft.bores.empty() && std::any_of(shaft.segments.begin(), shaft.segments.end(),
                                            [](const ShaftSegment& row) { return row.bore_diameter_mm > 0; }))
        throw Error(errors::boresStatedTwice, {});
    double free_mm = 0, chuck_mm = 0;
    for (const ShaftBore& bore : shaft.bores)
        for (const BoreSegment& row : bore.segments)
            (bore.from == ShaftEnd::Free ? free_mm : chuck_mm) += row.length_mm;
    if (free_mm + chuck_mm > shaft.length_mm() + same_mm)
        throw Error(errors::shaftBoresMeet,
                    {{"free_mm", free_mm}, {"chuck_mm", chuck_mm}, {"length_mm", shaft.length_mm()}});
}

Notes checkShaft(const Shaft& shaft)
{
    Notes notes;
    checkContourRows(shaft.segments, outside, false, notes);
    if (!(shaft.length_mm() > 0))
        refuseRow(0, outside, LT_TEXT("Engine", "the length of the part in mm"), shaft.length_mm(),
                  LT_TEXT("Engine", "more than 0"));
    checkBores(shaft);
    for (std::size_t i = 0; i < shaft.bores.size(); ++i)
        checkContourRows(shaft.bores[i].segments, nameOf(shaft, static_cast<std::ptrdiff_t>(i)), true, notes);
    for (std::size_t i = 0; i < shaft.segments.size(); ++i) {
        const ShaftSegment& row = shaft.segments[i];
        if (!std::isfinite(row.bore_diameter_mm) || row.bore_diameter_mm < 0 ||
            (row.length_mm > 0 && row.bore_diameter_mm > 0 &&
             row.bore_diameter_mm >= std::min(row.start_diameter_mm, row.end_diameter_mm)))
            refuseRow(i, outside, LT_TEXT("Engine", "the bore diameter in mm"), row.bore_diameter_mm,
                      LT_TEXT("Engine", "0 or more, below the diameters of its row"));
    }
    const Contour contour = closedContour(shaft);
    checkCrossings(shaft, contour);
    remarkThinWall(contour, notes);
    remarkMarks(shaft, notes);
    return notes;
}

}  // namespace lathelier
