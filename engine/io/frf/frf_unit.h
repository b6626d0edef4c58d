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
    int length = 0;    ///< exponent of length
    int time = 0;      ///< exponent of time
    int force = 0;     ///< exponent of force
};

/// Reads products and quotients from left to right, with brackets and whole exponents (^2, **2, ², or digits behind the
/// word, also signed: "m s-2", "ms-2"), metric prefixes as letters ("daN") and names ("kilonewton"). Case-insensitive
/// but for mN: MN is none, as it may be meant. Of force also kgf, gf, kp, lbf, ozf, pdl, dyn; of mass kg, lbm, slug.
/// None for other words and for an empty text.
std::optional<PhysicalUnit> physicalUnit(std::string_view text);

/// A unit of motion per force.
struct FrfUnit {
    FrfQuantity quantity = FrfQuantity::Receptance;  ///< quantity by dimension
    double scale = 1;                                ///< one unit in mm/N, mm/s/N or mm/s²/N
};

/// None when the dimension is not that of a motion per force.
std::optional<FrfUnit> frfUnit(const PhysicalUnit& unit);
std::optional<FrfUnit> frfUnit(std::string_view text);

/// Factor to Hz of "Hz", "kHz", "rad/s", "rpm"; 1 without a unit ("", "NONE"); none for other words.
std::optional<double> hzPerUnit(std::string_view text);

/// A level in decibel: "dB", "dB re 1e-6 m/N", "dB_re_1_m_N".
struct DecibelUnit {
    double reference = 1;  ///< amount of `unit` at 0 dB
    std::string unit;      ///< as written; empty: not stated
};

/// None for a text that is no level.
std::optional<DecibelUnit> decibelUnit(std::string_view text);

/// "receptance", "mobility", "accelerance".
std::string quantityName(FrfQuantity quantity);

/// True for an empty text and for "NONE", which UFF writes for an unstated text.
bool isUnstated(std::string_view text);

}  // namespace lathelier::io
