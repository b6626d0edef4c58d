// Units, factors between them, and tolerances of coordinates for all rooms.
#pragma once

#include <limits>
#include <numbers>

#include "engine/core/text.h"

namespace lathelier {

inline constexpr double um_per_mm = 1000;
inline constexpr double mm_per_inch = 25.4;
inline constexpr double turn_rad = 2 * std::numbers::pi;
inline constexpr double rad_per_deg = std::numbers::pi / 180;
inline constexpr double deg_per_rad = 180 / std::numbers::pi;

/// Marks a number as not measured or not defined.
inline constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

/// Sizes and places no further apart are the same: a thousandth of the finest step that drawings and programs state.
inline constexpr double same_mm = 1e-6;
/// Ends of lines and arcs no further apart meet: the rounding of coordinates up to some metres.
inline constexpr double meet_mm = 1e-9;

/// Units as they are shown beside a number.
namespace unit {
inline constexpr Text mm = LT_TEXT("Engine", "mm");
inline constexpr Text mm3 = LT_TEXT("Engine", "mm³");
inline constexpr Text um = LT_TEXT("Engine", "µm");
inline constexpr Text deg = LT_TEXT("Engine", "°");
inline constexpr Text percent = LT_TEXT("Engine", "%");
inline constexpr Text s = LT_TEXT("Engine", "s");
inline constexpr Text hz = LT_TEXT("Engine", "Hz");
inline constexpr Text newton = LT_TEXT("Engine", "N");
inline constexpr Text N_mm = LT_TEXT("Engine", "N/mm");
inline constexpr Text m_min = LT_TEXT("Engine", "m/min");
inline constexpr Text mm_rev = LT_TEXT("Engine", "mm/rev");
inline constexpr Text rpm = LT_TEXT("Engine", "1/min");
inline constexpr Text N_mm2 = LT_TEXT("Engine", "N/mm²");
}  // namespace unit

}  // namespace lathelier
