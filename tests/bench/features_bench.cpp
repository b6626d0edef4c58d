// Recognition of the paper's shaft: 732 000 points to the table; the CAD of it; the drawing as a reference.
#include <benchmark/benchmark.h>

#include "engine/cad/step_reader.h"
#include "engine/cad/step_writer.h"
#include "engine/features/comparison/shaft_mesh.h"
#include "engine/features/recognition.h"
#include "engine/features/scene/scene.h"
#include "engine/registration/compare.h"
#include "engine/registration/drawn_reference.h"
#include "engine/sample/sample.h"
#include "engine/shaft/shaft_contour.h"

namespace lathelier {
namespace {

const Scan& scan()
{
    static const Scan made = [] {
        sample::ScannerModel scanner;
        scanner.scan_T_part = Eigen::AngleAxisd(0.007, Eigen::Vector3d::UnitX());
        return sample::scanShaft(sample::nominalShaft(), scanner);
    }();
    return made;
}

void recognition(benchmark::State& state)
{
    scan();
    for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(features::recognize(scan(), {}));
}
BENCHMARK(recognition)->Unit(benchmark::kMillisecond)->UseRealTime();

void sceneCut(benchmark::State& state)
{
    const std::vector<Eigen::Vector3d>& points = scan().points_mm;
    for ([[maybe_unused]] auto _ : state)
        benchmark::DoNotOptimize(features::findScene(points, features::SceneUse::Auto));
}
BENCHMARK(sceneCut)->Unit(benchmark::kMillisecond)->UseRealTime();

/// Against the drawing's meridian (1) or its finest mesh (0).
void drawnReference(benchmark::State& state)
{
    const Shaft shaft = features::recognize(scan(), {}).shaft;
    const registration::DrawnReference drawn{features::shaftMesh(shaft).scan, closedContour(shaft)};
    for ([[maybe_unused]] auto _ : state) {
        if (state.range(0) == 1)
            benchmark::DoNotOptimize(registration::compare(drawn, scan(), {}));
        else
            benchmark::DoNotOptimize(registration::compare(drawn.mesh, scan(), {}));
    }
}
BENCHMARK(drawnReference)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond)->UseRealTime();

/// A drawing with a cone of 30 m that the part has not: the work follows the rows of the drawing, not its size.
void drawnHugeCone(benchmark::State& state)
{
    Shaft shaft;
    shaft.segments = {{98, 30, 30000, 0, {}, {}}, {10, 37, 37, 0, {}, {}}};
    const registration::DrawnReference drawn{features::shaftMesh(shaft).scan, closedContour(shaft)};
    registration::CompareParameters parameters;
    parameters.method = registration::CompareMethod::Plane;
    for ([[maybe_unused]] auto _ : state) try {
            benchmark::DoNotOptimize(registration::compare(drawn, scan(), parameters));
        } catch (const Error&) {  // the parts do not match: that is the answer
        }
}
BENCHMARK(drawnHugeCone)->Unit(benchmark::kMillisecond)->UseRealTime();

void stepOut(benchmark::State& state)
{
    const Shaft shaft = features::recognize(scan(), {}).shaft;
    for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(cad::stepText(shaft, {}));
}
BENCHMARK(stepOut)->Unit(benchmark::kMillisecond);

void stepIn(benchmark::State& state)
{
    const std::string text = cad::stepText(features::recognize(scan(), {}).shaft, {});
    Notes notes;
    for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(cad::readStep(text, notes));
}
BENCHMARK(stepIn)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace lathelier

BENCHMARK_MAIN();
