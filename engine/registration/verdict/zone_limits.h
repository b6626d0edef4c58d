// Zones with limits of their own: read from a file, checked.
#pragma once

#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/registration/verdict/verdict_values.h"

namespace lathelier::registration {

/// Reads [{name, z_start_mm, z_end_mm, lower_mm, upper_mm}…]; the zones come back in order of z. Unknown keys are the
/// note unknownKey. Errors, with line and column: malformed (no JSON, a wrong type, an end that is not beyond its
/// start, an overlap, limits in the wrong order, only one limit), keyMissing, keyOutOfRange.
std::vector<ZoneLimits> readZones(std::string json_text, Notes& notes);

/// The same checks for zones that no file holds. Error valueNotUnderstood.
void checkZones(const std::vector<ZoneLimits>& zones);

}  // namespace lathelier::registration
