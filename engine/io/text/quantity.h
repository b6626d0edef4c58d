// Units of other quantities in measured tables: angles, times, voltages, beside lengths.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace lathelier::io {

struct QuantityUnit {
    enum class Kind { Length, Angle, Time, Voltage };
    Kind kind = Kind::Length;  ///< quantity of the unit
    std::string key;           ///< "um", "deg", "ms", "V"…
    double scale = 1;          ///< one unit in mm, degrees, seconds or volts
};

/// Parses units such as "µm", "[deg]", "gon", "ms" or "(mV)"; none for other words, and for "grad", which is the degree
/// in some languages and the gon in others.
std::optional<QuantityUnit> quantityUnit(std::string_view word);

/// A parsed heading: "marker_V", "X3 (um)", "phi [rad]", "t_ms".
struct QuantityHeading {
    std::string name;                  ///< as written, without the unit: "X3"
    std::optional<QuantityUnit> unit;  ///< none: the heading states none that is known
    std::string unit_text;             ///< in the place of the unit, as written: "um", "ticks"; empty: nothing
};
QuantityHeading parseQuantityHeading(std::string_view cell);

}  // namespace lathelier::io
