// Common to reading and writing of files: RAII descriptors and system error messages.
#pragma once

#include <unistd.h>

#include "engine/core/value.h"

namespace lathelier::io {

/// Owns a POSIX file descriptor.
class Descriptor {
public:
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor() { close(); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    int number() const { return number_; }
    bool isOpen() const { return number_ >= 0; }

    /// Closes the descriptor; false when the system reports a failure (delayed write error).
    bool close()
    {
        const int number = number_;
        number_ = -1;
        return number < 0 || ::close(number) == 0;
    }

private:
    int number_;
};

/// Message of `errno`: a translatable phrase for the common ones, else the system's message.
Value systemReason(int error);

}  // namespace lathelier::io
