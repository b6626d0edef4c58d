// Assignment of the lengths of a chain to lanes below a view.
#pragma once

#include <vector>

namespace lathelier::drawing {

/// A dimension along a lane, mm on paper.
struct LaneSpan {
    double from_mm = 0, to_mm = 0;     ///< of its arrows, from < to: extension lines come down here
    double left_mm = 0, right_mm = 0;  ///< with its text, which may stand left of `from_mm`
};

/// From the left each in the nearest lane (0) that is free there and where no extension line of one before it crosses
/// its text; dimensions over several others come last, the shorter ones first. In the order of `spans`. Cost n² per
/// lane.
std::vector<int> lanesOf(const std::vector<LaneSpan>& spans);

}  // namespace lathelier::drawing
