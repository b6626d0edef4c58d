// Dates as the archive takes them.
#pragma once

#include <string>

namespace lathelier::archive {

/// "2026-11-29", a day of the calendar. Error valueNotUnderstood with the name.
void requireDate(const std::string& name, const std::string& date);

}  // namespace lathelier::archive
