// The check of turning programs: practice programs of 40 to 200 moves, and 750 moves on a shaft of 240 mm with 60
// steps. One core.
#include <benchmark/benchmark.h>

#include <fstream>
#include <iterator>
#include <string>

#include "engine/cam/check/insert_check.h"
#include "engine/cam/check/surface_deviation.h"
#include "engine/cam/check/turning_check.h"
#include "engine/cam/job_file.h"
#include "engine/core/parallel.h"

namespace lathelier::cam {
namespace {

std::string textOf(const std::string& name)
{
    std::ifstream file(LATHELIER_SOURCE_DIR "/tests/data/turning/" + name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

Job jobOf(const std::string& name)
{
    Notes notes;
    return readJob(textOf(name + "_job.json"), notes);
}

/// A shaft of 60 steps that grows toward the chuck, and a program that roughs it and follows it.
struct ManySteps {
    Job job = jobOf("paper_s1");
    std::string text = "G21 G18 G40 G99\nT0101\nG0 X90. Z3.\n";

    ManySteps()
    {
        constexpr int steps = 60;
        constexpr double step_mm = 4, first_mm = 20, rise_mm = 1;
        const auto add = [this](const char* words, double x, double z) {
            text += std::string(words) + " X" + std::to_string(x) + " Z" + std::to_string(z) + " F.2\n";
        };
        job.stock.diameter_mm = 82;
        job.setup.chuck_face_z_mm = 260;
        job.shaft->segments.clear();
        for (int i = 0; i < steps; ++i)
            job.shaft->segments.push_back({step_mm, first_mm + rise_mm * i, first_mm + rise_mm * i, 0, {}, ""});
        for (int pass = 3; pass > 0; --pass)
            for (int i = steps - 1; i >= 0; --i) {
                const double x = first_mm + rise_mm * i + 0.6 * pass;
                add("G0", x, 3);
                add("G1", x, -step_mm * (i + 1) + 0.3);
                add("G0", 90, 3);
            }
        text += "T0202\nG0 X90. Z2.\n";
        add("G1", first_mm, 2);
        for (int i = 0; i < steps; ++i) {
            add("G1", first_mm + rise_mm * i, -step_mm * (i + 1));
            add("G1", first_mm + rise_mm * (i + 1), -step_mm * (i + 1));
            if (i % 2 == 0) add("G1", first_mm + rise_mm * (i + 1), -step_mm * (i + 1) - 1);
        }
        text += "G0 X100.\nM30\n";
    }
};

void whole(benchmark::State& state, const std::string& text, const Job& job)
{
    const ThreadLimit one(1);
    std::size_t moves = 0;
    for (auto _ : state) {
        const CheckResult result = checkTurning(text, *job.shaft, job);
        moves = result.path.moves.size();
        benchmark::DoNotOptimize(result.gouge_um);
    }
    state.counters["moves"] = static_cast<double>(moves);
}

/// The exact part alone: nose against drawing.
void exact(benchmark::State& state, const std::string& text, const Job& job)
{
    const ThreadLimit one(1);
    const CheckResult read = checkTurning(text, *job.shaft, job);
    Notes notes;
    for (auto _ : state) {
        const DrawnContour drawing(*job.shaft);
        AllStrokes all{cutterPath(read.path.moves, job, {}, notes), 0};
        all.own = all.strokes.size();
        const BarLimits bar{job.stock.diameter_mm / 2, -job.stock.face_allowance_mm};
        benchmark::DoNotOptimize(surfaceDeviation(drawing, all, bar, {}, gougeLimit_mm, leftLimit_mm).gouge_mm);
    }
}

void insert(benchmark::State& state, const std::string& text, const Job& job)
{
    const ThreadLimit one(1);
    const CheckResult read = checkTurning(text, *job.shaft, job);
    const DrawnContour drawing(*job.shaft);
    for (auto _ : state) benchmark::DoNotOptimize(insertsBelow(read.path.moves, job, drawing, 0).size());
}

const ManySteps many;

BENCHMARK_CAPTURE(whole, paper, textOf("paper_s1_fanuc_a.nc"), jobOf("paper_s1"))->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(whole, neck, textOf("neck_all_fanuc_a.nc"), jobOf("neck_all"))->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(whole, many_steps, many.text, many.job)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(exact, paper, textOf("paper_s1_fanuc_a.nc"), jobOf("paper_s1"))->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(exact, neck, textOf("neck_all_fanuc_a.nc"), jobOf("neck_all"))->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(exact, many_steps, many.text, many.job)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(insert, neck, textOf("neck_all_fanuc_a.nc"), jobOf("neck_all"))->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(insert, many_steps, many.text, many.job)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace lathelier::cam

BENCHMARK_MAIN();
