// Is an end of an outline an end of the part, by all that was seen there, and what closes it?
#pragma once

#include "engine/features/outline/outline.h"

namespace lathelier::features {

enum class EndState {
    Part,      ///< the part ends here
    Data,      ///< the part goes on: the data end here
    Undecided  ///< either may be
};

struct EndClosure {
    EndState state = EndState::Undecided;
    const char* shape = "edge";  ///< what closes the part, if it ends here: face | chamfer | round | edge
    bool is_whole = false;  ///< the shape is a whole chamfer or round, or reaches the axis: no part of a longer row
    double from_mm = 0, to_mm = 0;  ///< in the frame of the fit: where the part's end lies, if it is one
};

/// Decides by the face, the rows of the scanner, a whole chamfer or round, cuts, and a stated length
/// (Outline::end_stated). `variance_ratio` as AddedUncertainty.
EndClosure closureOf(const Outline& outline, bool start, double variance_ratio);

/// Moves an end that the data leave open to where a stated length puts it, and marks it so. An end that was decided
/// stays, and so does a round; a cone goes on with its angle. Errors: lengthAgainstData: the length differs from that
/// of the data by more than its U and the spans of open ends, and no open end is one that the part may go on from.
void applyStatedLength(double length_mm, double variance_ratio, Outline& outline);

}  // namespace lathelier::features
