// The range of cutting speeds as the operator types it: its ends one by one.
#pragma once

#include <string>
#include <vector>

#include "engine/core/fields.h"

namespace lathelier::stability {

/// Keys of the values on the operator's screen, in their order: D, L, v_c, its least and its greatest.
inline constexpr const char* diameterKey = "diameter_mm";
inline constexpr const char* cuttingSpeedKey = "cutting_speed_m_min";
inline constexpr const char* lowestKey = "lowest_m_min";
inline constexpr const char* highestKey = "highest_m_min";

/// The values of the screen, described.
std::vector<FieldInfo> screenFields();

/// The parameters with the ends of the range as values of their own.
Values screenValues(const Values& parameters);

/// Enters a value of the screen into the parameters; none: cleared.
void enterValue(Values& parameters, const std::string& key, const Value& value);

}  // namespace lathelier::stability
