// Complete study of a shaft: response, natural frequencies and shapes, mass, static compliance.
#pragma once

#include "engine/beam/natural_frequencies.h"
#include "engine/receptance/shaft/shaft_receptance.h"

namespace lathelier::receptance {

struct ShaftStudy {
    ShaftReceptanceResult response;     ///< as heldShaftReceptance() gives it
    double mass_kg = 0;                 ///< of the whole shaft
    std::optional<double> static_mm_N;  ///< static deflection per force between the two places; none: rigid-body motion
                                        ///< is possible, or the machine is unknown at 0 Hz
    std::vector<double> places_z_mm;    ///< z of the mode shape values
    std::vector<beam::ModeShape> modes;  ///< the first modes, at most mostShapes; empty with a table of receptances
};

inline constexpr std::size_t mostShapes = 4;  ///< largest number of mode shapes computed

/// Errors of heldShaftReceptance(). Throws Cancelled.
ShaftStudy studyShaft(const Shaft& shaft, const ReceptanceParameters& parameters, const ShaftHolding& holding,
                      const Progress& progress = {});

}  // namespace lathelier::receptance
