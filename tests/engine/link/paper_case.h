// The case of the second paper: f 223 Hz, ζ 0.03; D 32 mm and v_c 290 m/min select 2885 1/min, and 3237 is stable.
#pragma once

#include <fmt/format.h>

#include <chrono>
#include <functional>
#include <optional>
#include <thread>
#include <vector>

#include "engine/io/file.h"
#include "engine/link/link_config.h"
#include "engine/link/link_loop.h"
#include "engine/link/loopback/simulated_control.h"
#include "tests/scratch_folder.h"

namespace lathelier::link {

inline constexpr double paperDiameter_mm = 32;
inline constexpr double paperSpeed_m_min = 290;
inline constexpr double paperSelected_rpm = 2884.7;  // 1000 v_c / (π D)
inline constexpr double paperCorrected_rpm = 3237;

/// Of the bar D × L, without a response of its own.
inline std::string barConfigText(const std::string& more)
{
    return R"({"schema": "lathelier-assist", "schema_version": 1, "limits": {"highest_rpm": 6000}, )" + more + "}";
}

inline std::string configText(const std::string& more = R"("loopback": {"host": "127.0.0.1", "port": 1})")
{
    return R"({"schema": "lathelier-assist", "schema_version": 1,
  "parameters": {"mode": [{"frequency_hz": 223, "damping_ratio": 0.03, "stiffness_N_mm": 10000}]},
  "limits": {"highest_rpm": 6000}, "loop": {"poll_ms": 1, "heartbeat_ms": 50, "reconnect_ms": 10, "timeout_ms": 500})" +
           (more.empty() ? "" : ",\n  " + more) + "}";
}

inline LinkConfig paperConfig(int port)
{
    return readConfig(configText(fmt::format(R"("loopback": {{"host": "127.0.0.1", "port": {}}})", port)), ".");
}

/// The spindle of the papers in place of the mode. With the bar D × L in it the least real part lies at 229.6 Hz.
inline constexpr double paperLength_mm = 262.25;
inline constexpr double otherSpeed_m_min = 281.487;  // selects 2800 1/min, at the bottom of a lobe

inline project::PanelState spindleQuestion(const ScratchFolder& scratch)
{
    const std::string path = (scratch / "spindle.json").string();
    io::writeFile(path, R"({"springs": {"radial_N_mm": 14850, "tilt_N_mm_rad": 198.3e6, "loss_factor": 0.06}})");
    project::PanelState question;
    question.inputs["spindle"].path = path;
    return question;
}

inline Assistant paperAssistant(const LinkConfig& config)
{
    return Assistant(config.question, config.limits, config.program);
}

inline ControlValues paperValues()
{
    return {{requestName, 1}, {runningName, 0}, {diameterName, paperDiameter_mm}, {speedName, paperSpeed_m_min}};
}

inline void state(SimulatedControl& control, const ControlValues& values)
{
    for (const auto& [name, value] : values)
        if (name != requestName) control.set(name, value);
}

/// Waits until it holds; false: not within ten seconds.
inline bool holdsSoon(const std::function<bool()>& holds)
{
    for (int i = 0; i < 10000; ++i) {
        if (holds()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return false;
}

/// A loop in a thread of its own; stopped and joined by the destructor.
class RunningLoop {
public:
    RunningLoop(Transport& transport, Assistant& assistant, const LoopSettings& settings)
        : loop_(transport, assistant, settings, [this](const LogEntry& entry) { take(entry); }),
          thread_([this](const std::stop_token& stop) {
              try {
                  loop_.run(Progress(stop, {}));
              } catch (const Error& error) {
                  const std::lock_guard lock(mutex_);
                  error_ = error;
              }
          })
    {
    }
    std::vector<LogEntry> entries() const
    {
        const std::lock_guard lock(mutex_);
        return entries_;
    }
    std::optional<Error> error() const
    {
        const std::lock_guard lock(mutex_);
        return error_;
    }

private:
    void take(const LogEntry& entry)
    {
        const std::lock_guard lock(mutex_);
        entries_.push_back(entry);
    }

    mutable std::mutex mutex_;
    std::vector<LogEntry> entries_;
    std::optional<Error> error_;
    LinkLoop loop_;
    std::jthread thread_;  ///< the last member: it uses the others
};

}  // namespace lathelier::link
