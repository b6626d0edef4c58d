#include "engine/registration/meridian_bins.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lathelier {
namespace {

constexpr double kToSigma = 1.4826;   // from the median absolute deviation of a normal distribution
constexpr double kEdgeScatter = 2.5;  // a bin that scatters this much more than its fellows holds an edge
constexpr double kFaceShare = 0.02;   // of the points: a face with fewer says less about the axis than its errors cost

struct MeridianPoint {
    double z;
    double r;
};

double medianOf(std::vector<double>& values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// The points of each bin: those of bin b are items[first[b]] … items[first[b + 1] - 1].
struct Sorted {
    std::vector<std::size_t> first;
    std::vector<std::size_t> items;
};

template <class Key>
Sorted sortInto(std::size_t bins, std::size_t count, Key key)
{
    Sorted sorted;
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

/// Median and scatter of each bin; bins without enough points stay inactive. Gives the typical scatter.
template <class Along, class Across>
double fillBins(MeridianBin* bins, int count, double start, double step, const Sorted& sorted, Along along,
                Across across, double least_points)
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
        if (!values.empty()) bin.value = medianOf(values);
    }
    const auto measure = [&] {
        std::vector<double> scatters;
        for (int b = 0; b < count; ++b) {
            MeridianBin& bin = bins[b];
            const auto bin_index = static_cast<std::size_t>(b);
            if (!bin.active) continue;
            values.clear();
            for (std::size_t k = sorted.first[bin_index]; k < sorted.first[bin_index + 1]; ++k) {
                const std::size_t i = sorted.items[k];
                values.push_back(std::abs(across(i) - bin.value - bin.slope * (along(i) - bin.middle)));
            }
            bin.sigma = kToSigma * medianOf(values) * bin.cosine;
            scatters.push_back(bin.sigma);
        }
        return scatters.empty() ? 0.0 : medianOf(scatters);
    };
    measure();
    slopesOf(bins, count, step);
    return measure();
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
        points[i] = {p.z(), std::hypot(p.x(), p.y())};
        radii[i] = points[i].r;
        low = std::min(low, p.z());
        high = std::max(high, p.z());
    }
    const auto most = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() * 99 / 100);
    std::nth_element(radii.begin(), most, radii.end());
    const double largest = *most;

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
    result.bins.resize(sides);

    const Sorted by_z = sortInto(sides, points.size(), [&](std::size_t i) {
        return std::min(result.side_count - 1, static_cast<int>((points[i].z - low) / result.step_mm));
    });
    std::vector<double> filled;
    for (std::size_t b = 0; b < sides; ++b)
        if (by_z.first[b + 1] > by_z.first[b]) filled.push_back(static_cast<double>(by_z.first[b + 1] - by_z.first[b]));
    const double typical = medianOf(filled);
    const auto z_of = [&](std::size_t i) { return points[i].z; };
    const auto r_of = [&](std::size_t i) { return points[i].r; };
    const double least = std::max(4.0, 0.15 * typical);
    const double floor = 1e-5 * extent;  // exact meshes: no surface is worth more than this
    result.sigma_mm =
        std::max(floor, fillBins(result.bins.data(), result.side_count, low, result.step_mm, by_z, z_of, r_of, least));

    // Bins that scatter more than the others hold an edge or a face; runs of them become faces of their own.
    result.face_of.assign(sides, -1);
    std::vector<std::size_t> face_points;
    for (std::size_t b = 0; b < sides; ++b) {
        MeridianBin& bin = result.bins[b];
        if (bin.active && bin.sigma > kEdgeScatter * result.sigma_mm) bin.active = false;
        bin.sigma = result.sigma_mm;
        if (bin.active || by_z.first[b + 1] - by_z.first[b] < least / 2) continue;
        const bool goes_on = b > 0 && result.face_of[b - 1] >= 0;
        if (!goes_on) face_points.push_back(0);
        result.face_of[b] = static_cast<int>(face_points.size()) - 1;
        face_points.back() += by_z.first[b + 1] - by_z.first[b];
    }
    std::vector<int> kept(face_points.size(), -1);
    int faces = 0;
    for (std::size_t f = 0; f < face_points.size(); ++f)
        if (static_cast<double>(face_points[f]) > kFaceShare * static_cast<double>(points.size())) kept[f] = faces++;
    for (int& face : result.face_of)
        if (face >= 0) face = kept[static_cast<std::size_t>(face)];
    result.bins.resize(sides + static_cast<std::size_t>(faces * result.face_columns));
    for (int f = 0; f < faces; ++f) {
        MeridianBin* own = result.bins.data() + sides + static_cast<std::size_t>(f * result.face_columns);
        const Sorted by_r = sortInto(static_cast<std::size_t>(result.face_columns), points.size(), [&](std::size_t i) {
            const int side = std::min(result.side_count - 1, static_cast<int>((points[i].z - low) / result.step_mm));
            const int column = static_cast<int>(points[i].r / result.step_mm);
            return result.face_of[static_cast<std::size_t>(side)] == f && column < result.face_columns ? column : -1;
        });
        const double scatter =
            std::max(floor, fillBins(own, result.face_columns, 0, result.step_mm, by_r, r_of, z_of, 4));
        for (int c = 0; c < result.face_columns; ++c) {
            if (own[c].sigma > kEdgeScatter * scatter) own[c].active = false;
            own[c].sigma = scatter;
        }
    }
    return result;
}

void refineSlopes(MeridianBins& bins)
{
    slopesOf(bins.bins.data(), bins.side_count, bins.step_mm);
    for (std::size_t first = static_cast<std::size_t>(bins.side_count); first < bins.bins.size();
         first += static_cast<std::size_t>(bins.face_columns))
        slopesOf(bins.bins.data() + first, bins.face_columns, bins.step_mm);
}

double consistentShare(const std::vector<Eigen::Vector3d>& sample, const Eigen::Isometry3d& axis_T_scan,
                       const MeridianBins& bins, double noise_mm)
{
    const double widest = std::max(0.02 * bins.largest_mm, 3 * noise_mm);
    // Radii on either side of bins without one: a point between them lies on the shoulder.
    const auto sides = static_cast<std::size_t>(bins.side_count);
    std::vector<double> low(sides, 0), high(sides, 0);
    double before = 0;
    for (std::size_t b = 0; b < sides; ++b) {
        if (bins.bins[b].active) before = bins.bins[b].value;
        low[b] = high[b] = before;
    }
    double after = 0;
    for (std::size_t b = sides; b-- > 0;) {
        if (bins.bins[b].active) after = bins.bins[b].value;
        low[b] = std::min(low[b], after);
        high[b] = std::max(high[b], after);
    }
    std::size_t good = 0;
    for (const Eigen::Vector3d& point : sample) {
        const Eigen::Vector3d p = axis_T_scan * point;
        const double r = std::hypot(p.x(), p.y());
        const int key = bins.find(p.z(), r);
        if (key >= 0) {
            const MeridianBin& bin = bins.bins[static_cast<std::size_t>(key)];
            const bool side = key < bins.side_count;
            const double error =
                bin.cosine * ((side ? r : p.z()) - bin.value - bin.slope * ((side ? p.z() : r) - bin.middle));
            if (std::abs(error) < std::min(6 * bin.sigma, widest)) ++good;
            continue;
        }
        const double place = (p.z() - bins.z_start_mm) / bins.step_mm;
        if (place < 0 || place >= bins.side_count) continue;
        const auto b = static_cast<std::size_t>(place);
        const double reach = std::min(6 * bins.sigma_mm, widest);
        if (!bins.bins[b].active && bins.bins[b].points > 0 && r > low[b] - reach && r < high[b] + reach) ++good;
    }
    return static_cast<double>(good) / static_cast<double>(sample.size());
}

}  // namespace lathelier
