// Operations of a plan as the text of a program, by the rules of a post.
//
// Incremental words (I, K) refer to the rounded start point, so rounding errors do not accumulate. Moves whose rounded
// length is zero are omitted; an arc whose sagitta is below half a unit of the last decimal becomes a line.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/cam/operation.h"
#include "engine/cam/post/post.h"
#include "engine/cam/post/roughing_cycle.h"

namespace lathelier::cam {

/// Data for the head of a program.
struct ProgramHead {
    std::string title;
    int number = 100;
    double max_rpm = 0;                 ///< limit of the spindle
    bool has_tailstock = false;         ///< retract X before Z
    std::vector<std::string> comments;  ///< further lines at the top
    std::optional<CycleData> cycles{};  ///< roughing and finish as cycles; none: as moves
    std::optional<double>
        cut_off_mm{};                 ///< length that the work is cut off to at a stop before everything; none: no stop
    bool has_optional_stops = false;  ///< one before each further tool is called
    bool states_offset = false;       ///< the work offset is stated with the modes at the start
};

/// Position of an operation in the text.
struct WrittenOperation {
    std::int64_t first_line = 0;  ///< from 1
    std::int64_t blocks = 0;      ///< of moves
    /// Of a finish as a cycle: lines of its contour, written with the roughing cycle; 0: none.
    std::int64_t contour_first_line = 0, contour_last_line = 0;
};

struct WrittenProgram {
    std::string text;                          ///< ASCII
    std::vector<WrittenOperation> operations;  ///< as they were given
    std::optional<Text> no_cycle;              ///< why moves were written although cycles were requested
};

/// A fixed speed replaces constant cutting speed where the control lacks it: that of the largest diameter cut. Error
/// postCannot (feed per minute without a speed; optional stops or a work offset that the post does not know).
WrittenProgram writeProgram(const Post& post, const ProgramHead& head, const std::vector<Operation>& operations);

/// A text for a comment of this post: ASCII, upper case, without characters that end it, truncated to the allowed
/// length.
std::string commentText(const Post& post, const std::string& text);

/// A tool's number for templates such as T{tool2}{tool2}, in which a longer one would be another tool: "07". Error
/// postCannot above 99, with the tool.
std::string twoDigits(const Post& post, int tool);

}  // namespace lathelier::cam
