#include "engine/registration/surface_form.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "engine/core/parallel.h"
#include "engine/core/statistics.h"
#include "engine/core/units.h"
#include "engine/registration/neighbours/neighbours.h"

namespace lathelier::registration {
namespace {

constexpr double windowMargin_mm = 1;  // largest distance of a place from the window that colours it
constexpr double formSigmas =
    4;  // a larger difference between a window and the next wider one is form, in standard uncertainties
constexpr std::uint32_t reachSamples = 4096;
constexpr std::size_t windowsPerTask = 16384;
constexpr std::size_t queryBatch = 256;  // queries per batch: neighbours in the file are mostly neighbours in space
constexpr float noMean = std::numeric_limits<float>::quiet_NaN();

/// Radius of the reference's meridian; NaN where it has no single one.
double radiusAt_mm(const Meridian& meridian, double z_mm)
{
    const auto after = std::lower_bound(meridian.z_mm.begin(), meridian.z_mm.end(), z_mm);
    if (after == meridian.z_mm.end()) return notANumber;
    return meridian.reference_radius_mm[static_cast<std::size_t>(after - meridian.z_mm.begin())];
}

/// An index of the smallest windows by their places on the surface.
class SmallestWindows {
public:
    /// result.windows has to be there, with windows in it.
    SmallestWindows(const CompareResult& result, WindowsOn on, const Progress& progress)
        : all_(*result.windows),
          meridian_(result.meridian ? &*result.meridian : nullptr),
          numbers_(numbersOf(all_, on)),
          index_(placesOf(all_, numbers_), progress)
    {
    }

    /// The windows about places on the reference's surface, in its frame; noWindow where none is near.
    void find(std::span<const Eigen::Vector3d> places_mm, std::span<std::uint32_t> windows) const
    {
        std::fill(windows.begin(), windows.end(), noWindow);
        if (numbers_.empty()) return;
        std::vector<Neighbours::Found> found(places_mm.size());
        index_.nearest(places_mm, std::numeric_limits<double>::infinity(), found);
        for (std::size_t i = 0; i < places_mm.size(); ++i) {
            if (found[i].place == Neighbours::Found::none) continue;
            const std::uint32_t window = numbers_[index_.input(found[i].place)];
            if (isNear(all_.windows[window], places_mm[i], std::sqrt(found[i].squared_mm2))) windows[i] = window;
        }
    }

private:
    static std::vector<std::uint32_t> numbersOf(const SurfaceWindows& all, WindowsOn on)
    {
        std::vector<std::uint32_t> numbers;
        for (std::uint32_t i = 0; i < all.windows.size() && all.windows[i].smallest; i += all.about) {
            const std::int32_t stretch = all.windows[i].stretch;
            const bool is_face = stretch >= 0 && all.stretches[static_cast<std::size_t>(stretch)].isFace();
            if (on == WindowsOn::All || is_face == (on == WindowsOn::Faces)) numbers.push_back(i);
        }
        return numbers;
    }

    static std::vector<Eigen::Vector3d> placesOf(const SurfaceWindows& all, const std::vector<std::uint32_t>& numbers)
    {
        std::vector<Eigen::Vector3d> places;
        places.reserve(numbers.size());
        for (const std::uint32_t i : numbers) places.emplace_back(all.windows[i].place_mm.cast<double>());
        return places;
    }

    bool isNear(const SurfaceWindow& window, const Eigen::Vector3d& place_mm, double distance_mm) const
    {
        if (!all_.axis_T_reference || window.stretch < 0)
            return distance_mm <= windowMargin_mm + static_cast<double>(window.size_mm);
        const Eigen::Vector3d along = *all_.axis_T_reference * place_mm;
        const MeridianStretch& stretch = all_.stretches[static_cast<std::size_t>(window.stretch)];
        const double radius = along.head<2>().norm();
        if (stretch.isFace())
            return std::abs(along.z() - stretch.start_mm) <= windowMargin_mm &&
                   radius >= stretch.inner_mm - windowMargin_mm && radius <= stretch.outer_mm + windowMargin_mm;
        const double beyond = std::max(stretch.start_mm - along.z(), along.z() - stretch.end_mm);
        const double off_mm = std::abs(radius - surfaceRadius_mm(stretch, along.z()));
        return beyond <= windowMargin_mm && off_mm <= windowMargin_mm &&
               static_cast<double>(window.z_start_mm) - along.z() <=
                   windowMargin_mm + static_cast<double>(window.size_mm) &&
               along.z() - static_cast<double>(window.z_end_mm) <=
                   windowMargin_mm + static_cast<double>(window.size_mm);
    }

    /// Of the reference's surface: that of its meridian, or where there is none, as in a bore, of the stretch as a
    /// straight line.
    double surfaceRadius_mm(const MeridianStretch& stretch, double z_mm) const
    {
        const double known = meridian_ && !stretch.is_bore ? radiusAt_mm(*meridian_, z_mm) : notANumber;
        if (!std::isnan(known)) return known;
        return stretch.radius_mm + stretch.slope * (z_mm - (stretch.start_mm + stretch.end_mm) / 2);
    }

    const SurfaceWindows& all_;
    const Meridian* meridian_;            ///< null: none
    std::vector<std::uint32_t> numbers_;  ///< of the windows in the index
    Neighbours index_;
};

bool hasSmallest(const SurfaceWindows& all)
{
    return !all.windows.empty() && all.windows.front().smallest;
}

}  // namespace

std::vector<std::uint32_t> windowsOfPoints(const Scan& copy, const CompareResult& result, const Progress& progress)
{
    const SurfaceWindows& all = *result.windows;
    std::vector<std::uint32_t> windows(copy.points_mm.size(), noWindow);
    if (!hasSmallest(all)) return windows;
    const SmallestWindows smallest(result, WindowsOn::All, progress);
    const Eigen::Isometry3d& reference_T_copy = result.alignment.reference_T_copy;
    parallelFor(windows.size(), windowsPerTask, progress, [&](std::size_t begin, std::size_t end) {
        std::vector<Eigen::Vector3d> places;
        std::vector<std::uint32_t> numbers, found;
        const auto flush = [&] {
            found.resize(places.size());
            smallest.find(places, found);
            for (std::size_t k = 0; k < numbers.size(); ++k) windows[numbers[k]] = found[k];
            places.clear();
            numbers.clear();
        };
        for (std::size_t i = begin; i < end; ++i) {
            if (!result.used[i]) continue;
            places.emplace_back(reference_T_copy * copy.points_mm[i]);
            numbers.push_back(static_cast<std::uint32_t>(i));
            if (places.size() == queryBatch) flush();
        }
        flush();
    });
    return windows;
}

std::vector<std::uint32_t> windowsOfPlaces(std::span<const Eigen::Vector3d> places_mm, const CompareResult& result,
                                           WindowsOn on, const Progress& progress)
{
    std::vector<std::uint32_t> windows(places_mm.size(), noWindow);
    if (!hasSmallest(*result.windows)) return windows;
    const SmallestWindows smallest(result, on, progress);
    parallelFor(windows.size(), windowsPerTask, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t from = begin; from < end; from += queryBatch) {
            const std::size_t count = std::min(queryBatch, end - from);
            smallest.find(places_mm.subspan(from, count), std::span(windows).subspan(from, count));
        }
    });
    return windows;
}

std::vector<std::uint32_t> windowsOfMap(const CompareResult& result, const Progress& progress)
{
    const UnrolledMap& map = *result.unrolled;
    const auto angles = static_cast<std::size_t>(map.angle_count);
    std::vector<std::uint32_t> windows(static_cast<std::size_t>(map.z_count) * angles, noWindow);
    if (!result.windows || !hasSmallest(*result.windows) || !result.meridian || !result.axis_T_reference)
        return windows;
    // The map is unrolled from the sides: no face has a place on it.
    const SmallestWindows smallest(result, WindowsOn::Sides, progress);
    const Eigen::Isometry3d reference_T_axis = result.axis_T_reference->inverse();
    parallelFor(static_cast<std::size_t>(map.z_count), 8, progress, [&](std::size_t begin, std::size_t end) {
        std::vector<Eigen::Vector3d> places(angles);
        for (std::size_t row = begin; row < end; ++row) {
            const double z = map.z_start_mm + (static_cast<double>(row) + 0.5) * map.z_step_mm;
            const double radius_mm = radiusAt_mm(*result.meridian, z);
            if (std::isnan(radius_mm)) continue;
            for (std::size_t a = 0; a < angles; ++a) {
                const double angle =
                    (static_cast<double>(a) + 0.5) * 2 * std::numbers::pi / static_cast<double>(angles);
                places[a] =
                    reference_T_axis * Eigen::Vector3d(radius_mm * std::cos(angle), radius_mm * std::sin(angle), z);
            }
            smallest.find(places, std::span(windows).subspan(row * angles, angles));
            // Cells without points of the copy stay empty, even near a window.
            for (std::size_t a = 0; a < angles; ++a)
                if (std::isnan(map.mean_mm[row * angles + a])) windows[row * angles + a] = noWindow;
        }
    });
    return windows;
}

float meanOf(const SurfaceWindows& all, std::uint32_t place, double sigma_limit_mm)
{
    while (place != SurfaceWindow::noWiderWindow) {
        const SurfaceWindow& window = all.windows[place];
        if (static_cast<double>(window.sigma_mm) <= sigma_limit_mm) return window.mean_mm;
        if (window.wider == SurfaceWindow::noWiderWindow) break;
        const SurfaceWindow& wider = all.windows[window.wider];
        // The wider window contains the other: the variance of the difference is the difference of the variances.
        const double variance = std::max(
            0.0, std::pow(static_cast<double>(window.sigma_mm), 2) - std::pow(static_cast<double>(wider.sigma_mm), 2));
        const double apart = std::abs(static_cast<double>(wider.mean_mm) - static_cast<double>(window.mean_mm));
        if (apart > formSigmas * std::sqrt(variance) && apart > sigma_limit_mm) return window.mean_mm;
        place = window.wider;
    }
    return noMean;
}

std::vector<float> meansOf(const SurfaceWindows& all, const std::vector<std::uint32_t>& places, double sigma_limit_mm)
{
    // Each of the smallest windows once, though many places lie in it.
    std::vector<float> mean(all.windows.size(), noMean);
    for (std::uint32_t i = 0; i < all.windows.size() && all.windows[i].smallest; i += all.about)
        mean[i] = meanOf(all, i, sigma_limit_mm);
    std::vector<float> means(places.size());
    for (std::size_t i = 0; i < places.size(); ++i) means[i] = places[i] == noWindow ? noMean : mean[places[i]];
    return means;
}

double formLimit_mm(const SurfaceWindows& all, double share)
{
    std::uint32_t smallest = 0;
    while (smallest < all.windows.size() && all.windows[smallest].smallest) smallest += all.about;
    // A sample of some thousand places suffices for a quantile; this is called during every drag of a limit.
    const std::uint32_t step = all.about * std::max(1U, smallest / all.about / reachSamples);
    // From coarse to fine, until the uncertainty of the means is small against their own range.
    double reach_mm = 0;
    std::vector<float> sizes;
    for (double sigma_limit_mm = std::max(all.scatter_mm, 1e-6); sigma_limit_mm > 1e-7; sigma_limit_mm /= 2) {
        sizes.clear();
        std::size_t places = 0;
        for (std::uint32_t i = 0; i < smallest; i += step) {
            ++places;
            const float mean = meanOf(all, i, sigma_limit_mm);
            if (!std::isnan(mean)) sizes.push_back(std::abs(mean));
        }
        if (sizes.empty() || sizes.size() * 10 < places * 9) break;  // finer than the uncertainty of the data allows
        const auto size = static_cast<double>(lowerQuantileInPlace(sizes, share));
        if (sigma_limit_mm <= uncertaintyShareOfScale * size) return size;
        reach_mm = sigma_limit_mm / uncertaintyShareOfScale;
    }
    return reach_mm;
}

}  // namespace lathelier::registration
