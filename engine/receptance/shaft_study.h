// All that is asked of a shaft at once: response, natural frequencies and shapes, mass, static compliance.
#pragma once

#include "engine/beam/natural_frequencies.h"
#include "engine/receptance/shaft_receptance.h"

namespace lathelier::receptance {

struct ShaftStudy {
    ShaftReceptanceResult response;      ///< as heldShaftReceptance() gives it
    double mass_kg = 0;                  ///< of the whole shaft
    std::optional<double> static_mm_N;   ///< deflection per force at rest between the two places asked for; none: the
                                         ///< shaft can move without bending, or its machine is not known at rest
    std::vector<double> places_z_mm;     ///< along the shaft, of the shapes
    std::vector<beam::ModeShape> modes;  ///< the first ones, at most mostShapes; none with a table of receptances
};

inline constexpr std::size_t mostShapes = 4;  ///< whose shapes are found

/// Errors of heldShaftReceptance(). Throws Cancelled.
ShaftStudy studyShaft(const Shaft& shaft, const ReceptanceParameters& parameters, const ShaftHolding& holding,
                      const Progress& progress = {});

}  // namespace lathelier::receptance
