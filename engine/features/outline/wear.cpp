#include "engine/features/outline/wear.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lathelier::features {
namespace {

/// Largest deviation of means over five walls from a line over [from, to]; the last five count though they overlap
/// those before.
double deviationFrom(const Run& run, double from_mm, double to_mm, double level, double slope, double at)
{
    constexpr std::size_t meanWalls = 5;
    std::vector<double> offs;
    for (const Wall& wall : run.walls)
        if (wall.z_mm >= from_mm + 0.1 && wall.z_mm <= to_mm - 0.1)
            offs.push_back(wall.r_mm + wall.form_mm - level - slope * (wall.z_mm - at));
    double largest = 0;
    const auto mean = [&](std::size_t first) {
        double sum = 0;
        for (std::size_t i = first; i < first + meanWalls; ++i) sum += offs[i];
        largest = std::max(largest, std::abs(sum / meanWalls));
    };
    for (std::size_t first = 0; first + meanWalls <= offs.size(); first += meanWalls) mean(first);
    if (offs.size() >= meanWalls) mean(offs.size() - meanWalls);
    return largest;
}

/// How far the direction of the element turns between two places.
double turnOf(const Element& element, double from_mm, double to_mm)
{
    return element.arc ? std::abs(std::atan(element.slopeAt(to_mm)) - std::atan(element.slopeAt(from_mm))) : 0;
}

/// Is the jump between two pieces a step of the part, and not wear? Within the form tolerance only between pieces whose
/// slopes do not differ significantly from 0.
bool isGenuine(const Piece& a, const Piece& b, double jump_mm, double form_mm)
{
    if (std::abs(jump_mm) > form_mm) return true;
    const auto level = [](const Piece& piece) { return !piece.arc && std::abs(piece.slope) < 4 * piece.slope_error; };
    return level(a) && level(b);
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
    constexpr double h = 0.05;
    return (radiusOf(piece, z + h) - radiusOf(piece, z - h)) / (2 * h);
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
    const auto joins = [&](std::size_t k) {
        const double z = (walls[pieces[k].end - 1].z_mm + walls[pieces[k + 1].begin].z_mm) / 2;
        const double jump = radiusOf(pieces[k + 1], z) - radiusOf(pieces[k], z);
        const double bend = std::atan(slopeOf(pieces[k + 1], z)) - std::atan(slopeOf(pieces[k], z));
        return MergedJunction{z, 1e3 * jump, bend * 180 / std::numbers::pi};
    };
    for (std::size_t i = 0; i + 1 < pieces.size(); ++i)
        for (std::size_t j = pieces.size() - 1; j > i; --j) {
            bool possible = true;
            for (std::size_t k = i; k <= j && possible; ++k) {
                const double chord = walls[pieces[k].end - 1].z_mm - walls[pieces[k].begin].z_mm;
                possible = !pieces[k].arc || chord < largestWearBend_rad * pieces[k].radius_mm;
            }
            for (std::size_t k = i; k < j && possible; ++k) {
                const MergedJunction join = joins(k);
                const double small = 5e-3 * walls[pieces[k].end - 1].sigma_mm;  // no jump
                possible = std::abs(join.angle_deg) < largestWearBend_rad * 180 / std::numbers::pi &&
                           (std::abs(join.step_um) < small ||
                            !isGenuine(pieces[k], pieces[k + 1], 1e-3 * join.step_um, form_mm));
            }
            if (!possible) continue;
            Run seat;
            seat.walls.assign(walls.begin() + static_cast<std::ptrdiff_t>(pieces[i].begin),
                              walls.begin() + static_cast<std::ptrdiff_t>(pieces[j].end));
            double n = 0, sz = 0, sr = 0, szz = 0, szr = 0;
            for (const Wall& wall : seat.walls) {
                n += wall.points;
                sz += wall.points * wall.z_mm;
                sr += wall.points * wall.r_mm;
                szz += wall.points * wall.z_mm * wall.z_mm;
                szr += wall.points * wall.z_mm * wall.r_mm;
            }
            Piece one = pieces[i];
            one.end = pieces[j].end;
            one.arc = false;
            one.at_mm = sz / n;
            one.level_mm = sr / n;
            one.slope = 0;
            const double from = seat.walls.front().z_mm, to = seat.walls.back().z_mm;
            bool fits = deviationFrom(seat, from, to, one.level_mm, 0, one.at_mm) <= form_mm;
            if (!fits) {
                one.slope = (szr - sz * sr / n) / std::max(1e-12, szz - sz * sz / n);
                fits = deviationFrom(seat, from, to, one.level_mm, one.slope, one.at_mm) <= form_mm;
            }
            if (!fits) continue;
            for (std::size_t k = i; k < j; ++k) merged.push_back(joins(k));
            for (std::size_t k = i; k <= j; ++k) {
                const auto border = [&](std::size_t part) {
                    return (walls[pieces[part].end - 1].z_mm + walls[pieces[part + 1].begin].z_mm) / 2;
                };
                worn.push_back({k == i ? from : border(k - 1), k == j ? to : border(k), pieces[k], one});
            }
            pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                         pieces.begin() + static_cast<std::ptrdiff_t>(j) + 1);
            pieces[i] = one;
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
                if (std::any_of(run.elements.begin() + static_cast<std::ptrdiff_t>(i),
                                run.elements.begin() + static_cast<std::ptrdiff_t>(j) + 1,
                                [](const Element& e) { return e.rough; }))
                    continue;
                const double from = run.nodes_mm[i], to = run.nodes_mm[j + 1];
                // A bend is a designed feature for any size: a corner, or a fillet that joins without one.
                bool bends = false;
                for (std::size_t k = i; k <= j; ++k)
                    bends |= turnOf(run.elements[k], run.nodes_mm[k], run.nodes_mm[k + 1]) > largestWearBend_rad;
                for (std::size_t k = i; k < j; ++k) {
                    const double z = run.nodes_mm[k + 1];
                    bends |= std::abs(std::atan(run.elements[k + 1].slopeAt(z)) -
                                      std::atan(run.elements[k].slopeAt(z))) > largestWearBend_rad;
                }
                if (bends) continue;
                // Weighted least squares of a cylinder and a cone over the seat.
                double n = 0, sz = 0, sr = 0, szz = 0, szr = 0;
                for (const Wall& wall : run.walls) {
                    if (wall.z_mm < from + 0.1 || wall.z_mm > to - 0.1) continue;
                    n += wall.points;
                    sz += wall.points * wall.z_mm;
                    sr += wall.points * (wall.r_mm + wall.form_mm);
                    szz += wall.points * wall.z_mm * wall.z_mm;
                    szr += wall.points * wall.z_mm * (wall.r_mm + wall.form_mm);
                }
                if (!(n > 0) || to - from < 1) continue;
                Element one;
                one.at_mm = sz / n;
                one.level_mm = sr / n;
                one.cylinder = true;
                bool fits = deviationFrom(run, from, to, one.level_mm, 0, one.at_mm) <= form_mm;
                if (!fits && i != j) {
                    one.cylinder = false;
                    one.slope = (szr - sz * sr / n) / std::max(1e-12, szz - sz * sz / n);
                    fits = deviationFrom(run, from, to, one.level_mm, one.slope, one.at_mm) <= form_mm;
                }
                if (!fits) continue;
                for (std::size_t k = i; k < j; ++k) {
                    const double z = run.nodes_mm[k + 1];
                    const double bend =
                        std::atan(run.elements[k + 1].slopeAt(z)) - std::atan(run.elements[k].slopeAt(z));
                    merged.push_back({z, 1e3 * (run.elements[k + 1].radiusAt_mm(z) - run.elements[k].radiusAt_mm(z)),
                                      bend * 180 / std::numbers::pi});
                }
                for (Wall& wall : run.walls) {
                    if (wall.z_mm < from || wall.z_mm > to) continue;
                    const double off = radiusAt_mm(run, wall.z_mm) - one.radiusAt_mm(wall.z_mm);
                    wall.r_mm -= off;
                    wall.form_mm += off;
                }
                run.elements.erase(run.elements.begin() + static_cast<std::ptrdiff_t>(i),
                                   run.elements.begin() + static_cast<std::ptrdiff_t>(j));
                run.elements[i] = one;
                run.nodes_mm.erase(run.nodes_mm.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                                   run.nodes_mm.begin() + static_cast<std::ptrdiff_t>(j) + 1);
                for (const std::size_t k : {i - 1, i + 1}) {
                    if (k >= run.elements.size() || !run.elements[k].arc) continue;
                    if (k + 1 == i) run.elements[k].end = Tie::Free;
                    if (k == i + 1) run.elements[k].start = Tie::Free;
                }
                resolve(model, run);
                break;
            }
    return merged;
}

}  // namespace lathelier::features
