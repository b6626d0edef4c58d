// The 3-D view while it is turned: from the wish to the last pixel on the screen.
//   xvfb-run -a -s "-screen 0 1920x1080x24 +extension GLX" build/tests/scene_bench
#include <benchmark/benchmark.h>

#include <QApplication>
#include <QScreen>
#include <cmath>

#include "engine/core/skin.h"
#include "engine/sample/sample.h"
#include "widgets/scene/scene_view.h"

using namespace lathelier;

namespace {

std::vector<scene::SceneObject> twoScans()
{
    static const auto scan =
        std::make_shared<const Scan>(sample::scanShaft(sample::nominalShaft(), sample::ScannerModel{}));
    static const auto values = [] {
        auto result = std::make_shared<std::vector<float>>(scan->points_mm.size());
        for (std::size_t i = 0; i < result->size(); ++i) (*result)[i] = static_cast<float>(i % 200) * 1e-3F - 0.1F;
        return result;
    }();
    scene::SceneObject reference;
    reference.scan = scan;
    reference.colour = QColor(31, 119, 180);
    scene::SceneObject copy = reference;
    copy.scan = std::make_shared<const Scan>(*scan);
    copy.scene_T_scan.translation().x() = 40;
    copy.values = values;
    return {reference, copy};
}

/// The closed surface that a comparison draws, as fine as it becomes.
std::vector<scene::SceneObject> skin()
{
    Skin surface;
    surface.stations =
        stationsAlong({{0, 0}, {0, 15}, {98, 15}, {98, 18.5}, {108, 18.5}, {108, 17}, {183, 17}, {183, 0}}, 0.6);
    surface.angle_count = 240;
    surface.values.resize(surface.vertexCount());
    for (std::size_t i = 0; i < surface.values.size(); ++i)
        surface.values[i] = 0.1F * std::sin(static_cast<float>(i) * 1e-3F);
    surface.shift_mm = normalShift_mm(surface);
    scene::SceneObject part;
    part.scan = std::make_shared<const Scan>(meshOf(surface, 20, Eigen::Isometry3d::Identity()));
    part.values = std::make_shared<const std::vector<float>>(surface.values);
    return {part};
}

/// One frame as the user gets it: drawn, composed, sent, taken by the X server.
void frame(scene::SceneView& view, double right_deg)
{
    view.turn(right_deg, 0);
    QCoreApplication::processEvents();         // draws
    QCoreApplication::processEvents();         // paints
    view.screen()->grabWindow(0, 0, 0, 1, 1);  // answered after all that was sent before
}

void turning(benchmark::State& state, std::vector<scene::SceneObject> objects)
{
    scene::SceneView view;
    view.resize(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
    view.show();
    view.setObjects(std::move(objects));
    for (int i = 0; i < 12; ++i) frame(view, 3);  // until the thinning has settled
    for (auto _ : state) frame(view, 3);
    state.counters["drawing_ms"] = 1000 * view.speed().moving_s;
    state.counters["points"] = static_cast<double>(view.speed().moving_points);
}

}  // namespace

int main(int argc, char** argv)
{
    QApplication application(argc, argv);
    for (const auto& [name, objects] : {std::pair{"empty scene", std::vector<scene::SceneObject>{}},
                                        {"2 x 732k points", twoScans()},
                                        {"skin", skin()}})
        benchmark::RegisterBenchmark(name, [objects = objects](benchmark::State& state) { turning(state, objects); })
            ->Args({1280, 720})
            ->Args({1920, 1080})
            ->Unit(benchmark::kMillisecond)
            ->MeasureProcessCPUTime()
            ->UseRealTime();
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
