// The languages of lathe controls: which are read, and how a program tells its own.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/core/fields.h"

namespace lathelier::gcode {

/// Auto is a wish only; a program that was read has one of the others.
/// Fanuc: G code system A of turning. Haas: the same with one-block cycles. LinuxCNC: also what GRBL takes of it.
enum class Dialect { Auto, Fanuc, Haas, Sinumerik, LinuxCnc };

/// "auto", "fanuc", "haas", "sinumerik", "linuxcnc".
const char* key(Dialect dialect);

/// Choices of a Choice field, in the order of the enumerators.
const std::vector<FieldChoice>& dialectChoices();

/// What the text of a program says of its control.
struct DialectFound {
    Dialect dialect = Dialect::Fanuc;  ///< the likeliest of those that are read
    std::string not_read;    ///< "Okuma OSP", "Fanuc (G code system B)"…: a control that is not read; else ""
    long line = 0;           ///< of the clearest sign for `not_read`, from 1
    long nc_lines = 0;       ///< lines of the part looked at that are blocks of an NC program
    long other_lines = 0;    ///< lines that are neither blocks, nor empty, nor comments
    bool has_codes = false;  ///< some line has a G or M word, or is the head of a program
    bool has_head = false;   ///< % or an O number or %_N_ stands first
};

/// Looks at the first 2000 lines, names of cycles and words that only one control has; never at comments. Fanuc where
/// nothing tells. Cost: one pass.
DialectFound detectDialect(std::string_view text);

constexpr bool isFanucLike(Dialect dialect)
{
    return dialect == Dialect::Fanuc || dialect == Dialect::Haas;
}

}  // namespace lathelier::gcode
