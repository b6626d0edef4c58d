// Limits and fits of ISO 286-1:2010: standard tolerances IT5 to IT13 and fundamental deviations of shafts
// d e f g h js k m n p and of holes D E F G H JS, nominal sizes up to 500 mm.
//
// Shafts d to h: upper = deviation, lower = upper - IT; k to p: lower = deviation, upper = lower + IT; js: ±IT/2.
// Beyond IT7 the deviation of k is 0. Holes D to H mirror the shafts of the same letter: lower = -(upper of the shaft).
// Holes K and beyond follow another rule (with Δ) and are not known here.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lathelier::features {

/// Limit deviations of a size from its nominal size.
struct Limits {
    double lower_um = 0, upper_um = 0;
    friend bool operator==(const Limits&, const Limits&) = default;
};

/// A tolerance class: "h6" is deviation "h", grade 6.
struct IsoClass {
    std::string deviation;  ///< lower case: of a shaft; upper case: of a hole
    int grade = 0;          ///< 5 to 13
    friend bool operator==(const IsoClass&, const IsoClass&) = default;
};

enum class Surface { Outer, Bore };

/// None: not a class that is known here.
std::optional<IsoClass> parseIsoClass(std::string_view text);

/// Standard tolerance of a grade; none: grade outside 5 to 13, or size not in ]0, 500] mm.
std::optional<double> standardTolerance_um(int grade, double nominal_mm);

/// Limits of a class ("h6") at a nominal size; none: class not known, or size not in ]0, 500] mm.
std::optional<Limits> limitsOf(std::string_view iso_class, double nominal_mm);

/// Classes IT5 to IT11 whose zone about `nominal_mm` contains measured_mm ± U_mm, tightest first, at most three; of
/// equal grades in the order of the letters. Empty: none, or size not in ]0, 500] mm.
std::vector<std::string> fitsOf(double measured_mm, double U_mm, double nominal_mm, Surface surface = Surface::Outer);

}  // namespace lathelier::features
