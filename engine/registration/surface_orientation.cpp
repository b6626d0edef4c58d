#include "engine/registration/surface_orientation.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <tuple>

#include "engine/core/parallel.h"
#include "engine/registration/neighbours.h"
#include "engine/registration/senses.h"

namespace lathelier::registration {
namespace {

constexpr std::size_t links = 8;      // of an element to its neighbours
constexpr std::size_t samples = 120;  // places where the winding number is looked at
constexpr double winding_tolerance = 0.25;
constexpr double min_good_share = 0.9;

struct Link {
    std::uint32_t cost;  // 0: the two senses agree beyond doubt
    std::uint32_t from;
    std::uint32_t to;
    bool opposite;
};

struct Graph {
    std::vector<Link> links;
    std::vector<double> areas_mm2;
};

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
        std::vector<Neighbours::Found> found;
        for (std::size_t i = begin; i < end; ++i) {
            const SurfaceElement& a = elements[i];
            index.nearest(a.centre_mm, links + 1, std::pow(4 * a.radius_mm, 2), found);
            graph.areas_mm2[i] = found.empty() ? 0
                                               : std::numbers::pi * found.back().squared_mm2 /
                                                     std::max(1.0, static_cast<double>(found.size()) - 0.5);
            for (std::size_t k = 0; k < links; ++k) {
                Link& link = all[i * links + k];
                link = {0, static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(i), false};
                if (k + 1 >= found.size()) continue;
                link.to = index.input(found[k + 1].place);
                const SurfaceElement& b = elements[link.to];
                // The normal that a continues with, were the surface an arc from a to b.
                const Eigen::Vector3d step = (b.centre_mm - a.centre_mm).normalized();
                const double agreement = (a.normal - 2 * a.normal.dot(step) * step).dot(b.normal);
                link.opposite = agreement < 0;
                link.cost = static_cast<std::uint32_t>((1 - std::min(1.0, std::abs(agreement))) * 1e6);
            }
        }
    });
    for (const Link& link : all)
        if (link.from != link.to) graph.links.push_back(link);
    std::sort(graph.links.begin(), graph.links.end(), [](const Link& a, const Link& b) {
        return std::tie(a.cost, a.from, a.to) < std::tie(b.cost, b.from, b.to);
    });
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

bool isClosed(const std::vector<SurfaceElement>& elements, const std::vector<double>& areas,
              const std::vector<bool>& flips, const Progress& progress)
{
    const std::size_t step = std::max<std::size_t>(1, elements.size() / samples);
    const std::size_t count = (elements.size() + step - 1) / step;
    const int good = parallelReduce(
        count, 4, progress, 0,
        [&](std::size_t begin, std::size_t end) {
            int result = 0;
            for (std::size_t s = begin; s < end; ++s) {
                const SurfaceElement& at = elements[s * step];
                const Eigen::Vector3d out = (flips[s * step] ? -4 : 4) * at.radius_mm * at.normal;
                double inside = 0;
                double outside = 0;
                for (std::size_t i = 0; i < elements.size(); ++i) {
                    const Eigen::Vector3d an = (flips[i] ? -areas[i] : areas[i]) * elements[i].normal;
                    const Eigen::Vector3d d = elements[i].centre_mm - at.centre_mm;
                    const Eigen::Vector3d to_inside = d + out;
                    const Eigen::Vector3d to_outside = d - out;
                    const double in2 = to_inside.squaredNorm();
                    const double out2 = to_outside.squaredNorm();
                    inside += an.dot(to_inside) / (in2 * std::sqrt(in2));
                    outside += an.dot(to_outside) / (out2 * std::sqrt(out2));
                }
                inside /= 4 * std::numbers::pi;
                outside /= 4 * std::numbers::pi;
                result += std::abs(inside - 1) < winding_tolerance && std::abs(outside) < winding_tolerance;
            }
            return result;
        },
        [](int a, int b) { return a + b; });
    return good >= min_good_share * static_cast<double>(count);
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
