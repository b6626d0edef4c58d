// Machines and shafts for the tests of coupling.
#pragma once

#include <numbers>

#include "engine/receptance/coupling.h"
#include "engine/receptance/shaft/shaft_receptance.h"

namespace lathelier::receptance {

inline Shaft cylinder(double length_mm, double diameter_mm)
{
    Shaft shaft;
    shaft.segments = {{length_mm, diameter_mm, diameter_mm, 0, {}, {}}};
    shaft.material = Material{};
    return shaft;
}

/// The half-finished shaft of Miądlicki et al., with a stub toward the chuck.
inline Shaft newPart()
{
    Shaft shaft;
    for (const auto& [length_mm, diameter_mm] : {std::pair{98.0, 30.0}, {10.0, 37.0}, {75.0, 33.8}, {17.0, 40.0}})
        shaft.segments.push_back({length_mm, diameter_mm, diameter_mm, 0, {}, {}});
    shaft.material = Material{};
    return shaft;
}

/// kx = 1.5e7 (1+.06i) N/m, kφ = 1.974e5 (1+.06i) N·m/rad.
inline SpindleReceptance springs()
{
    return {SpindleSprings{15000, 1.974e8, 0.06}};
}

/// Springs behind which the headstock has a mode, with a cross receptance: what no pair of springs is.
inline SpindleTable livelySpindle(double from_hz, double to_hz, double step_hz)
{
    SpindleTable table;
    const ReceptanceMatrix base = springs().at(0);
    for (double f = from_hz; f <= to_hz + step_hz / 2; f += step_hz) {
        const double ratio = f / 640;
        const Complex mode = 1.0 / Complex(1 - ratio * ratio, 2 * 0.04 * ratio) / 40000.0;
        const double lever = -1.0 / 150;  // rotation by deflection of the mode's shape, rad/mm
        table.frequency_hz.push_back(f);
        table.H_mm_N.push_back(base(0, 0) + mode);
        table.L_mm_Nmm.push_back(mode * lever);
        table.P_rad_Nmm.push_back(base(1, 1) + mode * lever * lever);
    }
    return table;
}

}  // namespace lathelier::receptance
