// Stock: a path of 1e6 moves as it is drawn, a roughing program of 200 moves at 20 and 5 µm, 750 moves on 240 mm with a
// holder, 1e5 short moves. One core.
#include <benchmark/benchmark.h>

#include <cmath>

#include "engine/core/parallel.h"
#include "engine/stock/drawn_path.h"
#include "engine/stock/stock_check.h"

namespace lathelier::stock {
namespace {

Shaft rod(double length_mm, double diameter_mm)
{
    Shaft shaft;
    shaft.segments = {{length_mm, diameter_mm, diameter_mm, 0, {}, {}}};
    return shaft;
}

/// Passes along z, each with rapid approach, cut, retract and rapid return.
std::vector<gcode::Move> roughing(int passes, double length_mm, double radius_mm)
{
    std::vector<gcode::Move> moves;
    const auto add = [&moves](gcode::MoveKind kind, double z_mm, double x_mm) {
        gcode::Move move;
        move.line = static_cast<std::int64_t>(moves.size()) + 1;
        move.kind = kind;
        move.z_mm = z_mm;
        move.x_mm = x_mm;
        moves.push_back(move);
    };
    for (int i = 1; i <= passes; ++i) {
        const double x_mm = radius_mm - 0.5 * radius_mm * i / passes, end_mm = length_mm * (1 - 0.5 * i / passes);
        add(gcode::MoveKind::Rapid, 3, x_mm);
        add(gcode::MoveKind::Feed, -end_mm, x_mm);
        add(gcode::MoveKind::Feed, -end_mm + 0.5, x_mm + 0.5);
        add(gcode::MoveKind::Rapid, 3, x_mm + 0.5);
    }
    return moves;
}

StockParameters parametersOf(double step_mm, bool has_holder)
{
    Tool tool;
    tool.corner_radius_mm = 0.8;
    tool.entering_angle_deg = 95;
    tool.tip_angle_deg = 80;
    tool.edge_length_mm = 12;
    if (has_holder) tool.shank_width_mm = 20;
    StockParameters parameters;
    parameters.tools = {tool};
    parameters.step_mm = step_mm;
    parameters.chuck = ChuckBody{};
    return parameters;
}

void moves200(benchmark::State& state)
{
    const ThreadLimit one(1);
    const std::vector<gcode::Move> moves = roughing(50, 80, 20);
    const StockParameters parameters = parametersOf(static_cast<double>(state.range(0)) / 1000, state.range(1) != 0);
    for (auto _ : state) benchmark::DoNotOptimize(simulateStock(rod(100, 40), moves, parameters));
}
BENCHMARK(moves200)->Args({20, 0})->Args({20, 1})->Args({5, 0})->Args({5, 1})->Unit(benchmark::kMillisecond);

void moves750(benchmark::State& state)
{
    const std::vector<gcode::Move> moves = roughing(188, 230, 40);
    const StockParameters parameters = parametersOf(static_cast<double>(state.range(0)) / 1000, true);
    for (auto _ : state) benchmark::DoNotOptimize(simulateStock(rod(240, 80), moves, parameters));
}
BENCHMARK(moves750)->Arg(20)->Arg(5)->Unit(benchmark::kMillisecond);

void moves100000(benchmark::State& state)
{
    const std::vector<gcode::Move> moves = roughing(25000, 280, 20);
    const StockParameters parameters = parametersOf(0.02, state.range(0) != 0);
    for (auto _ : state) benchmark::DoNotOptimize(simulateStock(rod(290, 40), moves, parameters));
}
BENCHMARK(moves100000)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond)->Iterations(1);

/// The path of 1e6 short moves: made, thinned for a screen, pointed at.
std::vector<gcode::Move> contour(int count)
{
    std::vector<gcode::Move> moves(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        gcode::Move& move = moves[static_cast<std::size_t>(i)];
        move.line = i + 1;
        move.kind = gcode::MoveKind::Feed;
        move.x_mm = 15 + 0.2 * std::sin(0.001 * i);
        move.z_mm = -0.0003 * i;
    }
    return moves;
}

void pathMade(benchmark::State& state)
{
    const std::vector<gcode::Move> moves = contour(1000000);
    for (auto _ : state) benchmark::DoNotOptimize(DrawnPath(moves, 0, moves.size()));
}
BENCHMARK(pathMade)->Unit(benchmark::kMillisecond);

void pathThinned(benchmark::State& state)
{
    const std::vector<gcode::Move> moves = contour(1000000);
    const DrawnPath path(moves, 0, moves.size());
    for (auto _ : state) benchmark::DoNotOptimize(path.curves(path.whole(1000)));
}
BENCHMARK(pathThinned)->Unit(benchmark::kMillisecond);

void pathPointedAt(benchmark::State& state)
{
    const std::vector<gcode::Move> moves = contour(1000000);
    const DrawnPath path(moves, 0, moves.size());
    for (auto _ : state) benchmark::DoNotOptimize(path.nearest({150, 15}, 0.3, 0.01));
}
BENCHMARK(pathPointedAt)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace lathelier::stock

BENCHMARK_MAIN();
