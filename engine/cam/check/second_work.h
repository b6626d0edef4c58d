// The work as the second clamping finds it: how long it is, and what of it stands before the face that is finished
// last.
#pragma once

#include <optional>
#include <string_view>

#include "engine/cam/check/turning_check.h"

namespace lathelier::cam {

/// Length of the work from the face that is finished first, by the first of these that is stated: the parameters, a
/// stop in the program (cut_off_stop.h), parting off in the first clamping, the length of the bar; else the part and
/// its face allowance. Notes workCutOff, cutOffAssumed.
double workLength_mm(std::string_view program, double part_length_mm, const Job& job, const CheckParameters& parameters,
                     Notes& notes);

/// The end that stays before the finished face (z 0) after the program, where it is longer than the face allowance: the
/// work was not cut off. `zero_mm`: z of the stock less z of the part. The line is that of the first feed move.
std::optional<CheckFinding> standingEnd(const stock::StockResult& met, double zero_mm, double face_allowance_mm,
                                        const std::vector<gcode::Move>& moves);

}  // namespace lathelier::cam
