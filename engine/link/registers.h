// Registers of a control that hold whole numbers, and which of them cannot keep the promises of the link.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace lathelier::link {

/// Where a value stands in the R area of a PMC: whole numbers of 1, 2 or 4 bytes, little-endian, with sign.
struct Register {
    int address = 0;   ///< of its first byte: R1000
    int bytes = 4;     ///< 1, 2 or 4
    double scale = 1;  ///< value = number times scale

    int last() const { return address + bytes - 1; }  ///< address of its last byte
};

using Registers = std::map<std::string, Register>;  ///< by name, see control_values.h

/// The greatest whole number with sign that so many bytes hold; the least is its negative less 1.
double greatestNumber(int bytes);

/// The whole number that stands for the value; none: it is out of range, or no multiple of the scale. N_cor alone is
/// rounded, and read back by the loop.
std::optional<std::int64_t> heldNumber(const std::string& name, const Register& place, double value);

/// A written register that shares a byte with another one: what is written there changes that value, N_cor after it was
/// read back. None: each has its own.
std::optional<std::string> sharedRegister(const Registers& registers);

/// A value that is written whatever is asked and that its register cannot hold.
struct NotHeld {
    std::string name;  ///< of the register
    double value = 0;  ///< that it cannot hold
};

/// Of states, heartbeats, N_cor up to `highest_rpm`, and the numbers of those requests that the control can state;
/// none: all are held. The registers that the link needs have to be there.
std::optional<NotHeld> narrowRegister(const Registers& registers, double highest_rpm = 1);

}  // namespace lathelier::link
