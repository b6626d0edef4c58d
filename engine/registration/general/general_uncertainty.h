// Uncertainty of a general pose with correlated residuals (noise along scan lines, walls, uneven coverage): the
// cluster-robust "sandwich" covariance A⁻¹ M A⁻¹, M the sum over clusters of the outer product of their score vectors.
// Sources: K.-Y. Liang, S. L. Zeger, "Longitudinal data analysis using generalized linear models", Biometrika 73
// (1986); P. J. Huber, E. M. Ronchetti, "Robust Statistics", 2009, section 7.6 (the bread for robust weights).
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "engine/registration/general/observability.h"

namespace lathelier::registration {

/// One point of the copy at the end of the alignment.
struct MotionResidual {
    Eigen::Vector3d point_mm;  ///< in the reference's frame
    Eigen::Vector3d normal;
    double distance_mm = 0;
    double weight = 0;                  ///< Tukey's, above 0
    double slope = 0;                   ///< derivative of weight × distance
    std::uint32_t copy_input = 0;       ///< place in the copy's file
    std::uint32_t reference_input = 0;  ///< place of the nearest point in the reference's file; 0 for a mesh
};

/// Expanded uncertainty (k = 2) of the motion that `system` and `observability` describe. The correlation is not known:
/// clusters of several sizes are formed, cubes in space and runs in the order of either file (scan lines), and the
/// largest result is taken. Where it still grows with the cluster size, it is extrapolated by one step. Not less than
/// for independent residuals of `sigma_mm`.
AlignmentUncertainty clusteredUncertainty(const MotionSystem& system, const Observability& observability,
                                          double sigma_mm, const std::vector<MotionResidual>& residuals);

}  // namespace lathelier::registration
