// Sizes as a drawing prints them: nominal ones upright with their tolerance, measured ones in italics with ± U, and a
// number [n] at those whose nominal size was put in place of a measured one, with their line of the table of
// differences.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/drawing/dimension_texts.h"

namespace lathelier::drawing {

/// A size with what is known of it.
struct Size {
    double value_mm = 0;
    std::optional<double> measured_mm = {};  ///< the same value: as measured; another one: a nominal size is in place
    std::optional<double> U_um = {};         ///< expanded, of the measured one
    std::optional<SizeTolerance> tolerance = {};
};

/// A line of the table of differences.
struct Difference {
    std::string size;  ///< as printed
    double nominal_mm = 0, measured_mm = 0;
    std::optional<double> U_um = {};
};

class SizeTexts {
public:
    /// `options` outlive it.
    explicit SizeTexts(const DrawingOptions& options) : options_(options) {}

    const DrawingOptions& options() const { return options_; }
    std::string number(double value, int decimals = 3) const;
    bool isMeasured(const Size& size) const;
    bool isReplaced(const Size& size) const;  ///< is a nominal size in place of the measured one?

    /// "⌀30 h6", "⌀29.998 ±0.004", "⌀25 k5 (+0.011/+0.002) [1]".
    DimensionText text(const std::string& prefix, const Size& size);
    /// As a part of a longer text, without the number of a difference.
    std::string part(const Size& size) const;
    /// A text of several sizes, with a line for the one that leads.
    DimensionText composed(std::string text, const Size& leading);
    /// A measured number with U and unit: "45.0° ±0.2°"; a nominal one with at most `decimals`.
    std::string withUnit(double value, const std::optional<double>& expanded, bool measured, int decimals,
                         const std::string& unit) const;

    std::vector<Difference> takeDifferences() { return std::move(differences_); }

private:
    const DrawingOptions& options_;
    std::vector<Difference> differences_;
};

}  // namespace lathelier::drawing
