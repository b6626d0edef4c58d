// One frequency line of inverse receptance coupling: the spindle from responses on rods in its chuck.
//
// Unknown: Hs = [[H, L], [L, P]] of the chuck face. Known, of each free rod: Hb between its points and the joint j.
// Linear start: a force at b gives the joint a reaction r_b with x_a = Hb_ab + Hb_aj r_b at all points a (least
// squares, at least 2 points); the joint moves by u_b = Hb_jb + Hb_jj r_b, and u_b = -Hs r_b is linear in H, L, P.
// Refinement by Gauss and Newton on G_ab(Hs) = Hb_ab - Hb_aj (Hb_jj + Hs)⁻¹ Hb_jb, with
//   dG_ab = U_aᵀ dHs U_b, U = (Hb_jj + Hs)⁻¹ Hb_j.
// L is scaled by 100 mm, P by its square, so that the three unknowns have comparable magnitude.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "engine/receptance/spindle/spindle_receptance.h"

namespace lathelier::receptance {

/// H, 100 mm·L, (100 mm)²·P, all in mm/N.
using ScaledSpindle = Eigen::Vector3cd;

ReceptanceMatrix matrixOf(const ScaledSpindle& spindle);
ScaledSpindle scaledOf(const ReceptanceMatrix& spindle);

/// One measured response at one line. "Free rod": with the accelerometer of this response on it.
struct LineResponse {
    std::size_t rod = 0;       ///< index of the rod
    std::size_t point_a = 0;   ///< index of the point; groups responses for the linear start
    std::size_t point_b = 0;   ///< index of the other point
    Complex measured;          ///< measured receptance, mm/N
    double weight = 1;         ///< 1/σ of `measured`; 0: not used
    std::size_t loaded = 0;    ///< index in `free_jj`: the rod with its accelerometer at point_a
    Complex free;              ///< receptance of the free rod, Hb_ab
    Eigen::Vector2cd joint_a;  ///< Hb_ja of the free rod: motion (w, θ) of the joint per force at a
    Eigen::Vector2cd joint_b;  ///< Hb_jb of the free rod
};

/// One line of all measurements.
struct SpindleLine {
    std::vector<LineResponse> responses;    ///< responses of the rods used
    std::vector<ReceptanceMatrix> free_jj;  ///< by loaded rod: receptance of the free rod at the joint
};

/// Gauss-Newton solution at one line.
struct LineFit {
    ScaledSpindle spindle = ScaledSpindle::Zero();  ///< scaled unknowns H, L, P
    std::size_t responses = 0;                      ///< number of responses with non-zero weight
    double cost = 0;                                ///< weighted sum of squared residuals
    double condition = 0;                           ///< of the weighted Jacobian, largest over smallest singular value
    Eigen::Matrix3cd information = Eigen::Matrix3cd::Zero();  ///< Jᴴ J: inverse covariance of the unknowns
    bool converged = false;                                   ///< the last step was below the convergence limit
};

/// The response predicted by a spindle.
Complex responseOn(const SpindleLine& line, const LineResponse& response, const ScaledSpindle& spindle);

/// The change of the response with the scaled unknowns.
Eigen::RowVector3cd gradientOn(const SpindleLine& line, const LineResponse& response, const ScaledSpindle& spindle);

/// None where no loaded rod has two points with a force in common.
std::optional<ScaledSpindle> linearStart(const SpindleLine& line);

inline constexpr int mostSteps = 60;

/// At most `most_steps` of Gauss and Newton.
LineFit refine(const SpindleLine& line, const ScaledSpindle& start, int most_steps = mostSteps);

}  // namespace lathelier::receptance
