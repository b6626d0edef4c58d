// Units of length as files write them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "engine/io/import.h"

namespace lathelier::io {

/// A unit of length and its size.
struct LengthScale {
    std::string key;  ///< "mm", "m", "inch", "um", "cm", "ft"…
    double mm = 1;    ///< one unit in mm
};

/// Parses units such as "mm", "Inches", "[µm]" or "(in)"; none for other words.
std::optional<LengthScale> lengthUnit(std::string_view word);

/// The unit stated in a remark: "unit mm", "Units: inch", "all coordinates in mm", "UNITS=mm".
std::optional<LengthScale> statedUnit(std::string_view remark);

/// The scale of an option; none for Auto.
std::optional<LengthScale> lengthScale(LengthUnit unit);

/// A parsed column heading: "X (in)", "x_mm", "Y [mm]", "Z/mm", "X in mm".
struct Heading {
    std::string name;                 ///< lower case, without the unit: "x"
    std::optional<LengthScale> unit;  ///< none: the heading states none
    std::string written;              ///< as written in the file: "X (in)"
};
Heading parseHeading(std::string_view cell);

/// ASCII letters in lower case.
std::string lowerCase(std::string_view text);

}  // namespace lathelier::io
