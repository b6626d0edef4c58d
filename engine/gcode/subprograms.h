// Programs that a program calls and that stand in files of their own, in one folder. They are run as if they stood
// behind the program: see ProgramPart in program.h.
//
// A file holds the program NAME when it declares it (O1234; %_N_NAME_SPF; PROC NAME; o<name> sub), or, where it
// declares none, when it is called so: O1234, O1234.nc, 1234.nc, L54.SPF, NAME.MPF, name.ngc, in small or capital
// letters. A file may hold several. Two files with different texts for one name: neither is taken.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/core/input_file.h"
#include "engine/gcode/toolpath.h"

namespace lathelier::gcode {

inline constexpr std::size_t mostSubprogramFiles = 2000;                         ///< of a folder
inline constexpr std::size_t largestSubprogram_bytes = std::size_t{16} << 20;    ///< larger files are not looked at
inline constexpr std::size_t largestSubprograms_bytes = std::size_t{128} << 20;  ///< of a folder in all

struct FoundSubprograms {
    std::vector<ProgramPart> parts;  ///< in the order in which they were found missing
    std::vector<InputFile> files;    ///< the same with their digests
    Notes notes;                     ///< for each the lines that it has behind the program
};

/// The programs that `text` calls, and those that they call, as far as the folder of the parameters holds them; what
/// is not found remains a gap. The name of the program is that of the parameters. An error within the program is left
/// to whoever runs it. Errors: valueNotUnderstood (no such folder), subprogramsTooLarge; those of readProgram(), with
/// the path. Throws Cancelled.
FoundSubprograms findSubprograms(const std::string& text, const ToolpathParameters& parameters, const ToolTable& tools,
                                 const Progress& progress);

/// The names that a text declares, in the form in which Toolpath::missing has them.
std::vector<std::string> programsIn(std::string_view text, const Control& control);

}  // namespace lathelier::gcode
