#include "engine/features/outline/wear.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "engine/features/model/selection.h"
#include "engine/features/outline/outline_limits.h"

namespace lathelier::features {
namespace {

bool isWellWithin(const Wall& wall, double from_mm, double to_mm)
{
    return wall.z_mm >= from_mm + wearLimits.end_margin_mm && wall.z_mm <= to_mm - wearLimits.end_margin_mm;
}

/// Largest deviation of means over five walls from a line over [from, to]; the last five count though they overlap
/// those before.
double deviationFrom(const Run& run, double from_mm, double to_mm, double level, double slope, double at)
{
    constexpr std::size_t n = wearLimits.mean_walls;
    std::vector<double> offs;
    for (const Wall& wall : run.walls)
        if (isWellWithin(wall, from_mm, to_mm))
            offs.push_back(wall.r_mm + wall.form_mm - level - slope * (wall.z_mm - at));
    double largest = 0;
    const auto mean = [&](std::size_t first) {
        double sum = 0;
        for (std::size_t i = first; i < first + n; ++i) sum += offs[i];
        largest = std::max(largest, std::abs(sum / n));
    };
    for (std::size_t first = 0; first + n <= offs.size(); first += n) mean(first);
    if (offs.size() >= n) mean(offs.size() - n);
    return largest;
}

/// How far the direction of the element turns between two places.
double turnOf(const Element& element, double from_mm, double to_mm)
{
    return element.arc ? std::abs(std::atan(element.slopeAt(to_mm)) - std::atan(element.slopeAt(from_mm))) : 0;
}

/// Is the jump between two pieces a step of the part, and not wear? Within the form tolerance only between pieces whose
/// slopes do not differ significantly from 0.
bool isStepOfPart(const Piece& a, const Piece& b, double jump_mm, double form_mm)
{
    if (std::abs(jump_mm) > form_mm) return true;
    const auto isLevel = [](const Piece& piece) { return !piece.arc && !isSignificantSlope(piece); };
    return isLevel(a) && isLevel(b);
}

double radiusOf(const Piece& piece, double z)
{
    if (!piece.arc) return piece.level_mm + piece.slope * (z - piece.at_mm);
    const double off = z - piece.centre_z_mm;
    return piece.centre_r_mm +
           (piece.convex ? 1 : -1) * std::sqrt(std::max(0.0, piece.radius_mm * piece.radius_mm - off * off));
}

double slopeOf(const Piece& piece, double z)
{
    constexpr double h = wearLimits.slope_half_width_mm;
    return (radiusOf(piece, z + h) - radiusOf(piece, z - h)) / (2 * h);
}

/// Weighted sums over the walls of a seat.
struct SeatSums {
    double n = 0, sz = 0, sr = 0, szz = 0, szr = 0;

    void add(double weight, double z, double r)
    {
        n += weight;
        sz += weight * z;
        sr += weight * r;
        szz += weight * z * z;
        szr += weight * z * r;
    }
    double slope() const { return (szr - sz * sr / n) / std::max(wearLimits.least_spread_mm2, szz - sz * sz / n); }
};

/// A cylinder (slope 0) or a cone by least squares.
struct SeatLine {
    double at_mm = 0, level_mm = 0, slope = 0;
    bool cylinder = true;
};

/// The cylinder, else the cone that describes the walls of `run` within the form tolerance; none: neither does.
std::optional<SeatLine> seatLineOf(const SeatSums& sums, const Run& run, double from_mm, double to_mm, double form_mm,
                                   bool may_be_cone)
{
    SeatLine line{sums.sz / sums.n, sums.sr / sums.n};
    const auto fits = [&] {
        return deviationFrom(run, from_mm, to_mm, line.level_mm, line.slope, line.at_mm) <= form_mm;
    };
    if (fits()) return line;
    if (!may_be_cone) return std::nullopt;
    line.cylinder = false;
    line.slope = sums.slope();
    return fits() ? std::optional(line) : std::nullopt;
}

/// Half way between piece k and the next.
double borderBehind(const std::vector<Piece>& pieces, const std::vector<Wall>& walls, std::size_t k)
{
    return (walls[pieces[k].end - 1].z_mm + walls[pieces[k + 1].begin].z_mm) / 2;
}

MergedJunction junctionBehind(const std::vector<Piece>& pieces, const std::vector<Wall>& walls, std::size_t k)
{
    const double z = borderBehind(pieces, walls, k);
    const double jump = radiusOf(pieces[k + 1], z) - radiusOf(pieces[k], z);
    const double bend = std::atan(slopeOf(pieces[k + 1], z)) - std::atan(slopeOf(pieces[k], z));
    return {z, 1e3 * jump, bend * 180 / std::numbers::pi};
}

/// A score or a band of wear in a seat: whatever lies between two lines of one level along the axis. Its depth is
/// judged by the form tolerance.
bool returnsToLevel(double slope_before, double level_before_mm, double slope_after, double level_after_mm,
                    double form_mm)
{
    const double steepest = std::tan(wearLimits.largest_bend_rad);
    return std::abs(slope_before) < steepest && std::abs(slope_after) < steepest &&
           std::abs(level_after_mm - level_before_mm) <= wearLimits.level_share * form_mm;
}

/// Do pieces i to j follow each other without bends and steps of the part?
bool isOneSeat(const std::vector<Piece>& pieces, const std::vector<Wall>& walls, std::size_t i, std::size_t j,
               double form_mm)
{
    const Piece &first = pieces[i], &last = pieces[j];
    if (j > i + 1 && !first.arc && !last.arc &&
        returnsToLevel(first.slope, radiusOf(first, walls[first.end - 1].z_mm), last.slope,
                       radiusOf(last, walls[last.begin].z_mm), form_mm))
        return true;
    for (std::size_t k = i; k <= j; ++k) {
        const double chord = walls[pieces[k].end - 1].z_mm - walls[pieces[k].begin].z_mm;
        if (pieces[k].arc && !(chord < wearLimits.largest_bend_rad * pieces[k].radius_mm)) return false;
    }
    for (std::size_t k = i; k < j; ++k) {
        const MergedJunction junction = junctionBehind(pieces, walls, k);
        const double small_um = wearLimits.no_step_um_per_mm * walls[pieces[k].end - 1].sigma_mm;
        if (!(std::abs(junction.angle_deg) < wearLimits.largest_bend_rad * 180 / std::numbers::pi)) return false;
        if (!(std::abs(junction.step_um) < small_um) &&
            isStepOfPart(pieces[k], pieces[k + 1], 1e-3 * junction.step_um, form_mm))
            return false;
    }
    return true;
}

/// Pieces i to j as one line within the form tolerance; none: they are not.
std::optional<Piece> mergedPiece(const std::vector<Piece>& pieces, const std::vector<Wall>& walls, std::size_t i,
                                 std::size_t j, double form_mm)
{
    Run seat;
    seat.walls.assign(walls.begin() + static_cast<std::ptrdiff_t>(pieces[i].begin),
                      walls.begin() + static_cast<std::ptrdiff_t>(pieces[j].end));
    SeatSums sums;
    for (const Wall& wall : seat.walls) sums.add(wall.points, wall.z_mm, wall.r_mm);
    const auto line = seatLineOf(sums, seat, seat.walls.front().z_mm, seat.walls.back().z_mm, form_mm, true);
    if (!line) return std::nullopt;
    Piece merged = pieces[i];
    merged.end = pieces[j].end;
    merged.arc = false;
    merged.at_mm = line->at_mm;
    merged.level_mm = line->level_mm;
    merged.slope = line->slope;
    return merged;
}

double bendBehind(const Run& run, std::size_t k)
{
    const double z = run.nodes_mm[k + 1];
    return std::atan(run.elements[k + 1].slopeAt(z)) - std::atan(run.elements[k].slopeAt(z));
}

/// A bend within elements i to j is a designed feature for any size, a corner or a fillet that joins without one,
/// unless the seat goes on behind it.
bool hasBend(const Run& run, std::size_t i, std::size_t j, double form_mm)
{
    const Element &first = run.elements[i], &last = run.elements[j];
    if (j > i + 1 && !first.arc && !last.arc &&
        returnsToLevel(first.slope, first.radiusAt_mm(run.nodes_mm[i + 1]), last.slope,
                       last.radiusAt_mm(run.nodes_mm[j]), form_mm))
        return false;
    for (std::size_t k = i; k <= j; ++k)
        if (turnOf(run.elements[k], run.nodes_mm[k], run.nodes_mm[k + 1]) > wearLimits.largest_bend_rad) return true;
    for (std::size_t k = i; k < j; ++k)
        if (std::abs(bendBehind(run, k)) > wearLimits.largest_bend_rad) return true;
    return false;
}

/// Elements i to j as one line within the form tolerance; none: they are not.
std::optional<Element> mergedElement(const Run& run, std::size_t i, std::size_t j, double form_mm)
{
    const auto first = run.elements.begin() + static_cast<std::ptrdiff_t>(i),
               last = run.elements.begin() + static_cast<std::ptrdiff_t>(j) + 1;
    if (std::any_of(first, last, [](const Element& e) { return e.rough; }) || hasBend(run, i, j, form_mm))
        return std::nullopt;
    const double from = run.nodes_mm[i], to = run.nodes_mm[j + 1];
    SeatSums sums;
    for (const Wall& wall : run.walls)
        if (isWellWithin(wall, from, to)) sums.add(wall.points, wall.z_mm, wall.r_mm + wall.form_mm);
    if (!(sums.n > 0) || to - from < wearLimits.shortest_seat_mm) return std::nullopt;
    const auto line = seatLineOf(sums, run, from, to, form_mm, i != j);
    if (!line) return std::nullopt;
    Element merged;
    merged.at_mm = line->at_mm;
    merged.level_mm = line->level_mm;
    merged.slope = line->slope;
    merged.cylinder = line->cylinder;
    return merged;
}

/// Puts `seat` in place of elements i to j: its wear is subtracted from the walls, ties of neighbouring arcs are freed.
void replaceBySeat(const Model& model, Run& run, std::size_t i, std::size_t j, const Element& seat)
{
    for (Wall& wall : run.walls) {
        if (wall.z_mm < run.nodes_mm[i] || wall.z_mm > run.nodes_mm[j + 1]) continue;
        const double off = radiusAt_mm(run, wall.z_mm) - seat.radiusAt_mm(wall.z_mm);
        wall.r_mm -= off;
        wall.form_mm += off;
    }
    run.elements.erase(run.elements.begin() + static_cast<std::ptrdiff_t>(i),
                       run.elements.begin() + static_cast<std::ptrdiff_t>(j));
    run.elements[i] = seat;
    run.nodes_mm.erase(run.nodes_mm.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                       run.nodes_mm.begin() + static_cast<std::ptrdiff_t>(j) + 1);
    if (i > 0 && run.elements[i - 1].arc) run.elements[i - 1].end = Tie::Free;
    if (i + 1 < run.elements.size() && run.elements[i + 1].arc) run.elements[i + 1].start = Tie::Free;
    resolve(model, run);
}

}  // namespace

double Wear::at_mm(double z_mm) const
{
    return radiusOf(was, z_mm) - radiusOf(now, z_mm);
}

void subtractWear(const std::vector<Wear>& worn, Wall& wall)
{
    for (const Wear& wear : worn) {
        if (wall.z_mm < wear.from_mm || wall.z_mm > wear.to_mm) continue;
        const double off = wear.at_mm(wall.z_mm);
        wall.r_mm -= off;
        wall.form_mm += off;
        return;
    }
}

void mergeWear(std::vector<Piece>& pieces, const std::vector<Wall>& walls, double form_mm,
               std::vector<MergedJunction>& merged, std::vector<Wear>& worn)
{
    if (!(form_mm > 0)) return;
    for (std::size_t i = 0; i + 1 < pieces.size(); ++i)
        for (std::size_t j = pieces.size() - 1; j > i; --j) {
            if (!isOneSeat(pieces, walls, i, j, form_mm)) continue;
            const std::optional<Piece> seat = mergedPiece(pieces, walls, i, j, form_mm);
            if (!seat) continue;
            for (std::size_t k = i; k < j; ++k) merged.push_back(junctionBehind(pieces, walls, k));
            for (std::size_t k = i; k <= j; ++k)
                worn.push_back({k == i ? walls[pieces[i].begin].z_mm : borderBehind(pieces, walls, k - 1),
                                k == j ? walls[pieces[j].end - 1].z_mm : borderBehind(pieces, walls, k), pieces[k],
                                *seat});
            pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                         pieces.begin() + static_cast<std::ptrdiff_t>(j) + 1);
            pieces[i] = *seat;
            break;
        }
}

std::vector<MergedJunction> mergeWithinForm(Model& model, double form_mm)
{
    std::vector<MergedJunction> merged;
    if (!(form_mm > 0)) return merged;
    for (Run& run : model.runs)
        for (std::size_t i = 0; i < run.elements.size(); ++i)
            for (std::size_t j = run.elements.size() - 1; j + 1 > i; --j) {
                if (i == j && !run.elements[i].arc && run.elements[i].cylinder) break;
                const std::optional<Element> seat = mergedElement(run, i, j, form_mm);
                if (!seat) continue;
                for (std::size_t k = i; k < j; ++k) {
                    const double z = run.nodes_mm[k + 1];
                    merged.push_back({z, 1e3 * (run.elements[k + 1].radiusAt_mm(z) - run.elements[k].radiusAt_mm(z)),
                                      bendBehind(run, k) * 180 / std::numbers::pi});
                }
                replaceBySeat(model, run, i, j, *seat);
                break;
            }
    return merged;
}

}  // namespace lathelier::features
