// How a shaft swings under a force at one place and one frequency, and its surface doing so.
#pragma once

#include <vector>

#include "engine/core/skin.h"
#include "engine/receptance/shaft/shaft_receptance.h"

namespace lathelier::receptance {

/// Operating deflection shape: G(z, z of the force) at one frequency.
struct ForcedShape {
    double frequency_hz = 0;
    double force_z_mm = 0;                 ///< ReceptanceParameters::excite_z_mm
    std::vector<double> z_mm;              ///< evenly from the free end to the chuck face
    std::vector<Complex> deflection_mm_N;  ///< per force, at each z

    double largestDeflection() const;  ///< the largest |deflection|, mm/N
    double phaseBehindForce() const;   ///< of the largest deflection, rad
};

/// Of the shaft as heldShaftReceptance() holds it. Precondition: its response is known at that frequency, > 0. Errors:
/// those of heldShaftReceptance().
ForcedShape forcedShape(const Shaft& shaft, const ReceptanceParameters& parameters, const ShaftHolding& holding,
                        double frequency_hz);

/// The shaft without its bores, swinging along x of the frame, z from the free end. `phase_rad`: 0 where the largest
/// deflection is. The displacement is 1 mm there at its largest; values: the deflection at phase 0 in µm/N.
Skin swingingSkin(const Shaft& shaft, const ForcedShape& shape, double phase_rad);

}  // namespace lathelier::receptance
