// Notes on using a program of the project: codes with their English patterns. {name} is replaced by the named value.
#pragma once

#include "engine/core/error.h"

namespace lathelier::notes {

inline constexpr NoteCode barOfProgram{
    "bar_of_program", Severity::Info,
    LT_TEXT("Engine", "The stock is the bar that the program was planned for, {length_mm} mm up to the chuck.")};

inline constexpr NoteCode programEdited{
    "program_edited", Severity::Warning,
    LT_TEXT("Engine", "The program was changed here and is not saved: the answer is that of the changed text.")};

}  // namespace lathelier::notes
