// Operations at the ends of the work: facing, the centre hole of a tailstock, parting off.
#pragma once

#include "engine/cam/operation.h"
#include "engine/cam/work_frame.h"

namespace lathelier::cam {

/// True for an insert with κ < 90°: while its nose runs along the face toward the axis, its main edge runs below it.
bool leansOverFace(const JobTool& tool);

/// That of roughing, else of finishing, else any other insert that feeds toward the chuck; null: none can face.
const JobTool* facingTool(const Job& job);

/// Passes toward the axis with the facing tool down to faceLeft_mm, at most largestFacing_mm deep, until the nose has
/// passed the axis; with a tailstock down to innerEnd_mm(). If no later operation faces the end, a last pass at the
/// finishing feed removes the remainder. None: no face allowance, or the tailstock covers the whole face.
std::optional<Operation> facing(const WorkFrame& frame, const JobTool& tool);

/// Smallest tip radius on the end face: until the nose has passed the axis; with a tailstock, 1 mm outside its centre
/// hole and clear of it with insert and holder.
double innerEnd_mm(const WorkFrame& frame, const JobTool& tool);

/// Down to a cone of the tailstock's centre hole: pilot length and half the difference of diameters over tan 30°. None:
/// no tailstock or no drill. No later operation faces the end.
std::optional<Operation> centreDrilling(const WorkFrame& frame);

/// The corner of the blade toward the chuck is at length + width: feed down to a diameter of 6 mm, then half of it
/// beyond the axis.
Operation partingOff(const WorkFrame& frame, const JobTool& blade);

}  // namespace lathelier::cam
