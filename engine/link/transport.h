// The way to one control: values read and written by name. Each kind of control is one of these and nothing else; what
// is asked, computed and refused is the same for all (link_loop.h).
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/link/control_values.h"

namespace lathelier::link {

class Transport {
public:
    virtual ~Transport() = default;

    /// Connects; returns within the time-out, but for the system that looks up the name of a host. Errors: linkNotFound
    /// (nothing answers, no library), linkTaken (another assistant is linked to this control), linkProtocol.
    virtual void open() = 0;

    /// The values of these names as they stand at one moment, as far as the control can give them so; a register that
    /// holds no number gives NaN. Only what `offers()`. Errors: linkLost (cut, no answer within the time-out),
    /// linkProtocol (an answer that is none).
    virtual ControlValues read(const std::vector<std::string>& names) = 0;

    /// Writes one of writtenNames(). Errors: those of read(); linkValueNotHeld where the register cannot hold the
    /// value.
    virtual void write(const std::string& name, double value) = 0;

    /// Whether the control has a value of this name; what it writes and the request are always there.
    virtual bool offers(const std::string& name) const = 0;

    /// Path of the NC program that is loaded on the control; nothing: it cannot be had. Errors: those of read().
    virtual std::optional<std::string> loadedProgram() { return std::nullopt; }

    /// Disconnects; writes nothing. May be called at any time, also when the link is lost.
    virtual void close() noexcept = 0;

    virtual bool isOpen() const = 0;

    /// Whether open() itself refuses a second assistant; else the heartbeat is watched before anything is written.
    virtual bool isExclusive() const = 0;

    /// "127.0.0.1:7660", "HAL lathelier"
    virtual std::string peer() const = 0;

    /// Whether this kind of link was verified on a real control.
    virtual bool isVerified() const { return true; }
};

}  // namespace lathelier::link
