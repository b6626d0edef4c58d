// Nearest points of a cloud and nearest places of a mesh, beside nanoflann and CGAL's AABB tree on the same data and
// the same queries, all in Hilbert order, as the comparison asks. All are exact; the sums of distances are shown, so
// that one sees that they answer the same question.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "engine/registration/neighbours/neighbours.h"
#include "engine/registration/neighbours/neighbours_order.h"
#include "engine/registration/surface/surface_mesh.h"
#include "engine/registration/surroundings.h"
#include "engine/sample/sample.h"
#ifdef LATHELIER_WITH_CGAL
#include "tests/peers/mesh_cgal.h"
#endif
#ifdef LATHELIER_WITH_NANOFLANN
#include <nanoflann.hpp>
#endif

namespace {

using namespace lathelier;
using Points = std::vector<Eigen::Vector3d>;

constexpr std::size_t cloudSize = 700000;
constexpr std::size_t queryCount = cloudSize;  // a copy is scanned as its original was
constexpr std::size_t kMany = 24;
constexpr std::size_t kTogether = 512;  // queries of one step

const Points& cloud()
{
    static const Points points = sample::scanBracket(cloudSize, 0.05, Eigen::Isometry3d::Identity(), 1).points_mm;
    return points;
}

Points inHilbertOrder(const Points& points)
{
    Points ordered;
    ordered.reserve(points.size());
    for (const std::uint32_t index : registration::hilbertOrder(points)) ordered.push_back(points[index]);
    return ordered;
}

const Points& queries()
{
    static const Points points =
        inHilbertOrder(sample::scanBracket(queryCount, 0.05, Eigen::Isometry3d::Identity(), 2).points_mm);
    return points;
}

void showSum(benchmark::State& state, double sum_mm)
{
    state.counters["sum_mm"] = sum_mm;
}

void buildOurs(benchmark::State& state)
{
    for (auto _ : state) benchmark::DoNotOptimize(registration::Neighbours(cloud()).size());
}

void nearestOurs(benchmark::State& state)
{
    const registration::Neighbours index(cloud());
    double sum_mm = 0;
    for (auto _ : state) {
        sum_mm = 0;
        for (const Eigen::Vector3d& query : queries()) sum_mm += std::sqrt(index.nearest(query).squared_mm2);
    }
    showSum(state, sum_mm);
}

/// As the comparison asks: many queries that follow each other in space at once.
void nearestOursTogether(benchmark::State& state)
{
    const registration::Neighbours index(cloud());
    double sum_mm = 0;
    for (auto _ : state) {
        sum_mm = 0;
        std::array<registration::Neighbours::Found, kTogether> found;
        for (std::size_t i = 0; i < queries().size(); i += kTogether) {
            const auto some = std::span(queries()).subspan(i, std::min(kTogether, queries().size() - i));
            index.nearest(some, std::numeric_limits<double>::infinity(), std::span(found).first(some.size()));
            for (std::size_t k = 0; k < some.size(); ++k) sum_mm += std::sqrt(found[k].squared_mm2);
        }
    }
    showSum(state, sum_mm);
}

/// What an iterative alignment asks: the same queries again, a little moved (here 5 µm each time).
void nearestOursAgain(benchmark::State& state)
{
    const registration::Neighbours index(cloud());
    std::vector<registration::Neighbours::Trace> traces(queries().size());
    std::array<registration::Neighbours::Found, kTogether> found;
    std::array<Eigen::Vector3d, kTogether> moved;
    Eigen::Vector3d shift(0, 0, 0);
    double sum_mm = 0;
    const auto ask = [&] {
        sum_mm = 0;
        for (std::size_t i = 0; i < queries().size(); i += kTogether) {
            const std::size_t count = std::min(kTogether, queries().size() - i);
            for (std::size_t k = 0; k < count; ++k) moved[k] = queries()[i + k] + shift;
            index.nearest(std::span(moved).first(count), std::numeric_limits<double>::infinity(),
                          std::span(traces).subspan(i, count), std::span(found).first(count));
            for (std::size_t k = 0; k < count; ++k) sum_mm += std::sqrt(found[k].squared_mm2);
        }
    };
    ask();
    for (auto _ : state) {
        shift.x() = shift.x() > 0 ? 0 : 0.005;
        ask();
    }
    showSum(state, sum_mm);
}

/// The 24 nearest of every point of the cloud itself, as normals and patches ask.
void nearest24Ours(benchmark::State& state)
{
    const registration::Neighbours index(cloud());
    const Points own = inHilbertOrder(cloud());
    double sum_mm = 0;
    for (auto _ : state) {
        sum_mm = 0;
        double expected_mm2 = 0.01;
        std::vector<registration::Neighbours::Found> found;
        for (const Eigen::Vector3d& query : own) {
            index.nearestUnsorted(query, kMany, expected_mm2, found);
            double most = 0;
            for (const auto& one : found) most = std::max(most, one.squared_mm2);
            sum_mm += std::sqrt(most);
        }
    }
    showSum(state, sum_mm);
}

/// The same from the points around some of them at once, as patches are made.
void nearest24OursTogether(benchmark::State& state)
{
    constexpr std::size_t kSome = 16;
    const registration::Neighbours index(cloud());
    double sum_mm = 0;
    for (auto _ : state) {
        sum_mm = 0;
        double expected_mm2 = 0.01;
        registration::Surroundings surroundings(index);
        std::vector<registration::Neighbours::Found> found;
        for (std::size_t i = 0; i < index.size(); i += kSome) {
            registration::Box box;
            const std::size_t end = std::min(i + kSome, index.size());
            for (std::size_t k = i; k < end; ++k) box.add(index.point_mm(static_cast<std::uint32_t>(k)));
            surroundings.collect(box, expected_mm2, 256);
            for (std::size_t k = i; k < end; ++k) {
                const Eigen::Vector3d query = index.point_mm(static_cast<std::uint32_t>(k));
                if (!surroundings.nearest(query, kMany, found))
                    index.nearestUnsorted(query, kMany, expected_mm2, found);
                double most = 0;
                for (const auto& one : found) most = std::max(most, one.squared_mm2);
                sum_mm += std::sqrt(most);
                expected_mm2 = 1.2 * most;
            }
        }
    }
    showSum(state, sum_mm);
}

BENCHMARK(nearest24OursTogether)->Unit(benchmark::kMillisecond);
BENCHMARK(buildOurs)->Unit(benchmark::kMillisecond);
BENCHMARK(nearestOursAgain)->Unit(benchmark::kMillisecond);
BENCHMARK(nearest24Ours)->Unit(benchmark::kMillisecond);
BENCHMARK(nearestOurs)->Unit(benchmark::kMillisecond);
BENCHMARK(nearestOursTogether)->Unit(benchmark::kMillisecond);

#ifdef LATHELIER_WITH_NANOFLANN
struct CloudAdaptor {
    const Points& points;
    std::size_t kdtree_get_point_count() const { return points.size(); }
    double kdtree_get_pt(std::size_t index, std::size_t axis) const
    {
        return points[index][static_cast<Eigen::Index>(axis)];
    }
    template <class Box>
    bool kdtree_get_bbox(Box&) const
    {
        return false;
    }
};
using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, CloudAdaptor>, CloudAdaptor, 3>;

void buildNanoflann(benchmark::State& state)
{
    const CloudAdaptor adaptor{cloud()};
    for (auto _ : state) {
        Tree tree(3, adaptor, {10});
        tree.buildIndex();
        std::size_t bytes = tree.usedMemory(tree);
        benchmark::DoNotOptimize(bytes);
    }
}

void nearestNanoflann(benchmark::State& state)
{
    const CloudAdaptor adaptor{cloud()};
    Tree tree(3, adaptor, {10});
    tree.buildIndex();
    double sum_mm = 0;
    for (auto _ : state) {
        sum_mm = 0;
        for (const Eigen::Vector3d& query : queries()) {
            std::uint32_t index = 0;
            double squared_mm2 = 0;
            tree.knnSearch(query.data(), 1, &index, &squared_mm2);
            sum_mm += std::sqrt(squared_mm2);
        }
    }
    showSum(state, sum_mm);
}

void nearest24Nanoflann(benchmark::State& state)
{
    const CloudAdaptor adaptor{cloud()};
    const Points own = inHilbertOrder(cloud());
    Tree tree(3, adaptor, {10});
    tree.buildIndex();
    double sum_mm = 0;
    for (auto _ : state) {
        sum_mm = 0;
        std::array<std::uint32_t, kMany> index{};
        std::array<double, kMany> squared_mm2{};
        for (const Eigen::Vector3d& query : own) {
            tree.knnSearch(query.data(), kMany, index.data(), squared_mm2.data());
            sum_mm += std::sqrt(squared_mm2.back());
        }
    }
    showSum(state, sum_mm);
}
BENCHMARK(nearest24Nanoflann)->Unit(benchmark::kMillisecond);
BENCHMARK(buildNanoflann)->Unit(benchmark::kMillisecond);
BENCHMARK(nearestNanoflann)->Unit(benchmark::kMillisecond);
#endif

const Scan& mesh()
{
    static const Scan shaft = sample::shaftMesh(sample::copiedShaft(), 400);
    return shaft;
}

/// Points at the shaft's surface, by a scanner.
const Points& meshQueries()
{
    static const Points points = [] {
        sample::ScannerModel scanner;
        scanner.row_pitch_mm = 0.6;
        return inHilbertOrder(sample::scanShaft(sample::copiedShaft(), scanner).points_mm);
    }();
    return points;
}

void placesOurs(benchmark::State& state)
{
    const registration::MeshSurface surface(mesh(), {});
    const std::span<const Eigen::Vector3d> all(meshQueries());
    std::array<registration::SurfacePlace, kTogether> places;
    double sum_mm = 0;
    for (auto _ : state) {
        sum_mm = 0;
        for (std::size_t i = 0; i < all.size(); i += kTogether) {
            const auto some = all.subspan(i, std::min(kTogether, all.size() - i));
            surface.place(some, 10, std::span(places).first(some.size()), {});
            for (std::size_t k = 0; k < some.size(); ++k) sum_mm += std::abs(places[k].distance_mm);
        }
    }
    state.counters["queries"] = static_cast<double>(all.size());
    showSum(state, sum_mm);
}
BENCHMARK(placesOurs)->Unit(benchmark::kMillisecond);

#ifdef LATHELIER_WITH_CGAL
void placesCgal(benchmark::State& state)
{
    const peers::CgalMesh tree(mesh());
    double sum_mm = 0;
    for (auto _ : state) {
        sum_mm = 0;
        for (const Eigen::Vector3d& query : meshQueries()) sum_mm += tree.distance_mm(query);
    }
    state.counters["queries"] = static_cast<double>(meshQueries().size());
    showSum(state, sum_mm);
}
BENCHMARK(placesCgal)->Unit(benchmark::kMillisecond);
#endif

}  // namespace

BENCHMARK_MAIN();
