// One Gauss-Newton step of the axis fit with one free radius in every bin.
// Source: biweight of Beaton and Tukey, Technometrics 16 (1974) 147-185; covariance of White, Econometrica 48 (1980)
// 817-838, over patches.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "engine/core/progress.h"
#include "engine/registration/revolution/meridian_bins.h"

namespace lathelier::registration {

/// Sums of one pass: the normal equations of the four axis parameters (per unit variance), and for each bin the sums
/// needed to eliminate its free value.
struct Sums {
    Eigen::Matrix4d hessian = Eigen::Matrix4d::Zero();   ///< Σ w/σ² j jᵀ, by (x, y) at the origin and slopes
    Eigen::Vector4d gradient = Eigen::Vector4d::Zero();  ///< Σ w/σ² e j, e the distance of a point from its bin in mm
    double squares = 0;                                  ///< Σ w e²
    double weights = 0;                                  ///< Σ w
    double side_weights = 0;                             ///< Σ w at the side
    struct Bin {
        double weight = 0;                                   ///< Σ w/σ² of the bin's points
        double error = 0;                                    ///< Σ w/σ² e
        double square = 0;                                   ///< Σ w/σ² e²
        Eigen::Vector4d jacobian = Eigen::Vector4d::Zero();  ///< Σ w/σ² j
    };
    std::vector<Bin> bins;  ///< one for each of MeridianBins::bins

    void add(const Sums& other)
    {
        hessian += other.hessian;
        gradient += other.gradient;
        squares += other.squares;
        weights += other.weights;
        side_weights += other.side_weights;
        if (bins.size() < other.bins.size()) bins.resize(other.bins.size());
        for (std::size_t i = 0; i < other.bins.size(); ++i) {
            bins[i].weight += other.bins[i].weight;
            bins[i].error += other.bins[i].error;
            bins[i].square += other.bins[i].square;
            bins[i].jacobian += other.bins[i].jacobian;
        }
    }
};

struct Step {
    Eigen::Vector4d change = Eigen::Vector4d::Zero();   ///< of (x, y) at the origin in mm and of the two slopes
    Eigen::Matrix4d hessian = Eigen::Matrix4d::Zero();  ///< with the bins' values eliminated, per unit variance
    bool determined = false;  ///< false: the points do not determine the axis; nothing was moved
    Sums sums;                ///< of the pass before the step
};

/// One Gauss-Newton step of axis and bins together. Moves the pose and the bins' values.
Step improve(const std::vector<Eigen::Vector3d>& points, Eigen::Isometry3d& pose, MeridianBins& bins,
             const Progress& progress);

/// Cluster-robust covariance of the axis (H. White's estimator with surface patches as clusters), valid for residuals
/// that are correlated between neighbours. Never less than for independent residuals.
Eigen::Matrix4d covarianceOf(const std::vector<Eigen::Vector3d>& points, const Eigen::Isometry3d& pose,
                             const MeridianBins& bins, const Step& step, const Progress& progress);

}  // namespace lathelier::registration
