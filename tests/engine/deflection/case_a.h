// Shafts and cuts of the tests, those of the DRITTO paper's case A among them.
#pragma once

#include <vector>

#include "engine/deflection/case_a.h"
#include "engine/deflection/deflection.h"

namespace lathelier::deflection {

inline Shaft rod(double length_mm, double diameter_mm, double bore_mm = 0)
{
    Shaft shaft;
    shaft.segments = {{length_mm, diameter_mm, diameter_mm, bore_mm, {}, {}}};
    return shaft;
}

/// One cut at constant radius, from a little before the free end.
inline std::vector<ToolRun> straightCut(double radius_mm, double to_z_mm, double from_z_mm = -2,
                                        double feed_mm_rev = 0.2)
{
    return {
        {ToolRun::Kind::TowardChuck, {{from_z_mm, radius_mm, feed_mm_rev, 7}, {to_z_mm, radius_mm, feed_mm_rev, 8}}}};
}

inline std::vector<ToolRun> caseARuns()
{
    return straightCut(14, 280);
}

inline double errorAt(const PassResult& pass, double z_mm)
{
    for (std::size_t i = 1; i < pass.z_mm.size(); ++i)
        if (pass.z_mm[i] >= z_mm) {
            const double share = (z_mm - pass.z_mm[i - 1]) / (pass.z_mm[i] - pass.z_mm[i - 1]);
            return pass.diameter_error_um[i - 1] + share * (pass.diameter_error_um[i] - pass.diameter_error_um[i - 1]);
        }
    return pass.diameter_error_um.back();
}

}  // namespace lathelier::deflection
