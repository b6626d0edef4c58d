// Superposition of two profiles of the same section, such as the image of the surface and the trace of a roundness
// instrument: the validation of Yurkevich and Orlova (largest difference 1.8 µm, mean 1.4 µm).
#pragma once

#include <vector>

#include "engine/core/error.h"
#include "engine/core/profile.h"
#include "engine/core/progress.h"
#include "engine/form/roundness/roundness.h"

namespace lathelier::form {

struct SuperimposeParameters {
    RoundnessParameters form;  ///< filter and outliers of both; excluded sectors of the first, whose angles they are
    bool mirrored = false;     ///< also try the mirrored second profile
};

struct SuperimposeResult {
    /// A point p of the second profile lies at rotation · mirror · p + shift on the first; mirror turns y into -y.
    double rotation_deg = 0;
    bool mirrored = false;                               ///< y of the second profile was reversed before the rotation
    Eigen::Vector2d shift_mm = Eigen::Vector2d::Zero();  ///< added after the rotation
    double radius_difference_mm = 0;                     ///< second - first, removed
    std::vector<double> angle_deg;                       ///< uniform, in the first profile's coordinates
    std::vector<double> first_um;      ///< deviations from the first's least-squares circle; NaN in gaps
    std::vector<double> second_um;     ///< the same of the second profile after the transformation
    double largest_difference_um = 0;  ///< of |first - second|, gaps left out
    double mean_difference_um = 0;     ///< mean of absolute differences
    double rms_difference_um = 0;      ///< root mean square of first - second
    double correlation = 0;            ///< of the two curves, -1…1; 0 when one of them is a circle
    Notes notes;                       ///< rotationNotDetermined when the form does not determine the rotation
};

/// Least-squares rotation, shift and radius of `second` relative to `first`: all grid rotations by cross-correlation,
/// the best refined between grid angles. Errors as roundness(). Throws Cancelled.
SuperimposeResult superimpose(const Profile& first, const Profile& second, const SuperimposeParameters& parameters = {},
                              const Progress& progress = {});

}  // namespace lathelier::form
