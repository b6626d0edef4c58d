// The fine stage of a general alignment: robust point-to-plane steps until they no longer move the part.
// Source: Y. Chen, G. Medioni, "Object modelling by registration of multiple range images", Image and Vision Computing
// 10 (1992); weights: J. W. Tukey's biweight about the median absolute deviation.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "engine/core/progress.h"
#include "engine/registration/general/general_uncertainty.h"
#include "engine/registration/general/observability.h"
#include "engine/registration/neighbours/neighbours.h"
#include "engine/registration/surface/surface.h"

namespace lathelier::registration {

struct RefineOptions {
    double search_mm = 1;  ///< points further from the surface do not take part
    double reach_mm =
        0;  ///< range of the weights in the first step; halved until the scatter of the residuals determines it
    int max_iterations = 40;
    double tolerance_mm = 1e-4;  ///< converged when no point of the part moves further than this in one step
    bool point_to_point = false;
    bool keep_residuals = false;
};

struct RefineResult {
    Eigen::Isometry3d reference_T_copy = Eigen::Isometry3d::Identity();
    bool converged = false;
    int iterations = 0;
    double sigma_mm = 0;    ///< robust standard deviation of the residuals
    double used_share = 0;  ///< of the points, with a weight above 0
    MotionSystem system;
    Observability observability;
    std::vector<MotionResidual>
        residuals;  ///< of the last step, with RefineOptions::keep_residuals; `copy_input` is an index into `copy_mm`
};

/// The alignment target: the surface, and for point-to-point its points.
struct RefineTarget {
    const Surface* surface = nullptr;
    const Neighbours* points = nullptr;
};

/// Moves `copy_mm` (in Hilbert order) from `start` onto the target. Undetermined motions are taken toward `initial`.
/// `converged` stays false when the iterations are used up. `traces`: empty, or from an earlier call with the same
/// target and points; they save time. Throws Cancelled.
RefineResult refine(const RefineTarget& target, const std::vector<Eigen::Vector3d>& copy_mm,
                    const Eigen::Isometry3d& start, const Eigen::Isometry3d& initial, const RefineOptions& options,
                    std::vector<Surface::Trace>& traces, const Progress& progress = {});

/// Mean of min(1, (distance / limit)²) over the copy's points: the misfit of a pose.
double misfit(const Surface& surface, const std::vector<Eigen::Vector3d>& copy_mm,
              const Eigen::Isometry3d& reference_T_copy, double limit_mm, const Progress& progress = {});

}  // namespace lathelier::registration
