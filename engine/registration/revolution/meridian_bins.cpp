#include "engine/registration/revolution/meridian_bins.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "engine/core/statistics.h"
#include "engine/core/units.h"
#include "engine/registration/revolution/quick_turn.h"

namespace lathelier::registration {
namespace {

constexpr double edgeScatterRatio =
    2.5;  // ratio of a bin's scatter to the median of the bins: above it the bin contains an edge
constexpr double roughScatterRatio = 1.7;  // ratio to the scatter of the quiet bins: above it the bin is rough
constexpr double leastFacePointShare =
    0.02;  // of all points: a face with fewer adds more systematic error than information about the axis

struct MeridianPoint {
    double z;
    double r;
};

/// The points of each bin: those of bin b are items[first[b]] … items[first[b + 1] - 1].
struct BinOrder {
    std::vector<std::size_t> first;
    std::vector<std::size_t> items;
};

template <class Key>
BinOrder sortInto(std::size_t bins, std::size_t count, Key key)
{
    BinOrder sorted;
    sorted.first.assign(bins + 1, 0);
    std::vector<int> keys(count);
    for (std::size_t i = 0; i < count; ++i) {
        keys[i] = key(i);
        if (keys[i] >= 0) ++sorted.first[static_cast<std::size_t>(keys[i]) + 1];
    }
    for (std::size_t b = 0; b < bins; ++b) sorted.first[b + 1] += sorted.first[b];
    sorted.items.resize(sorted.first.back());
    std::vector<std::size_t> place(sorted.first.begin(), sorted.first.end() - 1);
    for (std::size_t i = 0; i < count; ++i)
        if (keys[i] >= 0) sorted.items[place[static_cast<std::size_t>(keys[i])]++] = i;
    return sorted;
}

/// Slopes from both neighbours where they agree on one; 0 elsewhere (an edge, a lone bin, or flat within the noise).
void slopesOf(MeridianBin* bins, int count, double step)
{
    for (int i = 0; i < count; ++i) {
        MeridianBin& bin = bins[i];
        bin.slope = 0;
        if (!bin.active) continue;
        const bool before = i > 0 && bins[i - 1].active;
        const bool after = i + 1 < count && bins[i + 1].active;
        if (before && after) {
            const double rise1 = bin.value - bins[i - 1].value;
            const double rise2 = bins[i + 1].value - bin.value;
            const double noise = 4 * bin.sigma / std::sqrt(std::max(1.0, bin.points));
            if (std::abs(rise1 - rise2) < noise + 0.5 * std::abs(rise1 + rise2) / 2 && std::abs(rise1 + rise2) > noise)
                bin.slope = (rise1 + rise2) / (2 * step);
        }
        bin.cosine = 1 / std::sqrt(1 + bin.slope * bin.slope);
    }
}

/// Scatter of a bin and the number of points it was found from.
struct Scatter {
    double sigma;
    double points;
};

double typical(const std::vector<Scatter>& scatters)
{
    std::vector<double> values;
    values.reserve(scatters.size());
    for (const Scatter& s : scatters) values.push_back(s.sigma);
    return values.empty() ? 0.0 : upperMedianInPlace(values);
}

/// 20 % quantile of the scatter of the bins when it is lower than the median by a third (then the median is that of a
/// thread or a knurl); else 0. Bins with few points are left out: their scatter is too uncertain.
double quiet(const std::vector<Scatter>& scatters, double middle)
{
    constexpr double leastBinPoints = 20;
    std::vector<double> values;
    for (const Scatter& s : scatters)
        if (s.points >= leastBinPoints) values.push_back(s.sigma);
    if (values.size() < 15) return 0;
    const double fifth = quantileInPlace(values, 0.2);
    return 1.1 * fifth < middle * 2 / 3 ? fifth : 0;
}

/// Median and scatter of each bin; bins without enough points stay inactive.
template <class Along, class Across>
std::vector<Scatter> fillBins(MeridianBin* bins, int count, double start, double step, const BinOrder& sorted,
                              Along along, Across across, double least_points)
{
    std::vector<double> values;
    for (int b = 0; b < count; ++b) {
        MeridianBin& bin = bins[b];
        bin.middle = start + (b + 0.5) * step;
        values.clear();
        const auto bin_index = static_cast<std::size_t>(b);
        for (std::size_t k = sorted.first[bin_index]; k < sorted.first[bin_index + 1]; ++k)
            values.push_back(across(sorted.items[k]));
        bin.points = static_cast<double>(values.size());
        bin.active = bin.points >= least_points;
        if (!values.empty()) bin.value = upperMedianInPlace(values);
    }
    const auto measure = [&] {
        std::vector<Scatter> scatters;
        for (int b = 0; b < count; ++b) {
            MeridianBin& bin = bins[b];
            const auto bin_index = static_cast<std::size_t>(b);
            if (!bin.active) continue;
            values.clear();
            for (std::size_t k = sorted.first[bin_index]; k < sorted.first[bin_index + 1]; ++k) {
                const std::size_t i = sorted.items[k];
                values.push_back(std::abs(across(i) - bin.value - bin.slope * (along(i) - bin.middle)));
            }
            bin.sigma = bin.own_mm = madToSigma * upperMedianInPlace(values) * bin.cosine;
            scatters.push_back({bin.sigma, bin.points});
        }
        return scatters;
    };
    measure();
    slopesOf(bins, count, step);
    return measure();
}

/// A scan that shows a bore and the outside: radii of one bin in two walls.
/// The radius between them, NaN where there is one wall. A mark (the floor of a keyway) is no wall: its points lie
/// where those of the other wall are absent. A shoulder is none either: its bins are few, a bore runs on.
std::vector<double> findSplits(const std::vector<Eigen::Vector3d>& sample, const Eigen::Isometry3d& axis_T_scan,
                               const std::vector<MeridianPoint>& points, const BinOrder& by_z, double largest)
{
    constexpr double wallGap_mm = 0.4;
    constexpr double sharedSectorShare = 0.55;
    constexpr std::size_t longestStretchCount =
        120;  // walls are sought in stretches longer than a bin, since a bore has few points
    const std::size_t bins = by_z.first.size() - 1;
    const std::size_t merged = (bins + longestStretchCount - 1) / longestStretchCount;
    const std::size_t count = (bins + merged - 1) / merged;
    std::vector<double> splits(count, notANumber);
    std::vector<double> radii;
    const auto scatterOf = [&](std::size_t from, std::size_t to) {  // of sorted radii
        std::vector<double> off;
        const double middle = radii[(from + to) / 2];
        for (std::size_t k = from; k < to; ++k) off.push_back(std::abs(radii[k] - middle));
        return madToSigma * upperMedianInPlace(off);
    };
    for (std::size_t b = 0; b < count; ++b) {
        const std::size_t from = by_z.first[b * merged];
        const std::size_t to = by_z.first[std::min(bins, (b + 1) * merged)];
        radii.clear();
        for (std::size_t k = from; k < to; ++k) radii.push_back(points[by_z.items[k]].r);
        const std::size_t least = std::max<std::size_t>(6, radii.size() * 8 / 100);
        if (radii.size() < 2 * least) continue;
        const double gap = std::min(wallGap_mm, 0.05 * largest);
        const auto [smallest, greatest] = std::minmax_element(radii.begin(), radii.end());
        if (*greatest - *smallest < gap) continue;
        std::sort(radii.begin(), radii.end());
        for (std::size_t place = least; place + least <= radii.size(); ++place) {  // the innermost gap
            const double wide = radii[place] - radii[place - 1];
            if (wide < gap || wide < 8 * scatterOf(0, place)) continue;
            const double split = (radii[place - 1] + radii[place]) / 2;
            std::uint32_t inner = 0, outer = 0;
            for (std::size_t k = from; k < to; ++k) {
                const std::size_t i = by_z.items[k];
                const Eigen::Vector3d p = axis_T_scan * sample[i];
                const double turn = quickTurn(p.y(), p.x()) + 0.5;
                (points[i].r < split ? inner : outer) |= 1u << std::min(31, static_cast<int>(turn * 32));
            }
            if (std::popcount(inner & outer) >= sharedSectorShare * std::popcount(inner)) {
                splits[b] = split;
                break;
            }
        }
    }
    std::vector<double> kept(bins, notANumber);
    for (std::size_t b = 0; b < count; ++b) {
        if (std::isnan(splits[b])) continue;
        int others = 0;
        for (std::size_t k = b < 2 ? 0 : b - 2; k < std::min(count, b + 3); ++k)
            if (k != b && !std::isnan(splits[k])) ++others;
        if (others < 2) continue;
        for (std::size_t k = b * merged; k < std::min(bins, (b + 1) * merged); ++k) kept[k] = splits[b];
    }
    return kept;
}

}  // namespace

MeridianBins makeBins(const std::vector<Eigen::Vector3d>& sample, const Eigen::Isometry3d& axis_T_scan, int count)
{
    std::vector<MeridianPoint> points(sample.size());
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    std::vector<double> radii(sample.size());
    for (std::size_t i = 0; i < sample.size(); ++i) {
        const Eigen::Vector3d p = axis_T_scan * sample[i];
        points[i] = {p.z(), p.head<2>().norm()};
        radii[i] = points[i].r;
        low = std::min(low, p.z());
        high = std::max(high, p.z());
    }
    const double largest = quantileInPlace(radii, 0.99);

    MeridianBins result;
    count = std::clamp(static_cast<int>(sample.size() / 30), 5, count);
    const double extent = std::max(high - low, largest);
    result.step_mm = extent / count * (1 + 1e-9);
    result.z_start_mm = low;
    result.size_mm = extent / 2;
    result.largest_mm = largest;
    result.side_count = static_cast<int>((high - low) / result.step_mm) + 1;
    result.face_columns = static_cast<int>(largest / result.step_mm) + 1;
    const auto sides = static_cast<std::size_t>(result.side_count);
    const auto sideOf = [&](std::size_t i) {
        return std::min(result.side_count - 1, static_cast<int>((points[i].z - low) / result.step_mm));
    };
    BinOrder by_z = sortInto(sides, points.size(), sideOf);
    result.split_mm = findSplits(sample, axis_T_scan, points, by_z, largest);
    const bool bored = std::any_of(result.split_mm.begin(), result.split_mm.end(), [](double s) { return s == s; });
    if (!bored) result.split_mm.clear();
    const auto inBore = [&](std::size_t i) {
        return bored && points[i].r < result.split_mm[static_cast<std::size_t>(sideOf(i))];
    };
    result.wall_count = bored ? 2 * result.side_count : result.side_count;
    result.bins.resize(static_cast<std::size_t>(result.wall_count));
    if (bored) by_z = sortInto(sides, points.size(), [&](std::size_t i) { return inBore(i) ? -1 : sideOf(i); });
    std::vector<double> filled;
    for (std::size_t b = 0; b < sides; ++b)
        if (by_z.first[b + 1] > by_z.first[b]) filled.push_back(static_cast<double>(by_z.first[b + 1] - by_z.first[b]));
    const auto z_of = [&](std::size_t i) { return points[i].z; };
    const auto r_of = [&](std::size_t i) { return points[i].r; };
    const double least = std::max(4.0, 0.15 * upperMedianInPlace(filled));
    const double floor = 1e-5 * extent;  // lower bound of the scatter, for exact meshes
    std::vector<Scatter> scatters =
        fillBins(result.bins.data(), result.side_count, low, result.step_mm, by_z, z_of, r_of, least);
    if (bored) {
        const BinOrder bore = sortInto(sides, points.size(), [&](std::size_t i) { return inBore(i) ? sideOf(i) : -1; });
        std::vector<double> own_filled;
        for (std::size_t b = 0; b < sides; ++b)
            if (bore.first[b + 1] > bore.first[b])
                own_filled.push_back(static_cast<double>(bore.first[b + 1] - bore.first[b]));
        const double own_least = std::max(4.0, 0.15 * upperMedianInPlace(own_filled));
        const std::vector<Scatter> own =
            fillBins(result.bins.data() + sides, result.side_count, low, result.step_mm, bore, z_of, r_of, own_least);
        scatters.insert(scatters.end(), own.begin(), own.end());
    }
    const double middle = typical(scatters);
    const double calm = quiet(scatters, middle);
    result.sigma_mm = std::max(floor, calm > 0 ? calm : middle);
    const double most_scatter = (calm > 0 ? roughScatterRatio : edgeScatterRatio) * result.sigma_mm;
    for (std::size_t b = sides; b < result.bins.size(); ++b) {
        MeridianBin& bin = result.bins[b];
        if (bin.active && bin.sigma > most_scatter) bin.active = false;
        bin.sigma = result.sigma_mm;
    }

    // Bins with more scatter than the others contain an edge or a face; runs of them become faces.
    result.face_of.assign(sides, -1);
    std::vector<std::size_t> face_points;
    for (std::size_t b = 0; b < sides; ++b) {
        MeridianBin& bin = result.bins[b];
        if (bin.active && bin.sigma > most_scatter) bin.active = false;
        bin.sigma = result.sigma_mm;
        if (bin.active || static_cast<double>(by_z.first[b + 1] - by_z.first[b]) < least / 2) continue;
        const bool goes_on = b > 0 && result.face_of[b - 1] >= 0;
        if (!goes_on) face_points.push_back(0);
        result.face_of[b] = static_cast<int>(face_points.size()) - 1;
        face_points.back() += by_z.first[b + 1] - by_z.first[b];
    }
    std::vector<int> kept(face_points.size(), -1);
    int faces = 0;
    for (std::size_t f = 0; f < face_points.size(); ++f)
        if (static_cast<double>(face_points[f]) > leastFacePointShare * static_cast<double>(points.size()))
            kept[f] = faces++;
    for (int& face : result.face_of)
        if (face >= 0) face = kept[static_cast<std::size_t>(face)];
    const std::size_t walls = result.bins.size();
    result.bins.resize(walls + static_cast<std::size_t>(faces * result.face_columns));
    for (int f = 0; f < faces; ++f) {
        MeridianBin* own = result.bins.data() + walls + static_cast<std::size_t>(f * result.face_columns);
        const BinOrder by_r =
            sortInto(static_cast<std::size_t>(result.face_columns), points.size(), [&](std::size_t i) {
                const int column = static_cast<int>(points[i].r / result.step_mm);
                return !inBore(i) && result.face_of[static_cast<std::size_t>(sideOf(i))] == f &&
                               column < result.face_columns
                           ? column
                           : -1;
            });
        const double scatter =
            std::max(floor, typical(fillBins(own, result.face_columns, 0, result.step_mm, by_r, r_of, z_of, 4)));
        for (int c = 0; c < result.face_columns; ++c) {
            if (own[c].sigma > edgeScatterRatio * scatter) own[c].active = false;
            own[c].sigma = scatter;
        }
        // A long run beside quiet bins whose points lie anywhere along it is rough, not a face.
        const auto length = std::count(result.face_of.begin(), result.face_of.end(), f);
        if (calm > 0 && length > 8 && scatter > 0.2 * static_cast<double>(length) * result.step_mm) {
            for (int c = 0; c < result.face_columns; ++c) own[c].active = false;
            std::replace(result.face_of.begin(), result.face_of.end(), f, -1);
        }
    }
    return result;
}

void refineSlopes(MeridianBins& bins)
{
    slopesOf(bins.bins.data(), bins.side_count, bins.step_mm);
    if (bins.wall_count > bins.side_count) slopesOf(bins.bins.data() + bins.side_count, bins.side_count, bins.step_mm);
    for (std::size_t first = static_cast<std::size_t>(bins.wall_count); first < bins.bins.size();
         first += static_cast<std::size_t>(bins.face_columns))
        slopesOf(bins.bins.data() + first, bins.face_columns, bins.step_mm);
}

}  // namespace lathelier::registration
