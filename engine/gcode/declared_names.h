// Names that a program of structured statements declares: variables and programs within the file.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "engine/gcode/control.h"

namespace lathelier::gcode {

using DeclaredNames = std::set<std::string, std::less<>>;

/// The name that a word begins with, in capitals: "STUFE2" of STUFE2(40,-8), "DIA" of DIA=50.
std::string nameOf(std::string_view word);

/// In capitals: of DEF and PROC, and of the heads of programs within the file. Empty for other styles of flow.
DeclaredNames declaredNames(std::string_view text, const Control& control);

/// The names and values of one list, "DIA=50, LEN": of DEF behind its type, or the parameters of PROC with their types.
/// A name with an index is left out.
struct Declared {
    std::string name;        ///< in capitals
    std::string_view value;  ///< expression behind "="; empty: none
};
std::vector<Declared> declaredIn(std::string_view list);

/// What follows a statement, split at commas outside of brackets and texts.
std::vector<std::string_view> splitArguments(std::string_view list);

}  // namespace lathelier::gcode
