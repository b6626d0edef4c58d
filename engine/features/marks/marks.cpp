#include "engine/features/marks/marks.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include "engine/core/statistics.h"
#include "engine/core/units.h"
#include "engine/features/structure/mark_proof.h"
#include "engine/features/walls/crest.h"

namespace lathelier::features {
namespace {

constexpr int markSectors = 144;
constexpr double mapCell_mm = 1;
constexpr int mostStarts = 8;
constexpr int mostTeeth = 160;

/// Run and element of the model at z, or none in gaps and rough zones.
const Run* runAt(const Model& model, double z_mm)
{
    for (const Run& run : model.runs)
        if (z_mm > run.nodes_mm.front() && z_mm < run.nodes_mm.back())
            return run.elements.front().rough ? nullptr : &run;
    return nullptr;
}

/// Points further from the model belong to a mark.
double offLimit_mm(const Model& model)
{
    return 5 * model.sigma_mm + 0.1;
}

/// Points of one region of the map.
struct Region {
    std::vector<std::uint32_t> points;
    std::size_t cells = 0;
};

/// Radius of the bore at z, or of its run that is nearest; 0 without one.
double boreAt(const Outline* bore, double z_mm)
{
    double nearest = 1e300, radius = 0;
    if (bore)
        for (const Run& run : bore->model.runs) {
            const double at = std::clamp(z_mm, run.nodes_mm.front(), run.nodes_mm.back());
            if (std::abs(z_mm - at) < nearest) {
                nearest = std::abs(z_mm - at);
                radius = radiusAt_mm(run, at);
            }
        }
    return radius;
}

std::vector<Region> regionsOf(const MeridianCloud& cloud, const Model& model, const Outline* bore, double first_mm,
                              double last_mm)
{
    const auto rows = static_cast<std::size_t>(std::clamp((last_mm - first_mm) / mapCell_mm + 1, 1.0, 1e5));
    std::vector<std::array<std::uint32_t, 2>> cells(rows * markSectors, {0, 0});
    std::vector<std::uint32_t> off;
    const auto cellOf = [&](std::size_t i) {
        const auto row = static_cast<std::size_t>((static_cast<double>(cloud.z_mm[i]) - first_mm) / mapCell_mm);
        const auto sector =
            std::min<std::size_t>(markSectors - 1, static_cast<std::size_t>(cloud.turn[i] * markSectors));
        return std::min(row, rows - 1) * markSectors + sector;
    };
    for (std::size_t i = 0; i < cloud.z_mm.size(); ++i) {
        const double z = static_cast<double>(cloud.z_mm[i]);
        if (z < first_mm || z > last_mm) continue;
        const Run* const run = runAt(model, z);
        // Edges are blurred: points there belong to no mark.
        if (!run || z < run->nodes_mm.front() + 0.4 || z > run->nodes_mm.back() - 0.4) continue;
        const double outer = radiusAt_mm(*run, z);
        if (bore && static_cast<double>(cloud.r_mm[i]) < (outer + boreAt(bore, z)) / 2) continue;
        const std::size_t cell = cellOf(i);
        ++cells[cell][0];
        if (std::abs(static_cast<double>(cloud.r_mm[i]) - outer) > offLimit_mm(model)) {
            ++cells[cell][1];
            off.push_back(static_cast<std::uint32_t>(i));
        }
    }
    std::vector<int> label(cells.size(), -1);
    std::vector<Region> regions;
    for (std::size_t seed = 0; seed < cells.size(); ++seed) {
        const auto isOff = [&](std::size_t c) { return cells[c][1] >= 3 && 2 * cells[c][1] > cells[c][0]; };
        if (label[seed] >= 0 || !isOff(seed)) continue;
        const int number = static_cast<int>(regions.size());
        regions.emplace_back();
        std::vector<std::size_t> open{seed};
        label[seed] = number;
        while (!open.empty()) {
            const std::size_t c = open.back();
            open.pop_back();
            ++regions.back().cells;
            const std::size_t row = c / markSectors, sector = c % markSectors;
            const std::array<std::size_t, 4> next{row * markSectors + (sector + 1) % markSectors,
                                                  row * markSectors + (sector + markSectors - 1) % markSectors,
                                                  row + 1 < rows ? c + markSectors : c, row > 0 ? c - markSectors : c};
            for (const std::size_t n : next)
                if (label[n] < 0 && isOff(n)) {
                    label[n] = number;
                    open.push_back(n);
                }
        }
    }
    // Cells beside a region hold its rim.
    std::vector<int> rim = label;
    for (std::size_t c = 0; c < cells.size(); ++c) {
        const std::size_t row = c / markSectors, sector = c % markSectors;
        for (const std::size_t n : {row * markSectors + (sector + 1) % markSectors,
                                    row * markSectors + (sector + markSectors - 1) % markSectors,
                                    row + 1 < rows ? c + markSectors : c, row > 0 ? c - markSectors : c})
            if (rim[c] < 0) rim[c] = label[n];
    }
    for (const std::uint32_t i : off)
        if (const int region = rim[cellOf(i)]; region >= 0)
            regions[static_cast<std::size_t>(region)].points.push_back(i);
    std::erase_if(regions, [](const Region& region) { return region.cells < 6 || region.points.size() < 40; });
    return regions;
}

/// Of the order m among all from -mostTeeth on.
std::size_t indexOfOrder(int m)
{
    const int place = mostTeeth + m;
    return static_cast<std::size_t>(place);
}

double quantile(std::vector<double> values, double share)
{
    return lowerQuantileInPlace(values, share);
}

/// The flat or keyway whose floor the points of a region prove; kind empty without one.
ShaftMark markOf(const MeridianCloud& cloud, const Model& model, const Region& region)
{
    std::vector<Eigen::Vector2d> places;
    std::vector<double> heights, offs;
    double worst = 0;
    for (const std::uint32_t i : region.points) {
        const double angle = turn_rad * static_cast<double>(cloud.turn[i]), r = static_cast<double>(cloud.r_mm[i]),
                     z = static_cast<double>(cloud.z_mm[i]);
        places.emplace_back(r * std::cos(angle), r * std::sin(angle));
        heights.push_back(z);
        if (const Run* run = runAt(model, z)) offs.push_back(r - radiusAt_mm(*run, z));
    }
    for (const double off : offs)
        if (std::abs(off) > std::abs(worst)) worst = off;
    ShaftMark mark;
    mark.z_start_mm = quantile(heights, 0.002);
    mark.z_end_mm = quantile(heights, 0.998);
    // a·x + b·y = 1: the plane at the distance 1/√(a² + b²); points off it by more than 4 σ (the walls of a slot) go.
    Eigen::Vector2d plane(0, 0);
    std::vector<char> use(places.size(), 1);
    double rms = 0, kept = 0;
    for (int round = 0; round < 6; ++round) {
        Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
        Eigen::Vector2d right = Eigen::Vector2d::Zero();
        for (std::size_t i = 0; i < places.size(); ++i) {
            if (!use[i]) continue;
            normal += places[i] * places[i].transpose();
            right += places[i];
        }
        plane = normal.ldlt().solve(right);
        const double distance = 1 / std::max(1e-9, plane.norm());
        std::vector<double> off;
        off.reserve(places.size());
        for (const Eigen::Vector2d& p : places) off.push_back(std::abs((plane.dot(p) - 1) * distance));
        const double limit = std::max(4 * model.sigma_mm, round < 2 ? 3 * quantile(off, 0.5) : 0.0);
        rms = kept = 0;
        for (std::size_t i = 0; i < places.size(); ++i) {
            use[i] = off[i] < limit;
            if (!use[i]) continue;
            rms += off[i] * off[i];
            kept += 1;
        }
        rms = std::sqrt(rms / std::max(1.0, kept));
    }
    const double floor = 1 / std::max(1e-9, plane.norm());
    double angle = std::atan2(plane.y(), plane.x()) * deg_per_rad;
    if (angle < 0) angle += 360;
    mark.angle_deg = angle;
    if (worst >= 0 || kept <= 0.6 * static_cast<double>(places.size()) || rms >= 1.6 * model.sigma_mm) return mark;
    const Eigen::Vector2d along(-plane.y() * floor, plane.x() * floor);
    std::vector<double> across;
    std::vector<FloorPoint> points;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (!use[i]) continue;
        across.push_back(along.dot(places[i]));
        points.push_back({heights[i], across.back(), (plane.dot(places[i]) - 1) * floor});
    }
    if (!isPlane(points, model.sigma_mm)) return mark;
    const double width = quantile(across, 0.998) - quantile(across, 0.002);
    const Run* const run = runAt(model, (*mark.z_start_mm + *mark.z_end_mm) / 2);
    const double radius = run ? radiusAt_mm(*run, (*mark.z_start_mm + *mark.z_end_mm) / 2) : floor;
    switch (floorShape(radius, floor, width, offLimit_mm(model))) {
        case FloorShape::Flat:
            mark.kind = "flat";
            mark.distance_mm = floor;
            break;
        case FloorShape::Keyway:
            mark.kind = "keyway";
            mark.floor_mm = floor;
            break;
        case FloorShape::Neither: return mark;
    }
    mark.width_mm = width;
    return mark;
}

}  // namespace

ShaftMark periodicMark(const MeridianCloud& cloud, double from_mm, double to_mm, double about_mm, double sigma_mm,
                       const Progress& progress)
{
    // Radii on a grid, the mean of each row taken out.
    const double length = to_mm - from_mm, step = std::max(0.05, length / 800);
    const auto rows = static_cast<std::size_t>(length / step);
    constexpr std::size_t columns = 512;
    std::vector<double> sums(rows * columns, 0), counts(rows * columns, 0);
    std::vector<std::uint32_t> points;
    for (std::size_t i = 0; i < cloud.z_mm.size(); ++i) {
        const double z = static_cast<double>(cloud.z_mm[i]), r = static_cast<double>(cloud.r_mm[i]);
        const auto row = static_cast<std::size_t>((z - from_mm) / step);
        if (z < from_mm || row >= rows || std::abs(r - about_mm) > 0.25 * about_mm) continue;
        points.push_back(static_cast<std::uint32_t>(i));
        const auto column = std::min(columns - 1, static_cast<std::size_t>(cloud.turn[i] * columns));
        sums[row * columns + column] += r;
        counts[row * columns + column] += 1;
    }
    ShaftMark mark;
    if (points.size() < 1000 || rows < 20) return mark;
    double mean = 0;
    for (const std::uint32_t i : points)
        mean += static_cast<double>(cloud.r_mm[i]) / static_cast<double>(points.size());
    using Complex = std::complex<double>;
    std::vector<Complex> turns(columns);
    for (std::size_t c = 0; c < columns; ++c)
        turns[c] = std::polar(1.0, -turn_rad * (static_cast<double>(c) + 0.5) / columns);
    // Around the circle first: A_m(z).
    std::vector<std::vector<Complex>> around(2 * mostTeeth + 1, std::vector<Complex>(rows, 0));
    for (std::size_t row = 0; row < rows; ++row) {
        if (row % 32 == 0) progress.check();
        std::array<double, columns> values{};
        for (std::size_t c = 0; c < columns; ++c) {
            const double n = counts[row * columns + c];
            values[c] = n > 0 ? sums[row * columns + c] - n * mean : 0;
        }
        for (int m = 0; m <= mostTeeth; ++m) {
            Complex sum = 0;
            std::size_t place = 0;
            for (std::size_t c = 0; c < columns; ++c) {
                sum += values[c] * turns[place];
                place = (place + static_cast<std::size_t>(m)) % columns;
            }
            // The half step of the first column: the sum runs over c·m, the angle of a column is (c + ½)·m.
            sum *= std::polar(1.0, -turn_rad * 0.5 * m / columns) / turns[0];
            around[indexOfOrder(m)][row] = sum;
            around[indexOfOrder(-m)][row] = std::conj(sum);
        }
    }
    // Then along z, f from 0 upward for both signs of m.
    double best = 0, best_f = 0;
    int best_m = 0;
    const double f_step = 1 / (4 * length), f_most = std::min(5.0, 0.4 / step);
    for (int m = -mostTeeth; m <= mostTeeth; ++m) {
        progress.check();
        const std::vector<Complex>& row = around[indexOfOrder(m)];
        for (double f = m == 0 ? 2 / length : 0; f < (std::abs(m) > mostStarts ? std::min(f_most, 2.0) : f_most);
             f += f_step) {
            if (std::abs(m) <= mostStarts && f < 0.15) continue;
            const Complex turn = std::polar(1.0, -turn_rad * f * step);
            Complex sum = 0, phase = 1;
            for (const Complex& value : row) {
                sum += value * phase;
                phase *= turn;
            }
            if (std::norm(sum) > best) {
                best = std::norm(sum);
                best_f = f;
                best_m = m;
            }
        }
    }
    const double amplitude = 2 * std::sqrt(best) / static_cast<double>(points.size());
    if (amplitude < 3 * sigma_mm / std::sqrt(static_cast<double>(points.size())) + 0.01 || best_m == 0) return mark;
    // f refined on the points themselves.
    const auto power = [&](double f) {
        Complex sum = 0;
        for (const std::uint32_t i : points)
            sum += (static_cast<double>(cloud.r_mm[i]) - mean) *
                   std::polar(1.0, -turn_rad * (f * (static_cast<double>(cloud.z_mm[i]) - from_mm) +
                                                best_m * static_cast<double>(cloud.turn[i])));
        return std::norm(sum);
    };
    double centre = best_f, value = power(centre);
    for (double width = f_step; width > 1e-7; width /= 3) {
        progress.check();
        for (const double f : {centre - width, centre + width})
            if (const double trial = power(f); trial > value) {
                value = trial;
                centre = f;
            }
    }
    mark.z_start_mm = from_mm;
    mark.z_end_mm = to_mm;
    // Folded over the phase: crest and root.
    constexpr std::size_t bins = 64;
    std::array<double, bins> folded{}, filled{};
    for (const std::uint32_t i : points) {
        double phase =
            centre * (static_cast<double>(cloud.z_mm[i]) - from_mm) + best_m * static_cast<double>(cloud.turn[i]);
        phase -= std::floor(phase);
        const auto bin = std::min(bins - 1, static_cast<std::size_t>(phase * bins));
        folded[bin] += static_cast<double>(cloud.r_mm[i]);
        filled[bin] += 1;
    }
    double root = 1e300, explained = 0;
    for (std::size_t b = 0; b < bins; ++b) {
        if (filled[b] <= 0) continue;
        root = std::min(root, folded[b] / filled[b]);
        explained += filled[b] * (folded[b] / filled[b] - mean) * (folded[b] / filled[b] - mean);
    }
    double scatter = 0;
    for (const std::uint32_t i : points) {
        const double off = static_cast<double>(cloud.r_mm[i]) - mean;
        scatter += off * off - sigma_mm * sigma_mm;
    }
    if (explained < proofThresholds.least_explained * scatter) return ShaftMark();
    std::vector<float> crests;
    crests.reserve(points.size());
    for (const std::uint32_t i : points) crests.push_back(cloud.r_mm[i]);
    const std::optional<Crest> found = crestOf(crests, sigma_mm);
    const double crest_mm = found ? found->radius_mm : about_mm;
    if (std::abs(best_m) <= mostStarts) {
        mark.kind = "thread";
        mark.starts = std::abs(best_m);
        // r repeats where f·z + m·turn does: z grows with the turn for m < 0, a right-hand thread.
        mark.hand = best_m < 0 ? 1 : -1;
        mark.pitch_mm = 1 / centre;
        mark.major_mm = 2 * crest_mm;
        mark.minor_mm = 2 * root;
    } else {
        mark.kind = "knurl";
        mark.teeth = std::abs(best_m);
        mark.helix_deg = std::atan(turn_rad * centre / std::abs(best_m) * about_mm) * deg_per_rad;
        std::vector<double> radii;
        radii.reserve(points.size());
        for (const std::uint32_t i : points) radii.push_back(static_cast<double>(cloud.r_mm[i]));
        mark.diameter_mm = 2 * crest_mm;
        mark.depth_mm = crest_mm - quantile(std::move(radii), 0.02);
        mark.pitch_mm = std::numbers::pi * *mark.diameter_mm / *mark.teeth;
        if (*mark.pitch_mm > proofThresholds.most_knurl_pitch_mm) return ShaftMark();
    }
    return mark;
}

namespace {

/// More equal keyways over one stretch than a shaft has are the gaps of teeth.
void dropTeeth(std::vector<ShaftMark>& marks)
{
    const auto alike = [&](const ShaftMark& mark) {
        return static_cast<std::size_t>(std::count_if(marks.begin(), marks.end(), [&](const ShaftMark& other) {
            return other.kind == mark.kind && *other.z_start_mm<*mark.z_end_mm&& * other.z_end_mm> * mark.z_start_mm;
        }));
    };
    std::vector<ShaftMark> kept;
    for (const ShaftMark& mark : marks)
        if (mark.kind != "keyway" || alike(mark) <= proofThresholds.most_alike) kept.push_back(mark);
    marks = std::move(kept);
}

}  // namespace

std::vector<ShaftMark> findMarks(const MeridianCloud& cloud, const Outline& outline, const Outline* bore,
                                 const Progress& progress)
{
    const Model& model = outline.model;
    const double first = model.planes.front().z_mm, last = model.planes.back().z_mm;
    std::vector<ShaftMark> marks;
    for (const Region& region : regionsOf(cloud, model, bore, first, last)) {
        progress.check();
        if (ShaftMark mark = markOf(cloud, model, region); !mark.kind.empty()) marks.push_back(std::move(mark));
    }
    dropTeeth(marks);
    for (const RoughZone& zone : outline.rough) {
        if (zone.eccentric_mm > 0) continue;
        double about = 0;
        for (const Run& run : model.runs)
            if (run.elements.front().rough && run.nodes_mm.front() < (zone.z_start_mm + zone.z_end_mm) / 2)
                about = run.elements.front().level_mm;
        ShaftMark mark = periodicMark(cloud, zone.z_start_mm, zone.z_end_mm, about, model.sigma_mm, progress);
        if (!mark.kind.empty()) marks.push_back(mark);
    }
    std::sort(marks.begin(), marks.end(),
              [](const ShaftMark& a, const ShaftMark& b) { return a.z_start_mm < b.z_start_mm; });
    return marks;
}

}  // namespace lathelier::features
