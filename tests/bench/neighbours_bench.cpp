// Nearest points of a cloud and nearest places of a mesh, beside nanoflann and CGAL's AABB tree on the same data and
// the same queries. All are exact; the sums of distances are shown, so that one sees that they answer the same
// question.
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "engine/registration/neighbours/neighbours.h"
#include "engine/registration/surface/surface_mesh.h"
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
constexpr std::size_t queryCount = 100000;

const Points& cloud()
{
    static const Points points = sample::scanBracket(cloudSize, 0.05, Eigen::Isometry3d::Identity(), 1).points_mm;
    return points;
}

const Points& queries()
{
    static const Points points = sample::scanBracket(queryCount, 0.05, Eigen::Isometry3d::Identity(), 2).points_mm;
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

/// As the comparison asks: eight queries that lie near each other at once. The bracket's points come in no such order,
/// so that this is its worst case.
void nearestOursByEight(benchmark::State& state)
{
    const registration::Neighbours index(cloud());
    double sum_mm = 0;
    for (auto _ : state) {
        sum_mm = 0;
        for (std::size_t i = 0; i + 8 <= queries().size(); i += 8) {
            std::array<registration::Neighbours::Found, 8> found;
            index.nearest(std::span(queries()).subspan(i, 8), std::numeric_limits<double>::infinity(), found);
            for (const auto& one : found) sum_mm += std::sqrt(one.squared_mm2);
        }
    }
    showSum(state, sum_mm);
}

BENCHMARK(buildOurs)->Unit(benchmark::kMillisecond);
BENCHMARK(nearestOurs)->Unit(benchmark::kMillisecond);
BENCHMARK(nearestOursByEight)->Unit(benchmark::kMillisecond);

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
        benchmark::DoNotOptimize(tree);
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
        return sample::scanShaft(sample::copiedShaft(), scanner).points_mm;
    }();
    return points;
}

void placesOurs(benchmark::State& state)
{
    const registration::MeshSurface surface(mesh(), {});
    const std::span<const Eigen::Vector3d> all(meshQueries());
    std::array<registration::SurfacePlace, registration::Surface::bundle> places;
    std::array<std::uint32_t, registration::Surface::bundle> hints;
    double sum_mm = 0;
    for (auto _ : state) {
        sum_mm = 0;
        for (std::size_t i = 0; i + places.size() <= all.size(); i += places.size()) {
            hints.fill(registration::Surface::no_hint);
            surface.place(all.subspan(i, places.size()), 10, places, hints);
            for (const registration::SurfacePlace& place : places) sum_mm += std::abs(place.distance_mm);
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
