#include "engine/features/outline/stretches.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

#include "engine/core/statistics.h"
#include "engine/core/units.h"
#include "engine/features/model/selection.h"
#include "engine/features/outline/outline_limits.h"
#include "engine/features/walls/crest.h"

namespace lathelier::features {
namespace {

/// Walls with more scatter than noise and slope explain, over at least 2.5 mm, extended by neighbours with
/// significantly increased scatter, where grooves run out into a cone.
struct RoughWalls {
    std::size_t from = 0, to = 0;            ///< indices of the rough walls, `to` excluded
    std::size_t wide_from = 0, wide_to = 0;  ///< extended to walls that a groove may reach
};

double longestLead_mm(double zone_mm)
{
    return std::min(stretchLimits.longest_lead_mm, zone_mm / stretchLimits.longest_lead_part);
}

std::vector<RoughWalls> roughStretches(const std::vector<Wall>& walls, double sigma_mm, bool radial)
{
    const StretchLimits& limits = stretchLimits;
    std::vector<char> rough(walls.size(), 0), scattered(walls.size(), 0);
    for (std::size_t i = 0; i < walls.size(); ++i) {
        // Noise along the normal of a slope is larger along the radius; that of rays across the axis acts along the
        // radius.
        const double slope = slopeAt(walls, i), square = slope * slope,
                     spread = square * (walls[i].width_mm * walls[i].width_mm + limits.assumed_spot_mm2) / 12;
        const double least = limits.least_scatter_mm * limits.least_scatter_mm;
        const double explained = std::sqrt(sigma_mm * sigma_mm * (radial ? 1 : 1 + square) + least + spread);
        const double chance = limits.rough_errors * (1 / std::sqrt(2 * std::max(1.0, walls[i].points)));
        rough[i] = walls[i].sigma_mm > (limits.rough_ratio + chance) * explained;
        scattered[i] = walls[i].sigma_mm > (1 + chance) * explained;
    }
    std::vector<RoughWalls> stretches;
    for (std::size_t i = 0; i < walls.size();) {
        if (!rough[i]) {
            ++i;
            continue;
        }
        std::size_t last = i, smooth = 0;
        for (std::size_t j = i + 1; j < walls.size() && smooth < limits.most_smooth_walls; ++j) {
            smooth = rough[j] ? 0 : smooth + 1;
            if (rough[j]) last = j;
        }
        const std::size_t next = last + 1;
        if (walls[last].z_mm - walls[i].z_mm >= limits.shortest_rough_mm) {
            std::size_t from = i, to = next;
            const std::size_t least = stretches.empty() ? 0 : stretches.back().wide_to;
            const double reach = longestLead_mm(walls[last].z_mm - walls[i].z_mm);
            for (std::size_t j = i; j-- > least && i - j <= limits.most_faded_walls + (i - from);)
                if (scattered[j] && walls[i].z_mm - walls[j].z_mm < reach) from = j;
            for (std::size_t j = next; j < walls.size() && j - to <= limits.most_faded_walls; ++j)
                if (scattered[j] && walls[j].z_mm - walls[last].z_mm < reach) to = j + 1;
            from = std::max(least, from - std::min(from, limits.walls_beyond));
            stretches.push_back({i, next, from, std::min(walls.size(), to + limits.walls_beyond)});
        }
        i = next;
    }
    return stretches;
}

/// Two lines without a common corner: a step of the radius.
bool isStep(const Element& a, const Element& b, double z, double error_mm)
{
    if (a.arc || b.arc) return false;
    const double jump = b.radiusAt_mm(z) - a.radiusAt_mm(z), bend = a.slope - b.slope;
    if (std::abs(jump) < stretchLimits.step_errors * error_mm) return false;
    return std::abs(bend) < stretchLimits.step_parallel_slope || std::abs(jump / bend) > stretchLimits.step_reach_mm;
}

/// Cuts walls of one chain into stretches at steps.
void addStretches(std::vector<Stretch>& stretches, const std::vector<Wall>& walls, const std::vector<Wall>& crests,
                  bool trim_start, bool trim_end, double form_mm, Border after, std::vector<MergedJunction>& merged,
                  const Progress& progress)
{
    std::vector<Piece> pieces = cutIntoPieces(walls, progress);
    if (pieces.empty()) return;
    const auto isBlur = [](const Piece& piece) { return piece.end - piece.begin <= stretchLimits.blurred_end_walls; };
    if (trim_start && pieces.size() > 1 && isBlur(pieces.front())) pieces.erase(pieces.begin());
    if (trim_end && pieces.size() > 1 && isBlur(pieces.back())) pieces.pop_back();
    std::vector<Wear> worn;
    mergeWear(pieces, walls, form_mm, merged, worn);
    const std::vector<Element> elements = elementsOf(pieces, walls, form_mm);
    const std::size_t merged_parts = worn.size();
    for (std::size_t k = 0; k < elements.size(); ++k) {
        const Piece& was = pieces[k];
        const double from = walls[was.begin].z_mm, to = walls[was.end - 1].z_mm;
        const auto covers = [&](const Wear& wear) { return wear.from_mm < to && wear.to_mm > from; };
        const auto parts = worn.begin() + static_cast<std::ptrdiff_t>(merged_parts);
        if (elements[k].arc || std::any_of(worn.begin(), parts, covers)) continue;
        if (!was.arc && (!elements[k].cylinder || !isSignificantSlope(was))) continue;
        Piece now = was;
        now.arc = false;
        now.slope = elements[k].slope;
        worn.push_back({from, to, was, now});
    }
    Stretch stretch;
    stretch.from_mm = walls.front().z_mm;
    stretch.nodes_mm = {walls.front().z_mm};
    for (std::size_t k = 0; k < elements.size(); ++k) {
        stretch.elements.push_back(elements[k]);
        const bool last = k + 1 == elements.size();
        const double z =
            last ? walls.back().z_mm : (walls[pieces[k].end - 1].z_mm + walls[pieces[k + 1].begin].z_mm) / 2;
        stretch.nodes_mm.push_back(z);
        const Wall& wall = walls[pieces[k].end - 1];
        const double few = static_cast<double>(
            std::min(pieces[k].end - pieces[k].begin, last ? std::size_t{1} : pieces[k + 1].end - pieces[k + 1].begin));
        const double error = 2 * wall.sigma_mm / std::sqrt(std::max(1.0, wall.points * few));
        if (!last && !isStep(elements[k], elements[k + 1], z, error)) continue;
        stretch.to_mm = z;
        stretch.after = last ? after : Border::Step;
        const auto isWithin = [&](const Wall& one) {
            return one.z_mm >= stretch.from_mm - meet_mm && one.z_mm <= z + meet_mm;
        };
        std::copy_if(walls.begin(), walls.end(), std::back_inserter(stretch.coarse), isWithin);
        std::copy_if(crests.begin(), crests.end(), std::back_inserter(stretch.crests), isWithin);
        for (const Wear& wear : worn)
            if (wear.to_mm > stretch.from_mm && wear.from_mm < z) stretch.worn.push_back(wear);
        stretches.push_back(stretch);
        stretch = {};
        stretch.from_mm = z;
        stretch.nodes_mm = {z};
    }
}

/// What is the same all along a stretch: radius, how far its circle is off the axis, lobes.
struct Circle {
    double radius_mm = 0, offset_mm = 0;
    double lobe_mm = 0;   ///< largest amplitude of the harmonics above the first, without those of the offset
    double sigma_mm = 0;  ///< robust scatter about all of these
    double root_mm = 0;   ///< 2 % quantile of the radius
    std::optional<Crest> crest;
};

constexpr int circleHarmonics = 8;
using Harmonics = Eigen::Matrix<double, 2 * circleHarmonics + 1, 1>;

Harmonics harmonicsAt(double angle)
{
    Harmonics row;
    row[0] = 1;
    for (Eigen::Index k = 1; k <= circleHarmonics; ++k) {
        row[2 * k - 1] = std::cos(static_cast<double>(k) * angle);
        row[2 * k] = std::sin(static_cast<double>(k) * angle);
    }
    return row;
}

Circle circleOf(const MeridianCloud& cloud, double from_mm, double to_mm, double about_mm, double sigma_mm)
{
    std::vector<std::pair<double, double>> points;
    std::vector<double> all;
    for (std::size_t i = 0; i < cloud.z_mm.size(); ++i) {
        const double z = static_cast<double>(cloud.z_mm[i]), r = static_cast<double>(cloud.r_mm[i]);
        if (!(z > from_mm && z < to_mm) || std::abs(r - about_mm) > stretchLimits.zone_reach_share * about_mm) continue;
        points.emplace_back(2 * std::numbers::pi * static_cast<double>(cloud.turn[i]), r);
        all.push_back(r);
    }
    Circle circle;
    if (points.size() < stretchLimits.least_circle_points) return circle;
    // The walls of an eccentric have the radius of one side or the other.
    about_mm = upperMedianInPlace(all);
    const double reach = std::max(stretchLimits.circle_reach_mm, stretchLimits.circle_reach_share * about_mm);
    std::erase_if(points, [&](const auto& point) { return std::abs(point.second - about_mm) >= reach; });
    if (points.size() < stretchLimits.least_circle_points) return circle;
    Harmonics found = Harmonics::Zero();
    found[0] = about_mm;
    double limit = std::numeric_limits<double>::infinity();
    for (int round = 0; round < stretchLimits.circle_rounds; ++round) {
        Eigen::Matrix<double, 2 * circleHarmonics + 1, 2 * circleHarmonics + 1> normal =
            decltype(normal)::Identity() * stretchLimits.circle_regularisation;
        Harmonics right = Harmonics::Zero();
        std::vector<double> offs;
        for (const auto& [angle, r] : points) {
            const Harmonics row = harmonicsAt(angle);
            const double off = r - row.dot(found);
            offs.push_back(std::abs(off));
            if (std::abs(off) > limit) continue;
            normal.selfadjointView<Eigen::Lower>().rankUpdate(row);
            right += row * r;
        }
        found = normal.selfadjointView<Eigen::Lower>().ldlt().solve(right);
        circle.sigma_mm = madToSigma * upperMedianInPlace(offs);
        limit = stretchLimits.circle_outlier_sigmas * circle.sigma_mm;
    }
    circle.offset_mm = found.segment<2>(1).norm();
    // A circle at an offset e has the radius R - e²/4R on the mean and a second harmonic of e²/4R.
    const double of_offset = circle.offset_mm * circle.offset_mm / (4 * about_mm);
    circle.radius_mm = found[0] + of_offset;
    for (int k = 2; k <= circleHarmonics; ++k)
        circle.lobe_mm = std::max(circle.lobe_mm, found.segment<2>(2 * k - 1).norm() - (k == 2 ? of_offset : 0));
    std::vector<float> radii;
    radii.reserve(points.size());
    for (const auto& point : points) radii.push_back(static_cast<float>(point.second));
    circle.crest = crestOf(radii, sigma_mm);
    circle.root_mm = static_cast<double>(quantileInPlace(radii, stretchLimits.root_share));
    return circle;
}

/// A rough zone as one cylinder over its crests, and the cones that lead into it.
struct RoughStretch {
    Stretch stretch;
    double eccentric_mm = 0;
    std::vector<Wall> lead_in, lead_out;  ///< in order of z
};

/// None: its scatter is that of lobes, which leave the radius that of a wall.
std::optional<RoughStretch> roughStretch(const OutlineInput& input, const std::vector<Wall>& walls,
                                         RoughWalls& rough_walls)
{
    const auto [from, to, wide_from, wide_to] = rough_walls;
    RoughStretch rough;
    Stretch& stretch = rough.stretch;
    const double half = input.coarse.bin_mm / 2;
    stretch.from_mm = walls[from].z_mm;
    stretch.to_mm = walls[to - 1].z_mm;
    stretch.coarse.assign(walls.begin() + static_cast<std::ptrdiff_t>(from),
                          walls.begin() + static_cast<std::ptrdiff_t>(to));
    double mean = 0;
    for (const Wall& wall : stretch.coarse) mean += wall.r_mm / static_cast<double>(stretch.coarse.size());
    const Circle circle = circleOf(input.cloud, stretch.from_mm, stretch.to_mm, mean, input.coarse.sigma_mm);
    const bool is_even = circle.sigma_mm > 0 && circle.sigma_mm < stretchLimits.eccentric_ratio * input.coarse.sigma_mm;
    const bool eccentric = is_even && circle.offset_mm > stretchLimits.least_eccentricity_mm;
    if (is_even && !eccentric && circle.lobe_mm < stretchLimits.largest_lobe_mm) return std::nullopt;
    Element cylinder;
    cylinder.cylinder = cylinder.rough = true;
    cylinder.level_mm = eccentric ? circle.radius_mm : circle.crest ? circle.crest->radius_mm : mean;
    cylinder.level_sigma_mm = circle.crest && !eccentric ? circle.crest->sigma_mm : input.coarse.sigma_mm;
    cylinder.root_mm = eccentric || circle.root_mm <= 0 ? cylinder.level_mm : circle.root_mm;
    if (eccentric) rough.eccentric_mm = circle.offset_mm;
    if (circle.crest && !eccentric) {
        const double longest = longestLead_mm(stretch.to_mm - stretch.from_mm);
        const auto lead = [&](double border, bool toward_end) {
            return leadIn(input.cloud, border, toward_end, longest, cylinder.level_mm, input.coarse.sigma_mm);
        };
        const Lead in = lead(walls[wide_from].z_mm - half, true), out = lead(walls[wide_to - 1].z_mm + half, false);
        rough.lead_in = in.walls;
        rough.lead_out = out.walls;
        if (!in.walls.empty()) {
            stretch.from_mm = in.reached_mm;
            rough_walls.from = wide_from;
        }
        if (!out.walls.empty()) {
            stretch.to_mm = out.reached_mm;
            rough_walls.to = wide_to;
        }
    }
    cylinder.at_mm = (stretch.from_mm + stretch.to_mm) / 2;
    stretch.elements = {cylinder};
    stretch.nodes_mm = {stretch.from_mm, stretch.to_mm};
    return rough;
}

}  // namespace

double slopeAt(const std::vector<Wall>& walls, std::size_t i)
{
    const std::size_t a = i > 0 ? i - 1 : i, b = std::min(i + 1, walls.size() - 1);
    const double dz = walls[b].z_mm - walls[a].z_mm;
    return dz > 0 ? (walls[b].r_mm - walls[a].r_mm) / dz : 0;
}

std::vector<const Chain*> chainsOf(const Walls& walls, bool bore)
{
    std::vector<const Chain*> chains;
    for (const Chain& chain : walls.chains)
        if (chain.bore == bore) chains.push_back(&chain);
    std::vector<const Chain*> kept;
    for (const Chain* one : chains) {
        const bool hidden = std::any_of(chains.begin(), chains.end(), [&](const Chain* other) {
            if (other == one || other->walls.size() <= one->walls.size()) return false;
            const double from = std::max(one->zFirst_mm(), other->zFirst_mm()),
                         to = std::min(one->zLast_mm(), other->zLast_mm());
            return to - from > stretchLimits.coverage_share * (one->zLast_mm() - one->zFirst_mm());
        });
        if (!hidden) kept.push_back(one);
    }
    std::sort(kept.begin(), kept.end(), [](const Chain* a, const Chain* b) {
        return a->zFirst_mm() + a->zLast_mm() < b->zFirst_mm() + b->zLast_mm();
    });
    return kept;
}

std::vector<Stretch> stretchesOf(const OutlineInput& input, Outline& outline, const Progress& progress)
{
    const std::vector<const Chain*> chains = chainsOf(input.coarse, input.bore);
    std::vector<Stretch> stretches;
    for (std::size_t c = 0; c < chains.size(); ++c) {
        const std::vector<Wall>& walls = chains[c]->walls;
        Border after = Border::End;
        bool trim_end = false;
        if (c + 1 < chains.size()) {
            const double from = walls.back().z_mm, to = chains[c + 1]->zFirst_mm();
            const bool is_cut = std::any_of(input.cuts.begin(), input.cuts.end(), [&](const Cut& cut) {
                return cut.liesBetween(from, to, input.coarse.bin_mm);
            });
            after = is_cut || to - from > stretchLimits.data_gap_mm ? Border::Gap : Border::Shoulder;
            trim_end = after == Border::Shoulder;
        }
        const bool trim_start = !stretches.empty() && stretches.back().after == Border::Shoulder;
        std::size_t at = 0;
        std::vector<Wall> lead_out;  // of the rough zone before
        const auto addQuiet = [&](std::size_t from, std::size_t to, const std::vector<Wall>& lead_in, Border border,
                                  bool trim) {
            std::vector<Wall> own = lead_out;
            own.insert(own.end(), walls.begin() + static_cast<std::ptrdiff_t>(from),
                       walls.begin() + static_cast<std::ptrdiff_t>(to));
            own.insert(own.end(), lead_in.begin(), lead_in.end());
            if (own.size() < stretchLimits.least_walls) return false;
            std::vector<Wall> crests = lead_out;
            crests.insert(crests.end(), lead_in.begin(), lead_in.end());
            addStretches(stretches, own, crests, (trim_start && from == 0) || (from > 0 && lead_out.empty()),
                         trim && lead_in.empty(), input.form_mm, border, outline.merged, progress);
            return true;
        };
        for (RoughWalls& rough_walls : roughStretches(walls, input.coarse.sigma_mm, input.scanner.has_value())) {
            std::optional<RoughStretch> found = roughStretch(input, walls, rough_walls);
            if (!found) continue;
            RoughStretch& rough = *found;
            const auto [from, to, wide_from, wide_to] = rough_walls;
            addQuiet(at, from, rough.lead_in, rough.lead_in.empty() ? Border::Rough : Border::Lead, true);
            rough.stretch.after = !rough.lead_out.empty() ? Border::Lead : to < walls.size() ? Border::Rough : after;
            outline.rough.push_back({rough.stretch.from_mm, rough.stretch.to_mm, rough.eccentric_mm});
            stretches.push_back(rough.stretch);
            lead_out = rough.lead_out;
            at = to;
        }
        if (!addQuiet(at, walls.size(), {}, after, trim_end) && !stretches.empty()) stretches.back().after = after;
    }
    return stretches;
}

}  // namespace lathelier::features
