// External threads of a part, and the passes that cut them: G32 or G33 as the post has it, explicit moves throughout,
// so that every control makes the same ones.
//
// ISO 68-1, ISO 724: the depth of an external thread is 0.6134 P from the drawn diameter, that of its crest, unless the
// drawing states the diameter of its root. Pass i of n is at depth √(i/n) of it, so that all remove equal areas; the
// last one is run twice. The tool is straight to the axis; its cut is not checked.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/cam/operation.h"
#include "engine/cam/work_frame.h"

namespace lathelier::cam {

/// A thread stated in the drawing.
struct DrawnThread {
    std::string designation;         ///< "M16x1.5"
    std::optional<double> pitch_mm;  ///< P; none: designation not parsed
    std::optional<double> major_mm;  ///< D, over the crests; none: not stated
    std::optional<double> minor_mm;  ///< at the root; none: by the standard
    double z_start_mm = 0;           ///< from the free end
    double z_end_mm = 0;             ///< toward the chuck
    bool is_plain = true;            ///< right-handed, with one start
    friend bool operator==(const DrawnThread&, const DrawnThread&) = default;
};

/// Of the rows (ShaftSegment::thread) and the marks of threads with a place. M with or without a pitch (ISO 261,
/// coarse), "x", "×" or "*" between, "LH" for left-handed.
std::vector<DrawnThread> threadsOf(const Shaft& part);

/// The same with z from the other end.
std::vector<DrawnThread> mirrored(std::vector<DrawnThread> threads, double length_mm);

/// Threading passes, or the reason why the thread is not cut.
struct Threading {
    std::optional<Operation> operation;  ///< none: see `reason`
    Text reason;
    int passes = 0;  ///< over the thread
    double depth_mm = 0;
};

/// Run-in of three pitches over contour not higher than the crest; run-out into contour lower than the root, or end
/// before higher contour, clear of the flank of the insert. Not cut if the row diameter differs from the nominal one by
/// more than 0.3 P, or its stated root is not 0.45 to 0.8 P deep.
Threading threading(const WorkFrame& frame, const JobTool& tool, const DrawnThread& thread, double max_rpm);

}  // namespace lathelier::cam
