// Lobes as charts, for screen and paper.
#pragma once

#include <optional>

#include "engine/report/chart.h"
#include "engine/stability/lobes.h"
#include "engine/stability/speed_choice.h"

namespace lathelier::stability {

/// The operating point; a handle of the chart.
struct OperatingPoint {
    double speed_rpm = 0;
    double depth_mm = 0;  ///< or a multiple of the least limit, in the unit of the chart
};
inline constexpr const char* operatingPointKey = "operating_point";

/// Stable and unstable regions, single lobes, the band of the limit, the three highest pockets named, candidates and
/// the tool's range of speeds as lines, the operating point as a handle.
report::Plot lobesPlot(const LobeResult& result, const SpeedResult* speed = nullptr,
                       const std::optional<OperatingPoint>& point = {}, const Language& language = {});

/// Shades the stable region below a limit and the unstable one above; NaN: no limit.
void shadeStability(report::Plot& plot, const std::vector<double>& speed_rpm, std::vector<double> limit);

/// Chatter frequency at the limit over the speed.
report::Plot chatterFrequencyPlot(const LobeResult& result);

}  // namespace lathelier::stability
