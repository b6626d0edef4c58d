// Shafts for the tests of beams.
#pragma once

#include <limits>
#include <vector>

#include "engine/beam/beam_model.h"

namespace lathelier::beam {

/// Stiffness of a practically rigid support.
inline constexpr double rigid = std::numeric_limits<double>::infinity();

inline Shaft cylinder(double length_mm, double diameter_mm, double bore_mm = 0)
{
    Shaft shaft;
    shaft.segments = {{length_mm, diameter_mm, diameter_mm, bore_mm, {}, {}}};
    return shaft;
}

inline Shaft rod40()
{
    return cylinder(250, 40);
}

inline Shaft stepped(const std::vector<std::pair<double, double>>& length_and_diameter_mm)
{
    Shaft shaft;
    for (const auto& [length_mm, diameter_mm] : length_and_diameter_mm)
        shaft.segments.push_back({length_mm, diameter_mm, diameter_mm, 0, {}, {}});
    return shaft;
}

/// Miądlicki et al., Remanufacturing System with Chatter Suppression for CNC Turning, Table 1.
inline Shaft shaftOfPaperB()
{
    return stepped({{98, 30}, {10, 37}, {75, 33.8}});
}

inline BeamParameters with(ShearModel shear, BeamMethod method = BeamMethod::Exact)
{
    BeamParameters parameters;
    parameters.shear = shear;
    parameters.method = method;
    return parameters;
}

inline Material lossless()
{
    Material material;
    material.loss_factor = 0;
    return material;
}

}  // namespace lathelier::beam
