// Operations of a plan as the text of a program, by the rules of a post.
//
// Every number is written from the rounded position before: I and K count from what was written, so roundings do not
// add up. A move that rounding shortens to nothing is left out; an arc whose sagitta is below half a unit of the last
// decimal becomes a line.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/cam/operation.h"
#include "engine/cam/post/post.h"
#include "engine/cam/post/roughing_cycle.h"

namespace lathelier::cam {

/// What the head of a program says.
struct ProgramHead {
    std::string title;                  ///< of the job
    int number = 100;                   ///< of the program
    double max_rpm = 0;                 ///< limit of the spindle
    bool has_tailstock = false;         ///< X alone leaves first
    std::vector<std::string> comments;  ///< further lines at the top
    std::optional<CycleData> cycles{};  ///< roughing and finish as cycles; none: as moves
};

/// Where an operation stands in the text.
struct WrittenOperation {
    std::int64_t first_line = 0;  ///< from 1
    std::int64_t blocks = 0;      ///< of moves
    /// Of a finish as a cycle: lines of the contour that it follows, which stands with roughing; 0: none.
    std::int64_t contour_first_line = 0, contour_last_line = 0;
};

struct WrittenProgram {
    std::string text;                          ///< ASCII
    std::vector<WrittenOperation> operations;  ///< as they were given
    std::optional<Text> no_cycle;              ///< why moves stand where cycles were asked for
};

/// A fixed speed takes the place of constant cutting speed where the control has none: that of the largest diameter
/// cut. Error postCannot (feed per minute without a speed).
WrittenProgram writeProgram(const Post& post, const ProgramHead& head, const std::vector<Operation>& operations);

/// A text for a comment of this post: ASCII, upper case, nothing that ends it, no longer than it may be.
std::string commentText(const Post& post, const std::string& text);

}  // namespace lathelier::cam
