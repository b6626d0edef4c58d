#include "engine/features/scene/surroundings/seen_surface.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <limits>

#include "engine/core/statistics.h"
#include "engine/features/scene/surroundings/surroundings_limits.h"

namespace lathelier::features {
namespace {

/// No wall that is so rough is one of a surface.
bool isTooRough(const Wall& wall)
{
    return !wall.compact &&
           wall.sigma_mm > std::max(surroundingsLimits.roughest_mm, surroundingsLimits.roughest_share * wall.r_mm);
}

/// A chain without walls at its ends that hold few points, since stray points continue a wall beside a shoulder, and
/// without those of a face. Empty: it has no others.
Chain withoutPoorEnds(const Chain& chain)
{
    std::vector<double> counts;
    for (const Wall& wall : chain.walls) counts.push_back(wall.points);
    const double least = surroundingsLimits.poor_wall_share * upperMedianInPlace(counts);
    const auto is_good = [&](const Wall& wall) { return wall.points >= least && !isTooRough(wall); };
    const auto from = std::find_if(chain.walls.begin(), chain.walls.end(), is_good);
    const auto to = std::find_if(chain.walls.rbegin(), chain.walls.rend(), is_good).base();
    if (from == chain.walls.end()) return {};
    return {{from, to}, chain.bore};
}

/// Coverage of the circle by each chain, as a share of that which as many points have when they lie evenly: the median
/// over slices of its length, since a face at its end is seen all round.
std::vector<double> coveragesOf(const std::vector<Chain>& chains, const MeridianCloud& cloud)
{
    constexpr std::size_t sectors = 72, sample = 100000, slices = 5;
    constexpr double near_mm = 0.3;
    struct Slice {
        std::bitset<sectors> seen;
        double count = 0;
    };
    std::vector<std::array<Slice, slices>> all(chains.size());
    const std::size_t step = std::max<std::size_t>(1, cloud.z_mm.size() / sample);
    for (std::size_t i = 0; i < cloud.z_mm.size(); i += step) {
        const auto z = static_cast<double>(cloud.z_mm[i]), r = static_cast<double>(cloud.r_mm[i]);
        for (std::size_t c = 0; c < chains.size(); ++c) {
            const double first = chains[c].zFirst_mm(), last = chains[c].zLast_mm();
            if (z < first || z > last) continue;
            const std::vector<Wall>& walls = chains[c].walls;
            const auto wall = std::lower_bound(walls.begin(), walls.end(), z,
                                               [](const Wall& one, double at) { return one.z_mm < at; });
            if (isTooRough(*wall) || std::abs(wall->r_mm - r) > near_mm + 2 * wall->sigma_mm) continue;
            const double place = slices * (z - first) / std::max(1e-9, last - first);
            Slice& slice = all[c][std::min(slices - 1, static_cast<std::size_t>(place))];
            slice.seen.set(std::min(sectors - 1, static_cast<std::size_t>(cloud.turn[i] * sectors)));
            slice.count += 1;
        }
    }
    std::vector<double> coverages;
    for (const auto& own : all) {
        std::vector<double> shares;
        shares.reserve(own.size());
        for (const Slice& slice : own)
            shares.push_back(static_cast<double>(slice.seen.count()) / sectors /
                             (1 - std::exp(-std::max(1.0, slice.count) / sectors)));
        coverages.push_back(upperMedianInPlace(shares));
    }
    return coverages;
}

/// The median over the length.
double usualCoverage(const std::vector<Chain>& chains, const std::vector<double>& coverages)
{
    std::vector<double> all;
    for (std::size_t c = 0; c < chains.size(); ++c) all.insert(all.end(), chains[c].walls.size(), coverages[c]);
    return all.empty() ? 1 : upperMedianInPlace(all);
}

double wallPoints(const Chain& chain)
{
    double sum = 0;
    for (const Wall& wall : chain.walls) sum += wall.points;
    return sum;
}

/// Is a chain a surface? One that is mostly rough is when it is long and holds many points (a thread, a knurl), a short
/// one when it is as dense as a surface: scattered points form short chains by chance. Both are seen around the circle.
/// `coverage`: as a share of the usual one.
bool isSurface(const Chain& chain, const MeridianCloud& cloud, double sigma_mm, double coverage)
{
    const double length = chain.zLast_mm() - chain.zFirst_mm(), points = wallPoints(chain);
    std::vector<double> scatter;
    for (const Wall& wall : chain.walls)
        scatter.push_back(wall.compact ? wall.sigma_mm : std::numeric_limits<double>::infinity());
    if (upperMedianInPlace(scatter) > surroundingsLimits.smooth_sigmas * sigma_mm)
        return coverage >= surroundingsLimits.least_rough_coverage && length >= surroundingsLimits.least_rough_mm &&
               points >= surroundingsLimits.least_rough_share * static_cast<double>(cloud.z_mm.size());
    return coverage >= surroundingsLimits.least_coverage &&
           (length >= surroundingsLimits.long_chain_mm ||
            points >= surroundingsLimits.least_density_share * cloud.points_per_mm * length);
}

}  // namespace

SeenSurface::SeenSurface(const MeridianCloud& cloud, const Walls& walls)
    : first_mm_(cloud.z_first_mm - surroundingsLimits.beyond_chain_mm),
      band_mm_(surroundingsLimits.on_sigmas * walls.sigma_mm + surroundingsLimits.on_mm)
{
    const double length = cloud.z_last_mm - cloud.z_first_mm + 2 * surroundingsLimits.beyond_chain_mm;
    const double count = std::ceil(length / surroundingsLimits.surface_step_mm) + 1;
    if (!(count > 0) || count > static_cast<double>(surroundingsLimits.most_surface_bins)) return;
    bins_.resize(static_cast<std::size_t>(count));
    std::vector<Chain> chains;
    for (const Chain& chain : walls.chains)
        if (Chain trimmed = withoutPoorEnds(chain); !trimmed.walls.empty()) chains.push_back(std::move(trimmed));
    const std::vector<double> coverages = coveragesOf(chains, cloud);
    const double usual = usualCoverage(chains, coverages);
    for (std::size_t c = 0; c < chains.size(); ++c)
        if (isSurface(chains[c], cloud, walls.sigma_mm, coverages[c] / usual)) chains_.push_back(std::move(chains[c]));
    for (const Chain& chain : chains_) {
        if (!chain.bore) outside_.push_back(&chain);
        addChain(chain, walls.bin_mm);
    }
    std::sort(outside_.begin(), outside_.end(),
              [](const Chain* a, const Chain* b) { return a->zFirst_mm() < b->zFirst_mm(); });
    addFaces();
    double before = 0;
    for (Bin& bin : bins_) {
        if (bin.outer_mm > 0) before = bin.outer_mm;
        bin.reference_mm = before;
    }
    double behind = 0;
    for (auto bin = bins_.rbegin(); bin != bins_.rend(); ++bin) {
        if (bin->outer_mm > 0) behind = bin->outer_mm;
        if (behind > 0 && (bin->reference_mm == 0 || behind < bin->reference_mm)) bin->reference_mm = behind;
        if (bin->outer_mm > 0) bin->reference_mm = bin->outer_mm;
    }
}

SeenSurface::Bin* SeenSurface::binAt(double z_mm)
{
    const double place = (z_mm - first_mm_) / surroundingsLimits.surface_step_mm;
    return place >= 0 && place < static_cast<double>(bins_.size()) ? &bins_[static_cast<std::size_t>(place)] : nullptr;
}

const SeenSurface::Bin* SeenSurface::binAt(double z_mm) const
{
    const double place = (z_mm - first_mm_) / surroundingsLimits.surface_step_mm;
    return place >= 0 && place < static_cast<double>(bins_.size()) ? &bins_[static_cast<std::size_t>(place)] : nullptr;
}

void SeenSurface::addChain(const Chain& chain, double bin_mm)
{
    const std::vector<Wall>& walls = chain.walls;
    const double from = chain.zFirst_mm() - surroundingsLimits.beyond_chain_mm,
                 to = chain.zLast_mm() + surroundingsLimits.beyond_chain_mm;
    for (std::size_t b = 0; b < bins_.size(); ++b) {
        const double z = first_mm_ + surroundingsLimits.surface_step_mm * (static_cast<double>(b) + 0.5);
        if (z < from || z > to) continue;
        const auto next =
            std::lower_bound(walls.begin(), walls.end(), z, [](const Wall& one, double at) { return one.z_mm < at; });
        const auto near = static_cast<std::size_t>(std::min(next, walls.end() - 1) - walls.begin());
        const Wall& wall = walls[near];
        if (isTooRough(wall)) continue;
        const Wall& before = walls[near > surroundingsLimits.slope_walls ? near - surroundingsLimits.slope_walls : 0];
        const Wall& behind = walls[std::min(near + surroundingsLimits.slope_walls, walls.size() - 1)];
        const double dz = behind.z_mm - before.z_mm, lean = dz > 0 ? (behind.r_mm - before.r_mm) / dz : 0;
        const double slope = std::abs(lean) < surroundingsLimits.steepest_slope ? lean : 0;
        const double half =
            band_mm_ * std::hypot(1, slope) + (wall.compact ? 0 : surroundingsLimits.rough_sigmas * wall.sigma_mm);
        const double r = wall.r_mm + slope * (z - wall.z_mm);
        bins_[b].bands.push_back({r, slope, half, false});
        const bool is_on_wall = z > chain.zFirst_mm() - bin_mm && z < chain.zLast_mm() + bin_mm;
        if (is_on_wall && !chain.bore) bins_[b].outer_mm = std::max(bins_[b].outer_mm, r);
    }
}

void SeenSurface::addFaces()
{
    for (std::size_t c = 0; c < outside_.size(); ++c) {
        const Chain& chain = *outside_[c];
        const Wall &first = chain.walls.front(), &last = chain.walls.back();
        const bool has_next = c + 1 < outside_.size(), has_last = c > 0;
        const double apart = has_next ? outside_[c + 1]->zFirst_mm() - last.z_mm : 1e300;
        const double apart_before = has_last ? first.z_mm - outside_[c - 1]->zLast_mm() : 1e300;
        if (apart <= surroundingsLimits.shoulder_mm) {
            const Wall& next = outside_[c + 1]->walls.front();
            addFace(std::min(last.z_mm, next.z_mm), std::max(last.z_mm, next.z_mm), std::min(last.r_mm, next.r_mm),
                    std::max(last.r_mm, next.r_mm));
        } else {
            addFace(last.z_mm, last.z_mm, 0, last.r_mm);
        }
        if (apart_before > surroundingsLimits.shoulder_mm) addFace(first.z_mm, first.z_mm, 0, first.r_mm);
    }
}

void SeenSurface::addFace(double from_mm, double to_mm, double low_mm, double high_mm)
{
    for (double z = from_mm - surroundingsLimits.face_mm; z <= to_mm + surroundingsLimits.face_mm;
         z += surroundingsLimits.surface_step_mm)
        if (Bin* const bin = binAt(z))
            bin->bands.push_back({(low_mm + high_mm) / 2, 0, (high_mm - low_mm) / 2 + band_mm_, true});
}

SeenSurface::Place SeenSurface::placeOf(double z_mm, double r_mm) const
{
    const double place = (z_mm - first_mm_) / surroundingsLimits.surface_step_mm;
    if (!(place >= 0 && place < static_cast<double>(bins_.size()))) return Place::Off;
    const auto b = static_cast<std::size_t>(place);
    const double from_middle = surroundingsLimits.surface_step_mm * (place - static_cast<double>(b) - 0.5);
    Place found = Place::Off;
    for (const Band& band : bins_[b].bands) {
        if (std::abs(r_mm - band.r_mm - band.slope * from_middle) > band.half_mm) continue;
        if (!band.face) return Place::Wall;
        found = Place::Face;
    }
    return found;
}

double SeenSurface::outer_mm(double z_mm) const
{
    if (bins_.empty()) return 0;
    const double last = static_cast<double>(bins_.size() - 1);
    return bins_[static_cast<std::size_t>(
                     std::clamp((z_mm - first_mm_) / surroundingsLimits.surface_step_mm, 0.0, last))]
        .reference_mm;
}

bool SeenSurface::isSeen(double z_mm) const
{
    const Bin* const bin = binAt(z_mm);
    return bin && bin->outer_mm > 0;
}

}  // namespace lathelier::features
