#include "engine/registration/surface/surface_orientation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <numeric>
#include <tuple>

#include "engine/core/parallel.h"
#include "engine/registration/neighbours/neighbours.h"
#include "engine/registration/senses.h"
#include "engine/registration/surroundings.h"

namespace lathelier::registration {
namespace {

constexpr std::size_t links = 8;             // of an element to its neighbours
constexpr std::size_t windingSamples = 120;  // places where the winding number is evaluated
constexpr double windingTolerance = 0.25;
constexpr double leastConsistentShare = 0.9;

struct Link {
    std::uint32_t cost;  // 0: the orientations are certain to agree
    std::uint32_t from;
    std::uint32_t to;
    bool opposite;
};

struct Graph {
    std::vector<Link> links;
    std::vector<double> areas_mm2;
};

// The cheapest first, equal ones in the order given.
std::vector<Link> inOrderOfCost(std::vector<Link> all)
{
    std::vector<Link> sorted(all.size());
    for (const int shift : {0, 10}) {
        std::array<std::size_t, 1025> starts{};
        for (const Link& link : all) ++starts[(link.cost >> shift & 1023) + 1];
        std::partial_sum(starts.begin(), starts.end(), starts.begin());
        for (const Link& link : all) sorted[starts[link.cost >> shift & 1023]++] = link;
        all.swap(sorted);
    }
    return all;
}

// The nearest elements and the place itself, nearest first.
void findNearest(const Neighbours& index, Surroundings& surroundings, const Eigen::Vector3d& at_mm,
                 std::vector<Neighbours::Found>& found)
{
    if (!surroundings.nearest(at_mm, links + 1, found))
        index.nearest(at_mm, links + 1, std::numeric_limits<double>::infinity(), found);
    else
        std::sort(found.begin(), found.end(), [](const Neighbours::Found& a, const Neighbours::Found& b) {
            return std::tie(a.squared_mm2, a.place) < std::tie(b.squared_mm2, b.place);
        });
}

Graph connect(const std::vector<SurfaceElement>& elements, const Progress& progress)
{
    std::vector<Eigen::Vector3d> centres;
    centres.reserve(elements.size());
    for (const SurfaceElement& e : elements) centres.push_back(e.centre_mm);
    const Neighbours index(centres, progress);
    std::vector<Link> all(elements.size() * links);
    Graph graph;
    graph.areas_mm2.resize(elements.size());
    parallelFor(elements.size(), 256, progress, [&](std::size_t begin, std::size_t end) {
        constexpr std::size_t together = 32;
        Surroundings surroundings(index);
        double expected_mm2 = 0;
        std::vector<Neighbours::Found> found;
        for (std::size_t place = begin; place < end; ++place) {
            if ((place - begin) % together == 0) {
                Box box;
                for (std::size_t p = place; p < std::min(place + together, end); ++p)
                    box.add(index.point_mm(static_cast<std::uint32_t>(p)));
                surroundings.collect(box, expected_mm2, 4 * together);
            }
            const std::size_t i = index.input(static_cast<std::uint32_t>(place));
            const SurfaceElement& a = elements[i];
            findNearest(index, surroundings, a.centre_mm, found);
            if (!found.empty()) expected_mm2 = 1.5 * found.back().squared_mm2;
            const double limit_mm2 = std::pow(4 * a.radius_mm, 2);
            while (!found.empty() && !(found.back().squared_mm2 < limit_mm2)) found.pop_back();
            graph.areas_mm2[i] = found.empty() ? 0
                                               : std::numbers::pi * found.back().squared_mm2 /
                                                     std::max(1.0, static_cast<double>(found.size()) - 0.5);
            for (std::size_t k = 0; k < links; ++k) {
                Link& link = all[i * links + k];
                link = {0, static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(i), false};
                if (k + 1 >= found.size()) continue;
                link.to = index.input(found[k + 1].place);
                const SurfaceElement& b = elements[link.to];
                // The normal at b that continues a along a circular arc from a to b.
                const Eigen::Vector3d step = (b.centre_mm - a.centre_mm).normalized();
                const double agreement = (a.normal - 2 * a.normal.dot(step) * step).dot(b.normal);
                link.opposite = agreement < 0;
                link.cost = static_cast<std::uint32_t>((1 - std::min(1.0, std::abs(agreement))) * 1e6);
            }
        }
    });
    std::erase_if(all, [](const Link& link) { return link.from == link.to; });
    graph.links = inOrderOfCost(std::move(all));
    return graph;
}

// Each set of connected elements is turned so that it encloses a positive volume.
std::vector<bool> turnOutward(const std::vector<SurfaceElement>& elements, const std::vector<double>& areas,
                              Senses& senses)
{
    std::vector<bool> flips(elements.size());
    std::vector<std::uint32_t> roots(elements.size());
    std::vector<double> set_area(elements.size(), 0);
    std::vector<Eigen::Vector3d> set_centre(elements.size(), Eigen::Vector3d::Zero());
    for (std::uint32_t i = 0; i < elements.size(); ++i) {
        bool flip = false;
        roots[i] = senses.root(i, flip);
        flips[i] = flip;
        set_area[roots[i]] += areas[i];
        set_centre[roots[i]] += areas[i] * (elements[i].centre_mm - elements[0].centre_mm);
    }
    std::vector<double> volume(elements.size(), 0);
    for (std::size_t i = 0; i < elements.size(); ++i) {
        const std::uint32_t r = roots[i];
        if (!(set_area[r] > 0)) continue;
        const Eigen::Vector3d centre = elements[0].centre_mm + set_centre[r] / set_area[r];
        volume[r] += (flips[i] ? -1 : 1) * areas[i] * elements[i].normal.dot(elements[i].centre_mm - centre);
    }
    for (std::size_t i = 0; i < elements.size(); ++i)
        if (volume[roots[i]] < 0) flips[i] = !flips[i];
    return flips;
}

// Contribution of a cluster of elements to the winding number, in the far field as a single element.
struct Bundle {
    Eigen::Vector3d centre_mm = Eigen::Vector3d::Zero();
    Eigen::Vector3d area_mm2 = Eigen::Vector3d::Zero();  ///< times the normals
    double radius_mm = 0;
};

constexpr std::size_t bundleSize = 32;

std::vector<Bundle> bundlesOf(const std::vector<SurfaceElement>& elements, const std::vector<Eigen::Vector3d>& areas)
{
    std::vector<Bundle> bundles((elements.size() + bundleSize - 1) / bundleSize);
    for (std::size_t b = 0; b < bundles.size(); ++b) {
        const std::size_t begin = b * bundleSize;
        const std::size_t end = std::min(begin + bundleSize, elements.size());
        Bundle& bundle = bundles[b];
        double weight = 0;
        for (std::size_t i = begin; i < end; ++i) {
            bundle.area_mm2 += areas[i];
            bundle.centre_mm += areas[i].norm() * (elements[i].centre_mm - elements[begin].centre_mm);
            weight += areas[i].norm();
        }
        bundle.centre_mm = elements[begin].centre_mm + bundle.centre_mm / (weight > 0 ? weight : 1);
        for (std::size_t i = begin; i < end; ++i)
            bundle.radius_mm = std::max(bundle.radius_mm, (elements[i].centre_mm - bundle.centre_mm).norm());
    }
    return bundles;
}

// The winding number at a place, but for the factor 4 pi.
double solidAngle(const std::vector<SurfaceElement>& elements, const std::vector<Eigen::Vector3d>& areas,
                  const std::vector<Bundle>& bundles, const Eigen::Vector3d& at_mm)
{
    constexpr double far = 4;  // in radii; the neglected term is of the order of its inverse square
    const auto seen = [&](const Eigen::Vector3d& area, const Eigen::Vector3d& centre) {
        const Eigen::Vector3d d = centre - at_mm;
        const double squared = d.squaredNorm();
        return area.dot(d) / (squared * std::sqrt(squared));
    };
    double sum = 0;
    for (std::size_t b = 0; b < bundles.size(); ++b) {
        const Bundle& bundle = bundles[b];
        if ((bundle.centre_mm - at_mm).squaredNorm() > far * far * bundle.radius_mm * bundle.radius_mm) {
            sum += seen(bundle.area_mm2, bundle.centre_mm);
            continue;
        }
        const std::size_t end = std::min((b + 1) * bundleSize, elements.size());
        for (std::size_t i = b * bundleSize; i < end; ++i) sum += seen(areas[i], elements[i].centre_mm);
    }
    return sum;
}

bool isClosed(const std::vector<SurfaceElement>& elements, const std::vector<double>& areas,
              const std::vector<bool>& flips, const Progress& progress)
{
    const std::size_t step = std::max<std::size_t>(1, elements.size() / windingSamples);
    const std::size_t count = (elements.size() + step - 1) / step;
    std::vector<Eigen::Vector3d> outward(elements.size());
    for (std::size_t i = 0; i < elements.size(); ++i)
        outward[i] = (flips[i] ? -areas[i] : areas[i]) * elements[i].normal;
    const std::vector<Bundle> bundles = bundlesOf(elements, outward);
    const int good = parallelReduce(
        count, 4, progress, 0,
        [&](std::size_t begin, std::size_t end) {
            int result = 0;
            for (std::size_t s = begin; s < end; ++s) {
                const SurfaceElement& at = elements[s * step];
                const Eigen::Vector3d out = (flips[s * step] ? -4 : 4) * at.radius_mm * at.normal;
                const auto windingAt = [&](const Eigen::Vector3d& place) {
                    return solidAngle(elements, outward, bundles, place) / (4 * std::numbers::pi);
                };
                const double inside = windingAt(at.centre_mm - out);
                const double outside = windingAt(at.centre_mm + out);
                result += std::abs(inside - 1) < windingTolerance && std::abs(outside) < windingTolerance;
            }
            return result;
        },
        [](int a, int b) { return a + b; });
    return good >= leastConsistentShare * static_cast<double>(count);
}

}  // namespace

std::vector<bool> findOutside(const std::vector<SurfaceElement>& elements, const Progress& progress)
{
    if (elements.size() < 20) return {};
    const Graph graph = connect(elements, progress);
    Senses senses(elements.size());
    for (const Link& link : graph.links) senses.join(link.from, link.to, link.opposite);
    std::vector<bool> flips = turnOutward(elements, graph.areas_mm2, senses);
    if (!isClosed(elements, graph.areas_mm2, flips, progress)) flips.clear();
    return flips;
}

}  // namespace lathelier::registration
