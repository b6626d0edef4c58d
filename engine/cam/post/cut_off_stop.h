// The stop of a second program that waits for the work to be cut off by hand: written into the program as a comment and
// read from any program by the check.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace lathelier::cam {

/// "cut off to 93.0 first": length from the finished face.
std::string cutOffComment(double length_mm);

/// The length that such a comment states, where a program stop (M0, M00) is the next block after it, before the
/// first move. None: no such stop.
std::optional<double> cutOffOf(std::string_view program);

}  // namespace lathelier::cam
