// Lobes as charts, for screen and paper.
#pragma once

#include <optional>

#include "engine/report/chart.h"
#include "engine/stability/lobes.h"
#include "engine/stability/safe_speed.h"
#include "engine/stability/speed_choice.h"

namespace lathelier::stability {

/// The operating point; a handle of the chart.
struct OperatingPoint {
    double speed_rpm = 0;
    double depth_mm = 0;  ///< or a multiple of the least limit, in the unit of the chart
};
inline constexpr const char* operatingPointKey = "operating_point";

/// What a chart of lobes marks; all of it may be left out.
struct LobesMarks {
    const SafeSpeed* safe = nullptr;      ///< the speed to recommend
    const SpeedResult* rule = nullptr;    ///< of the papers: its speed where none is recommended by depth; tool's range
    std::optional<OperatingPoint> point;  ///< a handle
};

/// Stable and unstable regions, single lobes, the band of the limit, the three highest pockets named, and the marks.
report::Plot lobesPlot(const LobeResult& result, const LobesMarks& marks = {}, const Language& language = {});

/// Shades the stable region below a limit and the unstable one above; NaN: no limit.
void shadeStability(report::Plot& plot, const std::vector<double>& speed_rpm, std::vector<double> limit);

/// Chatter frequency at the limit over the speed.
report::Plot chatterFrequencyPlot(const LobeResult& result);

}  // namespace lathelier::stability
