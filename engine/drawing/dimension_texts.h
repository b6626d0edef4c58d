// Numbers as a drawing prints them, independent of the locale.
#pragma once

#include <optional>
#include <string>

#include "engine/drawing/drawing.h"
#include "engine/drawing/shaft_drawing.h"
#include "engine/shaft/shaft.h"

namespace lathelier::drawing {

inline constexpr const char* diameterPrefix = "⌀";

/// A dimension's text and whether it is a measured one (italic).
struct DimensionText {
    std::string text;  ///< UTF-8
    bool italic = false;
    DimensionTarget target = {};  ///< for Label::target
};

/// As many decimals as the value has, at most `decimals`.
std::string shortNumber(double value, int decimals, const std::string& separator);

/// Three significant digits: a mass, the x of a taper 1:x.
std::string roundedNumber(double value, const std::string& separator);

/// A nominal size with its tolerance: "30 h6", "25 k5 (+0.011/+0.002)", "25 js5 (±0.0045)", "30 ±0.01", "30
/// +0.02/−0.01".
std::string nominalSize(double size_mm, const std::optional<SizeTolerance>& tolerance, const std::string& separator);

/// A measured size: "29.998 ±0.004"; U to 0.001 mm below 0.1, to 0.01 below 1, else to 0.1, and never as 0.
std::string measuredSize(double size_mm, const std::optional<double>& uncertainty_um, const std::string& separator);

/// "M16×2", "M20×4 (P2) LH"; the designation where there is one; empty where too little is known.
std::string threadDesignation(const ShaftMark& mark, const std::string& separator);

/// Translated by the options.
std::string translated(Text text, const DrawingOptions& options);

}  // namespace lathelier::drawing
