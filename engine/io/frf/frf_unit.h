// Units of frequency responses as files write them: "m/s^2", "(m/s)/N", "mm/N", "g", "1/kg", "m_s2_N".
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "engine/core/frf.h"

namespace lathelier::io {

/// A product of powers of length, time and force; mass counts as N·s²/m. The letter g alone is the acceleration of free
/// fall, 9.80665 m/s², as in the charts of accelerometers, never the gram.
struct PhysicalUnit {
    double scale = 1;  ///< one unit in the same powers of mm, s and N
    int length = 0;    ///< power of length
    int time = 0;      ///< power of time
    int force = 0;     ///< power of force
};

/// Reads products and quotients from left to right, with brackets and whole exponents (^2, **2, ², or digits behind the
/// word). Letters count in any case. Nothing for other words, and for the empty one.
std::optional<PhysicalUnit> physicalUnit(std::string_view text);

/// A unit of motion per force.
struct FrfUnit {
    FrfQuantity quantity = FrfQuantity::Receptance;  ///< by the dimension
    double scale = 1;                                ///< one unit in mm/N, mm/s/N or mm/s²/N
};

/// Nothing when the dimension is not that of a motion per force.
std::optional<FrfUnit> frfUnit(const PhysicalUnit& unit);
std::optional<FrfUnit> frfUnit(std::string_view text);

/// What a frequency is multiplied by to be in Hz: "Hz", "kHz", "rad/s", "rpm"; 1 without a unit ("", "NONE"); nothing
/// for other words.
std::optional<double> hzPerUnit(std::string_view text);

/// "receptance", "mobility", "accelerance".
std::string quantityName(FrfQuantity quantity);

/// True for an empty text and for "NONE", which UFF writes for what is not stated.
bool isUnstated(std::string_view text);

}  // namespace lathelier::io
