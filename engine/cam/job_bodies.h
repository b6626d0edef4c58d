// A job as bodies of the meridian plane: bar, tools, chuck and tailstock for engine/stock, and the mirrored part.
//
// The stock's own z counts from its raw end: z of the stock = z of the part + JobStock::face_allowance_mm.
#pragma once

#include "engine/cam/job.h"
#include "engine/stock/stock_check.h"

namespace lathelier::cam {

/// z of the bar's end in the chuck, from the free end of the finished part.
double stockEnd_mm(const Job& job);

/// The bar as input of the stock simulation.
Shaft stockOf(const Job& job);

/// The bar up to the chuck face, where a beam ends.
Shaft heldStock(const Job& job);

/// The tool with the sizes that a job assumes: of a threading insert, and of a centre drill, which drills the hole of
/// the tailstock.
Tool turningTool(const JobTool& tool, const Job& job);

/// Zero, tools, chuck and tailstock, for a program whose Z0 is the free end of the finished part.
stock::StockParameters stockParameters(const Job& job);

/// The part seen from its other end, for the second clamping: z becomes length - z.
Shaft mirrored(const Shaft& part);

/// The body between free end and chuck face after turning: finished part and remaining bar. Contours falling behind the
/// last cylinder are not cut before parting off. Without bores and marks.
Shaft heldPart(const Shaft& part, const Job& job);

/// From half the slowest speed of the cutting data on the bar to the highest speed of the machine.
Interval usedSpeeds(const Job& job);

}  // namespace lathelier::cam
