// A set-up as an item of the project: its fields, and its stock where it holds one.
#pragma once

#include <optional>

#include "engine/deflection/setup.h"
#include "engine/shaft/shaft.h"

namespace lathelier::deflection {

inline constexpr const char* setupItem = "setup";  ///< kind of the item

/// A set-up with the stock that it brings.
struct HeldSetup {
    TurningSetup setup;
    std::optional<Shaft> stock;  ///< none: stated elsewhere
};

/// Values of the item: those of toValues(setup), the stock as a table of one row under "stock_shaft". The path of a
/// stock file is left out: an item has no place from which it counts.
Values valuesOf(const HeldSetup& held);

/// The inverse; none when the values are not those of a set-up with material, tool and chuck.
std::optional<HeldSetup> setupOf(const Values& values);

}  // namespace lathelier::deflection
