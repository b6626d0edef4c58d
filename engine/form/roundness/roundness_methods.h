// Sensitivity of a roundness value to the method: circles × filters × outlier rules.
#pragma once

#include "engine/form/roundness/prepared_profile.h"

namespace lathelier::form {

/// Cut-offs of ISO 12181-2, in undulations per revolution.
inline constexpr std::array<double, 5> standardCutoffs{15, 50, 150, 500, 1500};

/// The largest cut-off resolved by the spacing of the points: samplesPerCutoff points per wave, also where the spacing
/// is widest.
double carriedCutoff(const signal::AngularSampling& sampling);

/// The largest standard one among them, 0 when there is none.
double carriedStandardCutoff(const signal::AngularSampling& sampling);

/// Without filter, with the standard long-wave passes that the sampling resolves (and one more, marked as
/// undersampled), and with `asked`; each with and without outliers. `chosen` is used for the row of the result itself.
std::vector<MethodRow> methodRows(const Profile& profile, const PreparedProfile& prepared,
                                  const RoundnessParameters& parameters, const ReferenceCircles& chosen,
                                  const Progress& progress);

}  // namespace lathelier::form
