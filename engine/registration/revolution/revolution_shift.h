// Coarse axial shift between two radius profiles: the start of axial_shift_estimate.h.
#pragma once

#include <limits>
#include <optional>

#include "engine/registration/revolution/revolution_axis.h"

namespace lathelier::registration {

double lengthOf(const RadiusProfile& profile);  ///< mm
double middleOf(const RadiusProfile& profile);  ///< z, mm

/// Radius at z between two known bins (mm), with slope and standard uncertainty; nullopt where either is unknown.
struct RadiusReading {
    double radius, slope, sigma;
};
std::optional<RadiusReading> readRadius(const RadiusProfile& profile, double z_mm);

struct ShiftMatch {
    double shift = 0;                                       ///< reference z = copy z + shift, mm
    double cost = std::numeric_limits<double>::infinity();  ///< mean capped difference in mm; infinite: no match
};

/// Best shift within `reach` of `centre` (mm) by the mean difference of the radii, capped at `cap`: a coarse scan, then
/// finer ones around the best. Among equally good shifts the nearest to `home` is taken. Infinite cost:
/// they overlap by a quarter at no shift.
ShiftMatch findShift(const RadiusProfile& reference, const RadiusProfile& copy, double centre, double reach,
                     double home, double cap);

}  // namespace lathelier::registration
