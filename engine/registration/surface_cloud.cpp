#include "engine/registration/surface_cloud.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/core/error.h"
#include "engine/core/parallel.h"
#include "engine/registration/surface_orientation.h"

namespace lathelier {
namespace {

constexpr std::size_t neighbourhood = 48;       // points to a patch
constexpr std::size_t largest_neighbourhood = 768;
constexpr double min_breadth = 0.25;            // narrower ones (single scan lines) are widened
constexpr double edge_ratio = 1.35;             // of a patch's scatter to the usual one
constexpr double cos_same_sheet = 0.95;

}  // namespace

CloudSurface::CloudSurface(const Scan& cloud, const Progress& progress)
    : points_(cloud.points_mm, progress.part(0, 0.15)), given_normals_(cloud.normals)
{
    if (points_.size() < 4)
        throw Error(ErrorCode::TooFewPoints,
                    {{"found", static_cast<std::int64_t>(points_.size())}, {"minimum", std::int64_t{4}}});
    fitAll(progress.part(0.15, 0.7));
    splitAtEdges(progress.part(0.7, 1));
}

void CloudSurface::gather(std::uint32_t patch, std::size_t count, std::vector<Eigen::Vector3d>& points_mm) const
{
    const std::uint32_t first = patch * points_per_patch;
    const std::uint32_t last = std::min(first + points_per_patch, static_cast<std::uint32_t>(points_.size()));
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (std::uint32_t i = first; i < last; ++i) middle += points_.point_mm(i);
    middle /= last - first;
    Eigen::Vector3d centre = points_.point_mm(first);  // the middle itself may lie between two walls
    for (std::uint32_t i = first; i < last; ++i)
        if ((points_.point_mm(i) - middle).squaredNorm() < (centre - middle).squaredNorm()) centre = points_.point_mm(i);
    thread_local std::vector<Neighbours::Found> found;
    points_.nearest(centre, count, std::numeric_limits<double>::infinity(), found);
    points_mm.clear();
    for (const Neighbours::Found& f : found) points_mm.push_back(points_.point_mm(f.place));
}

void CloudSurface::fitAll(const Progress& progress)
{
    sheets_.resize((points_.size() + points_per_patch - 1) / points_per_patch);
    parallelFor(sheets_.size(), 128, progress, [&](std::size_t begin, std::size_t end) {
        std::vector<Eigen::Vector3d> near;
        std::vector<double> weights;
        for (std::size_t s = begin; s < end; ++s)
            for (std::size_t count = neighbourhood; count <= largest_neighbourhood; count *= 2) {
                gather(static_cast<std::uint32_t>(s), count, near);
                weights.assign(near.size(), 1);
                sheets_[s].patch = fitPatch(near, weights);
                if (sheets_[s].patch.breadth > min_breadth || near.size() < count) break;
            }
    });
    std::vector<double> scatter;
    for (const Sheet& sheet : sheets_)
        if (sheet.patch.radius_mm > 0) scatter.push_back(sheet.patch.sigma_mm);
    if (scatter.empty()) return;
    const auto middle = scatter.begin() + static_cast<std::ptrdiff_t>(scatter.size() / 2);
    std::nth_element(scatter.begin(), middle, scatter.end());
    scatter_mm_ = *middle;
}

void CloudSurface::splitAtEdges(const Progress& progress)
{
    const auto isSmooth = [&](const SurfacePatch& patch) {
        return patch.radius_mm > 0 && patch.sigma_mm <= std::max(edge_ratio * scatter_mm_, 1e-3 * patch.radius_mm);
    };
    const auto patches = static_cast<std::uint32_t>(sheets_.size());
    std::vector<Eigen::Vector3d> smooth_centres;
    std::vector<std::uint32_t> smooth;
    std::vector<std::uint32_t> rough;
    for (std::uint32_t s = 0; s < patches; ++s) {
        const SurfacePatch& patch = sheets_[s].patch;
        (isSmooth(patch) ? smooth : rough).push_back(s);
        if (isSmooth(patch)) smooth_centres.push_back(patch.centre_mm);
    }
    const Neighbours index(smooth_centres, progress);
    std::vector<std::vector<SurfacePatch>> splits(rough.size());
    parallelFor(rough.size(), 64, progress, [&](std::size_t begin, std::size_t end) {
        std::vector<Eigen::Vector3d> near;
        std::vector<Neighbours::Found> starts;
        for (std::size_t r = begin; r < end; ++r) {
            const SurfacePatch& patch = sheets_[rough[r]].patch;
            if (!(patch.radius_mm > 0)) continue;
            const double reach = 3 * patch.radius_mm;
            index.nearest(patch.centre_mm, 16, reach * reach, starts);
            gather(rough[r], neighbourhood + 16, near);
            const double sigma = std::max(scatter_mm_, 1e-3 * patch.radius_mm);
            for (const Neighbours::Found& start : starts) {
                SurfacePatch sheet = sheets_[smooth[index.input(start.place)]].patch;
                const auto known = [&](const SurfacePatch& other) {
                    return std::abs(other.normal.dot(sheet.normal)) > cos_same_sheet &&
                           std::abs(other.distance_mm(sheet.centre_mm)) < 0.3 * sheet.radius_mm;
                };
                if (std::any_of(splits[r].begin(), splits[r].end(), known)) continue;
                if (fitRobustPatch(near, sigma, 4, sheet) < 10 || sheet.breadth < 0.15) continue;
                if (std::any_of(splits[r].begin(), splits[r].end(), known)) continue;
                splits[r].push_back(sheet);
                if (splits[r].size() == 3) break;
            }
        }
    });
    for (std::size_t r = 0; r < rough.size(); ++r) {
        std::uint32_t at = rough[r];
        for (std::size_t k = 0; k < splits[r].size(); ++k) {
            if (k > 0) {
                sheets_[at].next = static_cast<std::uint32_t>(sheets_.size());
                at = sheets_[at].next;
                sheets_.emplace_back();
            }
            sheets_[at].patch = splits[r][k];
        }
    }
}

SurfacePlace CloudSurface::placeOne(const Eigen::Vector3d& query_mm, const Neighbours::Found& nearest) const
{
    SurfacePlace best;
    const Eigen::Vector3d offset = query_mm - points_.point_mm(nearest.place);
    for (std::uint32_t s = nearest.place / points_per_patch; s != none; s = sheets_[s].next) {
        const SurfacePatch& patch = sheets_[s].patch;
        if (!(patch.radius_mm > 0)) continue;
        const double d = patch.distance_mm(query_mm);
        if (best.found() && std::abs(d) >= std::abs(best.distance_mm)) continue;
        best.distance_mm = d;
        best.normal = patch.normalAt(query_mm);
        // Far off the surface, noise decides which point is nearest: sideways by up to the second term.
        const double sideways2 = std::max(0.0, offset.squaredNorm() - std::pow(offset.dot(best.normal), 2));
        const double usual = 0.7 * patch.radius_mm;
        best.border = sideways2 > usual * usual + 8 * std::abs(d) * scatter_mm_;
    }
    return best;
}

void CloudSurface::place(std::span<const Eigen::Vector3d> queries_mm, double max_distance_mm,
                         std::span<SurfacePlace> places) const
{
    std::array<Neighbours::Found, bundle> found;
    points_.nearest(queries_mm, max_distance_mm * max_distance_mm, found);
    for (std::size_t q = 0; q < queries_mm.size(); ++q)
        places[q] = found[q].place == Neighbours::Found::none ? SurfacePlace() : placeOne(queries_mm[q], found[q]);
}

bool CloudSurface::orient(const Progress& progress)
{
    if (!given_normals_.empty()) {
        const auto patches = static_cast<std::uint32_t>((points_.size() + points_per_patch - 1) / points_per_patch);
        for (std::uint32_t p = 0; p < patches; ++p)
            for (std::uint32_t s = p; s != none; s = sheets_[s].next) {
                SurfacePatch& patch = sheets_[s].patch;
                double agreement = 0;
                for (std::uint32_t i = p * points_per_patch;
                     i < std::min<std::size_t>((p + 1) * points_per_patch, points_.size()); ++i)
                    agreement += given_normals_[points_.input(i)].cast<double>().dot(patch.normal);
                if (agreement < 0) patch.flip();
            }
        return true;
    }
    std::vector<SurfaceElement> elements;
    std::vector<std::uint32_t> sheet_of;
    for (std::uint32_t s = 0; s < sheets_.size(); ++s) {
        const SurfacePatch& patch = sheets_[s].patch;
        if (!(patch.radius_mm > 0)) continue;
        elements.push_back({patch.centre_mm, patch.normal, patch.radius_mm});
        sheet_of.push_back(s);
    }
    const std::vector<bool> flips = findOutside(elements, progress);
    if (flips.empty()) return false;
    for (std::size_t e = 0; e < elements.size(); ++e)
        if (flips[e]) sheets_[sheet_of[e]].patch.flip();
    return true;
}

}  // namespace lathelier
