#include "engine/registration/neighbours/points_near.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "engine/core/parallel.h"

namespace lathelier::registration {
namespace {

using Eigen::Vector3d;

constexpr std::size_t pointsPerTask = 1 << 16;

Eigen::AlignedBox3d boundsOf(const std::vector<Vector3d>& points, const Progress& progress)
{
    return parallelReduce(
        points.size(), pointsPerTask, progress, Eigen::AlignedBox3d(),
        [&](std::size_t begin, std::size_t end) {
            Eigen::AlignedBox3d box;
            for (std::size_t i = begin; i < end; ++i) box.extend(points[i]);
            return box;
        },
        [](const Eigen::AlignedBox3d& all, const Eigen::AlignedBox3d& part) { return all.merged(part); });
}

/// Marks on the cells of a grid.
class Cells {
public:
    /// Cells of at least `cell_mm`; larger ones where there would be too many.
    Cells(const Eigen::AlignedBox3d& box, double cell_mm) : low_mm_(box.min()), cell_mm_(cell_mm)
    {
        constexpr double most = 1 << 28;
        const auto count = [&](double cell) { return ((box.sizes().array() / cell).floor() + 1).prod(); };
        while (!(count(cell_mm_) <= most)) cell_mm_ *= 2;
        for (int a = 0; a < 3; ++a) counts_[a] = static_cast<Eigen::Index>(box.sizes()[a] / cell_mm_) + 1;
        marks_.resize(static_cast<std::size_t>(counts_.prod() + 63) / 64);
    }

    void mark(const Vector3d& from_mm, const Vector3d& to_mm)
    {
        const Place low = placeOf(from_mm), high = placeOf(to_mm);
        for (Eigen::Index x = low[0]; x <= high[0]; ++x)
            for (Eigen::Index y = low[1]; y <= high[1]; ++y)
                for (Eigen::Index z = low[2]; z <= high[2]; ++z) {
                    const std::size_t bit = bitOf({x, y, z});
                    marks_[bit / 64] |= std::uint64_t{1} << (bit % 64);
                }
    }
    bool isMarked(const Vector3d& point_mm) const
    {
        const std::size_t bit = bitOf(placeOf(point_mm));
        return (marks_[bit / 64] >> (bit % 64)) & 1;
    }
    std::size_t marked() const
    {
        std::size_t count = 0;
        for (const std::uint64_t word : marks_) count += static_cast<std::size_t>(std::popcount(word));
        return count;
    }
    double cell_mm() const { return cell_mm_; }

private:
    using Place = Eigen::Array<Eigen::Index, 3, 1>;

    /// Of what lies outside: the nearest cell.
    Place placeOf(const Vector3d& point_mm) const
    {
        Place place;
        for (int a = 0; a < 3; ++a) {
            const double cells =
                std::clamp((point_mm[a] - low_mm_[a]) / cell_mm_, 0.0, static_cast<double>(counts_[a] - 1));
            place[a] = static_cast<Eigen::Index>(cells);
        }
        return place;
    }
    std::size_t bitOf(const Place& place) const
    {
        return static_cast<std::size_t>((place[0] * counts_[1] + place[1]) * counts_[2] + place[2]);
    }

    Vector3d low_mm_;
    double cell_mm_;
    Place counts_;
    std::vector<std::uint64_t> marks_;
};

}  // namespace

std::vector<Vector3d> pointsNear(const std::vector<Vector3d>& points_mm, const std::vector<Vicinity>& vicinities,
                                 const Progress& progress)
{
    double least_mm = std::numeric_limits<double>::infinity();
    for (const Vicinity& vicinity : vicinities) least_mm = std::min(least_mm, vicinity.radius_mm);
    if (points_mm.empty() || !(least_mm > 0) || !std::isfinite(least_mm)) return points_mm;
    Cells cells(boundsOf(points_mm, progress), least_mm);
    for (const Vicinity& vicinity : vicinities) {
        progress.check();
        const Vector3d reach = Vector3d::Constant(vicinity.radius_mm * (1 + 1e-9));
        for (const Vector3d& place : vicinity.places_mm) cells.mark(place - reach, place + reach);
    }
    using Chosen = std::vector<Vector3d>;
    return parallelReduce(
        points_mm.size(), std::max(pointsPerTask, points_mm.size() / 64), progress, Chosen(),
        [&](std::size_t begin, std::size_t end) {
            Chosen chosen;
            for (std::size_t i = begin; i < end; ++i)
                if (cells.isMarked(points_mm[i])) chosen.push_back(points_mm[i]);
            return chosen;
        },
        [](Chosen all, const Chosen& part) {
            all.insert(all.end(), part.begin(), part.end());
            return all;
        });
}

double roughSpacing_mm(const std::vector<Vector3d>& points_mm, const Progress& progress)
{
    constexpr double cellsAlong = 100;
    constexpr std::size_t enough = 1 << 20;  // they occupy the same cells as all points
    const std::size_t step = std::max<std::size_t>(1, points_mm.size() / enough);
    const Eigen::AlignedBox3d box = boundsOf(points_mm, progress);
    const double size_mm = points_mm.empty() ? 0 : box.sizes().maxCoeff();
    if (!(size_mm > 0)) return 0;
    Cells cells(box, size_mm / cellsAlong);
    for (std::size_t i = 0; i < points_mm.size(); i += step) cells.mark(points_mm[i], points_mm[i]);
    // An inclined surface meets 1.5 times as many cells as an axis-parallel one.
    const double area_mm2 = static_cast<double>(cells.marked()) * cells.cell_mm() * cells.cell_mm() / 1.5;
    return std::sqrt(area_mm2 / static_cast<double>(points_mm.size()));
}

}  // namespace lathelier::registration
