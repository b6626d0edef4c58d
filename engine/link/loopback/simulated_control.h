// A control that is simulated: its registers, served to one assistant over TCP (messages.h) from a thread of its own.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "engine/link/control_values.h"

namespace lathelier::link {

class SimulatedControl {
public:
    /// Listens on this machine; port 0: any that is free. Error linkPortNotFree. `changed` is told, from the thread
    /// that serves, of everything that the assistant wrote, and of an assistant that came or went.
    explicit SimulatedControl(int port = 0, std::function<void()> changed = {});
    ~SimulatedControl();
    SimulatedControl(const SimulatedControl&) = delete;
    SimulatedControl& operator=(const SimulatedControl&) = delete;

    int port() const;
    ControlValues values() const;  ///< all of them
    /// What a control states; the values that an assistant writes are its own.
    void set(const std::string& name, double value);
    void setProgram(const std::string& path);
    /// States the next request: the operator asks. Its number.
    std::int64_t request();
    /// Whether N_cor holds: `answered` is the request, and the state is Ok.
    std::optional<double> correctedRpm() const;
    bool isLinked() const;

    /// What can go wrong, for tests and lessons.
    enum class Fault { Cut, Garbage, WrongId, Silence };
    /// Happens in place of an answer, after `answers` further ones.
    void failAfter(std::int64_t answers, Fault fault);

private:
    struct Server;
    std::unique_ptr<Server> server_;
};

}  // namespace lathelier::link
