// Question of the panel Speed: bar, selected cutting speed, range of the tool.
#pragma once

#include <optional>
#include <vector>

#include "engine/core/material.h"
#include "engine/stability/speed_choice.h"

namespace lathelier::speed_panel {

struct SpeedQuestion {
    std::optional<double> length_mm;      ///< L: overhang of the bar from the chuck; needed without a shaft
    std::optional<double> lowest_m_min;   ///< least cutting speed of the tool; none: any
    std::optional<double> highest_m_min;  ///< greatest cutting speed of the tool; none: any
    std::optional<Material> material;     ///< of the bar; none: steel is assumed
    stability::SpeedParameters speed;     ///< D, v_c, peak shift, rule, relation; its range follows from the above
};

const std::vector<Field<SpeedQuestion>>& fieldsOf(const SpeedQuestion*);

/// Cutting speeds that the tool allows, as SpeedParameters has them; empty: all.
std::vector<Interval> rangeOf(const SpeedQuestion& question);

/// Keys of the values on the operator's screen, in their order: D, L, v_c, its least and its greatest.
inline constexpr const char* diameterKey = "diameter_mm";
inline constexpr const char* lengthKey = "length_mm";
inline constexpr const char* cuttingSpeedKey = "cutting_speed_m_min";
inline constexpr const char* lowestKey = "lowest_m_min";
inline constexpr const char* highestKey = "highest_m_min";

}  // namespace lathelier::speed_panel
