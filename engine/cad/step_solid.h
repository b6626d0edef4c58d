// A contour revolved by OpenCASCADE and written as STEP, with placeholders for names.
#pragma once

#include <string>

#include "engine/cad/step_writer.h"
#include "engine/shaft/shaft_contour.h"

namespace lathelier::cad {

/// The texts of the kernel's file: each is a complete quoted string.
namespace placeholders {
inline constexpr const char* file = "@file@";
inline constexpr const char* product = "@product@";
inline constexpr const char* description = "@description@";
inline constexpr const char* author = "@author@";
inline constexpr const char* organisation = "@organisation@";
inline constexpr const char* time = "@time@";
inline constexpr const char* system = "@system@";
inline constexpr const char* kernel = "@kernel@";
}  // namespace placeholders

struct ExpectedVolume {
    double volume_mm3 = 0;
    double tolerance_mm3 = 0;  ///< largest difference of the volumes
};

/// The closed contour (clockwise in z and r, pieces on the axis without a row) as one solid in a STEP file with
/// placeholders. Errors solidNotBuilt, solidVolumeWrong. Throws Cancelled.
std::string revolvedStep(const Contour& closed, StepSchema schema, const ExpectedVolume& expected,
                         const Progress& progress);

}  // namespace lathelier::cad
