// An exchange with a control: from the request to `answered`, over TCP on this machine, with the loop's polling period
// of its configuration. Asked: 50 ms. The answer has to be the speed of the paper, else the benchmark is an error.
#include <benchmark/benchmark.h>

#include "engine/link/transports.h"
#include "tests/engine/link/paper_case.h"

namespace lathelier::link {
namespace {

void answerRequests(benchmark::State& state, Assistant assistant, double length_mm)
{
    SimulatedControl control;
    const LinkConfig config = paperConfig(control.port());
    link::state(control, paperValues());
    control.set(lengthName, length_mm);
    assistant.prepare({});
    const std::unique_ptr<Transport> transport = transportOf("loopback", config);
    const RunningLoop running(*transport, assistant, loopSettings(config, false));
    for (auto _ : state) {
        control.request();
        while (!control.correctedRpm() && !running.error()) std::this_thread::sleep_for(std::chrono::microseconds(50));
        if (control.correctedRpm() != paperCorrected_rpm) {
            state.SkipWithError("another speed than that of the paper");
            return;
        }
    }
}

void exchangeWithModes(benchmark::State& state)
{
    answerRequests(state, paperAssistant(paperConfig(1)), 0);
}

void exchangeWithSpindleAndBar(benchmark::State& state)
{
    const ScratchFolder scratch;
    answerRequests(state, Assistant(spindleQuestion(scratch), paperConfig(1).limits), paperLength_mm);
}

BENCHMARK(exchangeWithModes)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(exchangeWithSpindleAndBar)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace lathelier::link

BENCHMARK_MAIN();
