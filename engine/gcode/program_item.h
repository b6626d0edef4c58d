// An NC program as an item of the project, exchanged between the panels that plan, predict, correct and check it.
#pragma once

#include <optional>
#include <string>

#include "engine/core/value.h"
#include "engine/gcode/stated_correction.h"
#include "engine/shaft/shaft.h"

namespace lathelier::gcode {

inline constexpr const char* programItem = "program";              ///< kind: as it was planned
inline constexpr const char* correctedItem = "corrected_program";  ///< kind: corrected, to be checked

/// A program with the data needed to evaluate it.
struct ProgramItem {
    std::string text;             ///< the whole program, UTF-8
    int clamping = 1;             ///< 1 or 2: which one of the part's clampings
    double z_zero_mm = 0;         ///< z of the program's Z0 from the raw end of `stock`
    std::optional<Shaft> stock;   ///< body before the first cut, up to the chuck; none: unknown
    std::string corrected_from;   ///< SHA-256 of the original program; empty: not corrected
    StatedCorrection correction;  ///< z from the free end of the clamping; empty: none
    friend bool operator==(const ProgramItem&, const ProgramItem&) = default;
};

/// Values of the item. Error linesTooMany: a correction with more places than a project keeps.
Values toValues(const ProgramItem& program);

/// Inverse of toValues(); none if the values do not describe a program.
std::optional<ProgramItem> programOf(const Values& values);

}  // namespace lathelier::gcode
