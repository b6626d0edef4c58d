#include "engine/registration/surface/surface_cloud.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/core/core_codes.h"
#include "engine/core/error.h"
#include "engine/core/parallel.h"
#include "engine/core/statistics.h"
#include "engine/registration/surface/surface_orientation.h"
#include "engine/registration/surroundings.h"

namespace lathelier::registration {
namespace {

constexpr std::size_t neighbourhood = 48;    // points to a patch
constexpr std::uint32_t groupsTogether = 4;  // groups whose neighbourhoods are searched together
constexpr std::size_t largestNeighbourhood = 768;
constexpr double leastBreadth = 0.25;       // narrower ones (single scan lines) are widened
constexpr double edgeScatterFactor = 1.35;  // a patch whose scatter exceeds the median by this factor contains an edge
constexpr double exactScatterShare = 1e-3;  // of a patch's radius: residual of curvature in a cloud without noise
constexpr std::size_t mostSheets = 3;       // three sheets meet in a corner
constexpr std::size_t leastSheetPoints = 10;
constexpr double leastSheetBreadth = 0.15;
constexpr double sameSheetCosine = 0.95;

// Maps chunks of items to lists and joins the lists in order.
template <class T, class Map>
std::vector<T> parallelConcat(std::size_t count, std::size_t grain, const Progress& progress, Map map)
{
    std::vector<std::vector<T>> parts((count + grain - 1) / grain);
    parallelFor(count, grain, progress,
                [&](std::size_t begin, std::size_t end) { map(begin, end, parts[begin / grain]); });
    std::size_t total = 0;
    for (const auto& part : parts) total += part.size();
    std::vector<T> result;
    result.reserve(total);
    for (auto& part : parts) {
        result.insert(result.end(), part.begin(), part.end());
        part = {};
    }
    return result;
}

template <class T, class Value>
double medianAmong(const std::vector<T>& items, Value value)
{
    std::vector<double> values;
    values.reserve(items.size());
    for (const T& item : items) values.push_back(value(item));
    return values.empty() ? 0 : upperMedianInPlace(values);
}

}  // namespace

struct CloudSurface::Search {
    std::vector<Neighbours::Found> found;
    std::vector<Eigen::Vector3d> points_mm;
    std::vector<double> weights;
    double expected_mm2 = 1;
    Surroundings surroundings;

    explicit Search(const Neighbours& points) : surroundings(points) {}
};

CloudSurface::CloudSurface(const Scan& cloud, const Progress& progress)
    : points_(cloud.points_mm, progress.part(0, 0.15)), givenNormals_(cloud.normals)
{
    if (points_.size() < 4)
        throw Error(errors::tooFewPoints, {{"found", static_cast<std::int64_t>(points_.size())},
                                           {"minimum", std::int64_t{4}},
                                           {"role", std::string("reference")}});
    progress.report(0.15);
    std::vector<Member> members = fitAll(progress);
    progress.report(0.7);
    scatter_mm_ = medianAmong(members, [](const Member& m) { return m.patch.sigma_mm; });
    reach_mm_ = medianAmong(members, [](const Member& m) { return m.patch.radius_mm; });
    members = splitAtEdges(members, progress);
    store(members);
    progress.report(1);
}

std::uint32_t CloudSurface::groupEnd(std::uint32_t group) const
{
    return static_cast<std::uint32_t>(std::min<std::size_t>((group + 1) * std::size_t{groupSize}, points_.size()));
}

bool CloudSurface::isSmooth(const SurfacePatch& patch) const
{
    return patch.sigma_mm <= std::max(edgeScatterFactor * scatter_mm_, exactScatterShare * patch.radius_mm);
}

void CloudSurface::gather(std::uint32_t centre, std::size_t count, Search& search) const
{
    const Eigen::Vector3d at = points_.point_mm(centre);
    if (search.surroundings.nearest(at, count, search.found)) {
        search.expected_mm2 = 0;
        for (const Neighbours::Found& f : search.found)
            search.expected_mm2 = std::max(search.expected_mm2, 1.2 * f.squared_mm2);
    } else {
        points_.nearestUnsorted(at, count, search.expected_mm2, search.found);
    }
    search.points_mm.clear();
    for (const Neighbours::Found& f : search.found) search.points_mm.push_back(points_.point_mm(f.place));
}

// Prepares the search for some groups from `group` on, not beyond `end`.
void CloudSurface::surround(std::size_t group, std::size_t end, Search& search) const
{
    const auto first = static_cast<std::uint32_t>(group);
    const auto last = static_cast<std::uint32_t>(std::min(group + groupsTogether, end) - 1);
    Box box;
    for (std::uint32_t i = first * groupSize; i < groupEnd(last); ++i) box.add(points_.point_mm(i));
    search.surroundings.collect(box, 1.1 * search.expected_mm2, 256);
}

void CloudSurface::fitGroup(std::uint32_t group, Search& search, std::vector<Member>& members) const
{
    const std::size_t own = members.size();
    std::uint32_t waiting = (1U << (groupEnd(group) - group * groupSize)) - 1;  // points that no patch reaches yet
    while (waiting != 0) {
        Eigen::Vector3d middle = Eigen::Vector3d::Zero();
        int count = 0;
        for (std::uint32_t i = 0; i < groupSize; ++i)
            if ((waiting >> i & 1) != 0) {
                middle += points_.point_mm(group * groupSize + i);
                ++count;
            }
        middle /= count;
        std::uint32_t centre = 0;  // the mean of the points may lie between two walls
        double nearest = std::numeric_limits<double>::infinity();
        for (std::uint32_t i = 0; i < groupSize; ++i) {
            const double off =
                (points_.point_mm(std::min(group * groupSize + i, groupEnd(group) - 1)) - middle).squaredNorm();
            if ((waiting >> i & 1) != 0 && off < nearest) {
                nearest = off;
                centre = i;
            }
        }
        waiting &= ~(1U << centre);
        Member member{group, group * groupSize + centre, {}};
        for (std::size_t wanted = neighbourhood; wanted <= largestNeighbourhood; wanted *= 2) {
            gather(member.centre, wanted, search);
            search.weights.assign(search.points_mm.size(), 1);
            member.patch = fitPatch(search.points_mm, search.weights);
            if (member.patch.breadth > leastBreadth || search.points_mm.size() < wanted) break;
        }
        const Eigen::Vector3d at = points_.point_mm(member.centre);
        for (std::uint32_t i = 0; i < groupSize; ++i)
            if ((waiting >> i & 1) != 0 &&
                (points_.point_mm(group * groupSize + i) - at).norm() <= 0.9 * member.patch.radius_mm)
                waiting &= ~(1U << i);
        if (member.patch.radius_mm > 0)
            members.push_back(member);
        else if (members.size() > own)
            break;
    }
}

std::vector<CloudSurface::Member> CloudSurface::fitAll(const Progress& progress) const
{
    return parallelConcat<Member>(groupCount(), 128, progress,
                                  [&](std::size_t begin, std::size_t end, std::vector<Member>& members) {
                                      Search search(points_);
                                      for (std::size_t g = begin; g < end; ++g) {
                                          if ((g - begin) % groupsTogether == 0) surround(g, end, search);
                                          fitGroup(static_cast<std::uint32_t>(g), search, members);
                                      }
                                  });
}

std::vector<CloudSurface::Member> CloudSurface::splitAtEdges(const std::vector<Member>& members,
                                                             const Progress& progress) const
{
    std::vector<Eigen::Vector3d> centres;
    std::vector<SurfacePatch> smooth;
    for (const Member& m : members)
        if (isSmooth(m.patch)) {
            smooth.push_back(m.patch);
            centres.push_back(m.patch.centre_mm);
        }
    const Neighbours index(centres, progress);
    return parallelConcat<Member>(members.size(), 128, progress,
                                  [&](std::size_t begin, std::size_t end, std::vector<Member>& result) {
                                      Search search(points_);
                                      for (std::size_t i = begin; i < end; ++i)
                                          if (isSmooth(members[i].patch))
                                              result.push_back(members[i]);
                                          else
                                              split(members[i], index, smooth, search, result);
                                  });
}

void CloudSurface::split(const Member& rough, const Neighbours& smooth_index, const std::vector<SurfacePatch>& smooth,
                         Search& search, std::vector<Member>& sheets) const
{
    const std::size_t own = sheets.size();
    const double reach = 3 * rough.patch.radius_mm;
    const double sigma = std::max(scatter_mm_, exactScatterShare * rough.patch.radius_mm);
    std::vector<Neighbours::Found> starts;
    smooth_index.nearest(points_.point_mm(rough.centre), 16, reach * reach, starts);
    gather(rough.centre, neighbourhood + neighbourhood / 3, search);
    for (const Neighbours::Found& start : starts) {
        Member sheet{rough.group, rough.centre, smooth[smooth_index.input(start.place)]};
        const auto isKnown = [&] {
            return std::any_of(
                sheets.begin() + static_cast<std::ptrdiff_t>(own), sheets.end(), [&](const Member& other) {
                    return std::abs(other.patch.normal.dot(sheet.patch.normal)) > sameSheetCosine &&
                           std::abs(other.patch.distance_mm(sheet.patch.centre_mm)) < 0.3 * sheet.patch.radius_mm;
                });
        };
        if (isKnown()) continue;
        if (fitRobustPatch(search.points_mm, sigma, 4, sheet.patch) < leastSheetPoints) continue;
        if (sheet.patch.breadth < leastSheetBreadth || isKnown()) continue;
        sheets.push_back(sheet);
        if (sheets.size() == own + mostSheets) break;
    }
    if (sheets.size() == own) sheets.push_back(rough);
}

void CloudSurface::store(const std::vector<Member>& members)
{
    firstSpot_.assign(groupCount() + 1, 0);
    for (std::size_t m = 0; m < members.size(); ++m) {
        if (m == 0 || members[m].centre != members[m - 1].centre) {
            ++firstSpot_[members[m].group + 1];
            spots_.push_back({points_.point_mm(members[m].centre), static_cast<std::uint32_t>(m)});
        }
        patches_.push_back(members[m].patch);
        patches_.back().raise(scatter_mm_);
    }
    spots_.push_back({Eigen::Vector3d::Zero(), static_cast<std::uint32_t>(members.size())});
    for (std::size_t g = 1; g < firstSpot_.size(); ++g) firstSpot_[g] += firstSpot_[g - 1];
}

SurfacePlace CloudSurface::placeOn(std::uint32_t spot, const Eigen::Vector3d& query_mm,
                                   const Neighbours::Found& nearest) const
{
    SurfacePlace best;
    const Eigen::Vector3d offset = query_mm - points_.point_mm(nearest.place);
    const double nearest_mm = std::sqrt(nearest.squared_mm2);
    for (std::uint32_t p = spots_[spot].first_patch; p < spots_[spot + 1].first_patch; ++p) {
        const SurfacePatch& patch = patches_[p];
        // A patch that does not pass near its points, or does not extend to the query, is not used.
        const double d = patch.distance_mm(query_mm);
        const double farthest = nearest_mm + 4 * std::max(scatter_mm_, exactScatterShare * patch.radius_mm);
        if (std::abs(d) > farthest || patch.lateral_mm(query_mm) > 2 * patch.radius_mm) continue;
        if (best.found() && std::abs(d) >= std::abs(best.distance_mm)) continue;
        best.distance_mm = d;
        best.normal = patch.normalAt(query_mm);
        best.slope_variance = patch.slopeVariance(query_mm);
        // Far from the surface the nearest point depends on noise: its lateral offset reaches the second term.
        const double sideways2 = offset.squaredNorm() - std::pow(offset.dot(best.normal), 2);
        const double usual = 0.7 * patch.radius_mm + scatter_mm_;
        best.border = sideways2 > usual * usual + 16 * std::abs(d) * scatter_mm_;
    }
    return best;
}

SurfacePlace CloudSurface::placeOne(const Eigen::Vector3d& query_mm, const Neighbours::Found& nearest) const
{
    const Eigen::Vector3d point = points_.point_mm(nearest.place);
    const std::uint32_t first = firstSpot_[nearest.place / groupSize];
    const std::uint32_t end = firstSpot_[nearest.place / groupSize + 1];
    std::uint32_t nearest_spot = first;
    for (std::uint32_t s = first; s < end; ++s)
        if ((spots_[s].centre_mm - point).squaredNorm() < (spots_[nearest_spot].centre_mm - point).squaredNorm())
            nearest_spot = s;
    SurfacePlace place;
    if (first < end) place = placeOn(nearest_spot, query_mm, nearest);
    for (std::uint32_t s = first; s < end && !place.found(); ++s) place = placeOn(s, query_mm, nearest);
    return place;
}

void CloudSurface::place(std::span<const Eigen::Vector3d> queries_mm, double max_distance_mm,
                         std::span<SurfacePlace> places, std::span<Trace> traces) const
{
    std::vector<Neighbours::Found> found(queries_mm.size());
    const double search = max_distance_mm + reach_mm_;  // the surface may be nearer than its points
    if (traces.empty())
        points_.nearest(queries_mm, search * search, found);
    else
        points_.nearest(queries_mm, search * search, traces, found);
    for (std::size_t q = 0; q < queries_mm.size(); ++q) {
        places[q] = SurfacePlace();
        if (found[q].place == Neighbours::Found::none) continue;
        places[q] = placeOne(queries_mm[q], found[q]);
        if (std::abs(places[q].distance_mm) > max_distance_mm) places[q] = SurfacePlace();
    }
}

bool CloudSurface::orient(const Progress& progress)
{
    if (!givenNormals_.empty()) {
        for (std::uint32_t g = 0; g < groupCount(); ++g)
            for (std::uint32_t p = spots_[firstSpot_[g]].first_patch; p < spots_[firstSpot_[g + 1]].first_patch; ++p) {
                double agreement = 0;
                for (std::uint32_t i = g * groupSize; i < groupEnd(g); ++i)
                    agreement += givenNormals_[points_.input(i)].cast<double>().dot(patches_[p].normal);
                if (agreement < 0) patches_[p].flip();
            }
        return true;
    }
    std::vector<SurfaceElement> elements;
    for (const SurfacePatch& p : patches_) elements.push_back({p.centre_mm, p.normal, p.radius_mm});
    const std::vector<bool> flips = findOutside(elements, progress);
    if (flips.empty()) return false;
    for (std::size_t p = 0; p < patches_.size(); ++p)
        if (flips[p]) patches_[p].flip();
    return true;
}

}  // namespace lathelier::registration
