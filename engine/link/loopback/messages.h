// Messages between an assistant and a simulated control over TCP: one JSON object a line, UTF-8, at most 64 KiB. The
// assistant asks, the control answers with the same id.
//   {"id": 1, "do": "hello", "version": 1}            {"id": 1, "control": "lathelier-simulator", "version": 1}
//   {"id": 2, "do": "read", "names": ["request"]}     {"id": 2, "values": {"request": 7}}
//   {"id": 3, "do": "write", "name": "n_cor_rpm", "value": 3237}       {"id": 3, "written": true}
//   {"id": 4, "do": "program"}                        {"id": 4, "program": "shaft.ngc"}, null: none
// What cannot be done: {"id": 3, "error": "taken" | "not_understood" | "not_allowed"}; the link stays open.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/core/json.h"
#include "engine/link/control_values.h"

namespace lathelier::link {

inline constexpr std::size_t longestMessage = std::size_t{64} << 10;
inline constexpr int messageVersion = 1;

enum class Ask { Hello, Read, Write, Program };

/// What an assistant asks.
struct Message {
    std::int64_t id = 0;             ///< that the answer repeats
    Ask ask = Ask::Hello;            ///< what is asked
    std::vector<std::string> names;  ///< of Read
    std::string name;                ///< of Write
    double value = 0;                ///< likewise
};

/// The line, with its end.
std::string lineOf(const Message& message);

/// Errors malformed, keyMissing with line and column.
Message messageFrom(const std::string& line);

/// The values of an answer to Read, each of `names` once. Errors malformed, keyMissing.
ControlValues valuesFrom(const std::string& line, std::int64_t id, const std::vector<std::string>& names);

/// The error that an answer states; empty: none. Errors malformed, keyMissing; another id is malformed.
std::string errorFrom(const std::string& line, std::int64_t id);

/// Whether it is the answer of a control that speaks this version, or says that the value was written. Errors
/// malformed, keyMissing.
void requireHello(const std::string& line, std::int64_t id);
void requireWritten(const std::string& line, std::int64_t id);

/// The program that an answer states; empty: none.
std::string programFrom(const std::string& line, std::int64_t id);

}  // namespace lathelier::link
