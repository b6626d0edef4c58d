// NC programs: reading and running a million blocks.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <string>

#include "engine/gcode/toolpath.h"

namespace lathelier::gcode {
namespace {

std::string longProgram(int blocks)
{
    std::string text = "%\nO1\nG21 G99\nG96 S200 M3\nG0 X50. Z2.\nG1 Z0. F0.2\n";
    for (int i = 0; i < blocks; ++i)
        text += fmt::format("N{} X{}.{} Z-{}.25\n", i % 9999, 20 + i % 17, i % 1000, i / 1000);
    return text += "M30\n%\n";
}

void readAndRun(benchmark::State& state)
{
    const std::string text = longProgram(static_cast<int>(state.range(0)));
    for (auto _ : state) {
        Program program = readProgram(text);
        benchmark::DoNotOptimize(findToolpath(program));
    }
}
BENCHMARK(readAndRun)->Arg(1000)->Arg(1000000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace lathelier::gcode

BENCHMARK_MAIN();
