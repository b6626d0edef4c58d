// Operations at the ends of the work: facing, the centre hole of a tailstock, parting off.
#pragma once

#include "engine/cam/operation.h"
#include "engine/cam/work_frame.h"

namespace lathelier::cam {

/// Passes toward the axis with the roughing tool down to faceLeft_mm, at most largestFacing_mm deep, until the nose has
/// passed the axis; with a tailstock as far as innerEnd_mm() says. Where nothing faces the end afterwards, a last pass
/// at the feed of finishing takes the rest. None: nothing stands before the part, or the tailstock stands before all of
/// it.
std::optional<Operation> facing(const WorkFrame& frame, const JobTool& tool);

/// How far down the tip comes on the end face: until the nose has passed the axis; where the tailstock stands, 1 mm
/// outside its centre hole, and no farther than insert and holder keep clear of it.
double innerEnd_mm(const WorkFrame& frame, const JobTool& tool);

/// Down to a cone of the tailstock's centre hole: pilot length and half the difference of diameters over tan 30°.
/// None: no tailstock or no drill. Nothing faces the end afterwards.
std::optional<Operation> centreDrilling(const WorkFrame& frame);

/// The corner of the blade toward the chuck stands at length + width: feed down to a diameter of 6 mm, then half of it
/// beyond the axis.
Operation partingOff(const WorkFrame& frame, const JobTool& blade);

}  // namespace lathelier::cam
