#include "engine/link/registers.h"

#include <algorithm>
#include <cmath>

#include "engine/link/control_values.h"

namespace lathelier::link {
namespace {

constexpr double heldExactly = 1e-6;  // of whole numbers, after a scale such as 0.1

}  // namespace

double greatestNumber(int bytes)
{
    return std::ldexp(1.0, 8 * bytes - 1) - 1;
}

std::optional<std::int64_t> heldNumber(const std::string& name, const Register& place, double value)
{
    const double number = std::round(value / place.scale);
    const double most = greatestNumber(place.bytes);
    const bool is_near = name == correctedName || std::fabs(number * place.scale - value) < heldExactly;
    if (!(number >= -most - 1 && number <= most && is_near)) return std::nullopt;
    return static_cast<std::int64_t>(number);
}

std::optional<std::string> sharedRegister(const Registers& registers)
{
    for (const std::string& written : writtenNames()) {
        const auto place = registers.find(written);
        if (place == registers.end()) continue;
        for (const auto& [name, other] : registers)
            if (name != written && other.address <= place->second.last() && place->second.address <= other.last())
                return written;
    }
    return std::nullopt;
}

std::optional<NotHeld> narrowRegister(const Registers& registers, double highest_rpm)
{
    const Register& request = registers.at(requestName);
    const double greatest_request =
        std::floor(std::min(static_cast<double>(mostCount), std::fabs(request.scale) * greatestNumber(request.bytes)));
    for (const NotHeld& one : {NotHeld{heartbeatName, static_cast<double>(mostCount)},
                               {heartbeatName, 1},
                               {stateName, static_cast<double>(State::Ok)},
                               {stateName, static_cast<double>(State::NotModelled)},
                               {correctedName, highest_rpm},
                               {answeredName, 1},
                               {answeredName, greatest_request}})
        if (!heldNumber(one.name, registers.at(one.name), one.value)) return one;
    // Each whole number of 1/min has one of its own.
    if (std::fabs(registers.at(correctedName).scale) > 1) return NotHeld{correctedName, highest_rpm};
    return std::nullopt;
}

}  // namespace lathelier::link
