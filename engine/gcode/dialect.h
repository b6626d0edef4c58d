// Dialects of lathe controls: supported ones, and detection from the text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/core/fields.h"

namespace lathelier::gcode {

/// Auto is a request only; a parsed program has one of the others. Fanuc: G code system A of turning. Haas: the same
/// with one-block cycles. LinuxCNC: also the subset of GRBL.
enum class Dialect { Auto, Fanuc, Haas, Sinumerik, LinuxCnc };

/// "auto", "fanuc", "haas", "sinumerik", "linuxcnc".
const char* key(Dialect dialect);

/// Choices of a Choice field, in the order of the enumerators.
const std::vector<FieldChoice>& dialectChoices();

/// Result of dialect detection.
struct DialectFound {
    Dialect dialect = Dialect::Fanuc;  ///< most probable supported dialect
    std::string not_read;              ///< "Okuma OSP", "Fanuc (G code system B)"…: unsupported control; empty: none
    long line = 0;                     ///< line of the strongest indication of `not_read`, from 1
    long nc_lines = 0;                 ///< examined lines that are blocks of an NC program
    long other_lines = 0;              ///< examined lines that are neither blocks, nor empty, nor comments
    bool has_codes = false;            ///< some line has a G or M word, or is the head of a program
    bool has_head = false;             ///< starts with %, an O number or %_N_
};

/// Examines the first 2000 lines for cycle names and words specific to one control, ignoring comments. Fanuc if nothing
/// is specific. Cost: one pass.
DialectFound detectDialect(std::string_view text);

constexpr bool isFanucLike(Dialect dialect)
{
    return dialect == Dialect::Fanuc || dialect == Dialect::Haas;
}

}  // namespace lathelier::gcode
