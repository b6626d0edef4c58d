// Text of unknown origin, made safe to show: control and direction characters are replaced by visible codes.
#pragma once

#include <string>
#include <string_view>

namespace lathelier {

/// `text` (UTF-8) with control characters, marks of the direction of writing (Unicode UAX #9), invisible characters and
/// bytes that are no UTF-8 written as "<U+202E>" and "<9B>". `keepLines` leaves line feed and tab as they are.
std::string visible(std::string_view text, bool keepLines = false);

}  // namespace lathelier
