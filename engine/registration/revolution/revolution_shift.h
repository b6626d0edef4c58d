// Coarse axial shift between two turned parts: the starts of axial_shift_estimate.h.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "engine/registration/revolution/revolution.h"

namespace lathelier::registration {

double lengthOf(const RadiusProfile& profile);  ///< mm
double middleOf(const RadiusProfile& profile);  ///< z, mm

/// Radius at z between two known bins (mm), with slope and standard uncertainty; nullopt where either is unknown.
struct RadiusReading {
    double radius, slope, sigma;
};
std::optional<RadiusReading> readRadius(const RadiusProfile& profile, double z_mm);

/// What the two parts have in common at one shift.
struct ShiftMatch {
    double shift = 0;  ///< reference z = copy z + shift, mm
    /// Difference, and half the cap for what does not overlap; mm.
    double cost = std::numeric_limits<double>::infinity();
    double difference_mm = 0;        ///< mean difference of the radii, each capped
    double difference_sigma_mm = 0;  ///< standard error of that mean, from its scatter over the bins
    double overlap = 0;              ///< length in common over that of the shorter part, 0…1
};

/// Mean difference of the radii of two parts as a function of the shift between them. The radius on a shoulder, where
/// there is none, is that of the nearer side, so that the shoulders count; and beyond an end face that a scan shows
/// there is nothing, so that material of the other part there counts as the largest difference.
class ShiftSearch {
public:
    /// A difference of the radii above `cap_mm` counts as `cap_mm`.
    ShiftSearch(const TurnedPart& reference, const TurnedPart& copy, double cap_mm);

    /// The cost is infinite where they overlap by too little.
    ShiftMatch at(double shift) const { return at(shift, 1); }

    /// The shifts within `reach` of `centre` (mm) from which an alignment is worth while, the best first: a coarse
    /// scan, then finer ones around its least costs. Among equally good shifts the nearest to `initial_shift` is taken.
    std::vector<ShiftMatch> starts(double centre, double reach, double initial_shift) const;

private:
    struct Part {
        RadiusProfile profile;                                            ///< without gaps at shoulders
        double known_mm = 0;                                              ///< length with a radius
        double first_mm = 0, last_mm = 0;                                 ///< z where that begins and ends
        double face_first_mm = -std::numeric_limits<double>::infinity();  ///< nothing is before it
        double face_last_mm = std::numeric_limits<double>::infinity();    ///< nothing is beyond it
    };
    static Part partOf(const TurnedPart& part);
    ShiftMatch at(double shift, std::size_t stride) const;
    std::vector<ShiftMatch> scan(double from, double to, double step, std::size_t stride) const;
    ShiftMatch best(const std::vector<ShiftMatch>& matches, double initial_shift) const;

    Part reference_, copy_;
    double cap_mm_;
    double step_mm_;
};

}  // namespace lathelier::registration
