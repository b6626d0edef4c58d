// Consistency rules of a job and its part.
#pragma once

#include "engine/cam/job.h"
#include "engine/core/error.h"

namespace lathelier::cam {

/// Rows and arcs of the part: segmentImpossible with its number (from 1) for a length or diameter that is not above 0
/// (a diameter of 0 is allowed at the free end), and an arc that is smaller than half its chord or turns back along z;
/// shaftEmpty, markNotTurned.
void checkPart(const Shaft& part);

/// Errors stockSmallerThanPart: radius missing at the worst place, or length.
void checkStock(const Job& job, const Shaft& part);

/// Rules of single tools: toolNumberTwice; toolIncomplete (an insert without nose radius or angles); stock's
/// toolImpossible (κ + ε at least 180°, or a nose that does not fit between the edges).
void checkTools(const Job& job);

/// Tools needed by a plan: toolMissing for roughing or finishing, and for parting off where it is asked for;
/// toolTooShort.
void checkUses(const Job& job);

}  // namespace lathelier::cam
