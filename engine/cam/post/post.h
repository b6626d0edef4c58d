// A control as data: templates and rules that convert moves to program text. The writer contains no code for single
// controls; a further control is a further JSON file.
//
// {"name", "label"?, "dialect"?, "program_start": [...], "header_comments", "safe_start", "tool_start", "tool_end",
// "spindle_css",
//  "spindle_rpm", "speed_change", "coolant_on", "stop", "program_end": lists of templates,
//  "tool_start_tailstock"?, "program_end_tailstock"?: instead of those with a tailstock,
//  "optional_stop"?, "work_offset"?: lists of templates, written where a plan asks for them,
//  "cycles"?: "none" | "g71_g70", "rough_cycle"?, "finish_cycle"?: lists of templates; without them those of Fanuc,
//  "rapid", "line", "arc_cw", "arc_ccw": words, "arc": "ik" | "r" | "cr", "thread"?: word, "thread_lead"?: "F" | "K",
//  "words": {"X": {"diameter", "decimals"}, "Z": {"decimals"}, "F": {"decimals"}, "style": "point" | "plain"},
//  "modal"?, "feed"?: "per_rev" | "per_min", "css"?, "block_numbers": {"start", "step"} | null,
//  "comment": {"open", "close", "max_length"?}, "end_of_line"?: "lf" | "crlf"}
// Templates name {title} {number} {tool} {tool2} {max_rpm} {vc} {rpm}; those of cycles also {first} {last} (numbers of
// the contour's blocks) {depth} {retract} {x_allowance} {z_allowance} {feed}.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/gcode/control.h"

namespace lathelier::cam {

/// How an arc states its circle: centre from the start, radius, or CR=.
enum class ArcWords : std::uint8_t { CentreOffsets, Radius, CrRadius };

/// Numbers of blocks.
struct BlockNumbers {
    int start = 10;  ///< of the first block
    int step = 10;   ///< from one to the next
    friend bool operator==(const BlockNumbers&, const BlockNumbers&) = default;
};

using Templates = std::vector<std::string>;

struct Post {
    std::string name;                ///< label and file name
    std::string label;               ///< of the control, as it is shown; empty: the name
    gcode::ControlPtr control;       ///< that its programs are for; nullptr: detected from the text
    Templates program_start;         ///< before everything, without block numbers
    Templates header_comments;       ///< comments at the top
    Templates safe_start;            ///< modes
    Templates tool_start;            ///< moves to the change point and calls the tool
    Templates tool_start_tailstock;  ///< the same with a tailstock; empty: tool_start
    Templates tool_end;              ///< after the last operation of a tool
    Templates spindle_css;           ///< constant cutting speed, with the speed limit before it
    Templates spindle_rpm;
    Templates speed_change;                               ///< another fixed speed while cutting
    Templates coolant_on;                                 ///< before the first move
    Templates stop{"M0"};                                 ///< program stop for the operator
    Templates optional_stop;                              ///< between tools, where it is asked for; empty: none
    Templates work_offset;                                ///< states the zero point, where it is asked for; empty: none
    Templates program_end;                                ///< without block numbers
    Templates program_end_tailstock;                      ///< the same with a tailstock; empty: program_end
    bool cycles = false;                                  ///< roughing and finish as cycles rather than as moves
    Templates rough_cycle;                                ///< of roughing along a contour; empty: the control has none
    Templates finish_cycle;                               ///< of a finish along the same contour
    std::string rapid = "G0", line = "G1";                ///< words
    std::string arc_cw = "G2", arc_ccw = "G3";            ///< words, seen with Z to the right and X upward
    std::string thread;                                   ///< word of one pass of a thread; empty: the control has none
    std::string thread_lead = "F";                        ///< address of its lead
    ArcWords arc = ArcWords::CentreOffsets;               ///< format of circle centres
    bool x_is_diameter = true;                            ///< X counts diameters
    int x_decimals = 3, z_decimals = 3;                   ///< of X and I, Z and K; at least leastDecimals
    int f_decimals = 3;                                   ///< of F
    bool decimal_point = true;                            ///< "X30." rather than "X30"
    bool modal = true;                                    ///< unchanged words are omitted
    bool feed_per_min = false;                            ///< F in mm/min instead of mm/rev
    bool css = true;                                      ///< the control supports constant cutting speed
    std::optional<BlockNumbers> block_numbers;            ///< none: no N words
    std::string comment_open = "(", comment_close = ")";  ///< around comments
    int comment_length = 60;                              ///< longest text of a comment
    std::string end_of_line = "\n";
    friend bool operator==(const Post&, const Post&) = default;
};

/// How many of the lines stand before the first one that names a tool: by then the tool before has been retracted.
std::ptrdiff_t linesBeforeTool(const Templates& templates);

/// Lines of an optional stop, and those that state the work offset, which are none where the modes at the start do.
/// Error postCannot where the post has none.
const Templates& optionalStop(const Post& post);
Templates statedOffset(const Post& post);

inline constexpr int leastDecimals = 3;  ///< with two decimals, rounding gouges up to 10 µm

/// Errors with line and column: malformed, keyMissing, keyOutOfRange. Notes: unknownKey.
Post readPost(const std::string& json, Notes& notes);

/// The text of a file that readPost() reads to the same value.
std::string postText(const Post& post);

/// Names of the posts that are built in, and one of them. Error postUnknown naming them.
std::vector<std::string> postNames();
Post postNamed(const std::string& name);

}  // namespace lathelier::cam
