// The undamped dynamic stiffness of a chain of pieces: its negative eigenvalues, and its solution.
#pragma once

#include <vector>

#include "engine/beam/beam_model.h"

namespace lathelier::beam {

/// Motion, or load, of a node: deflection or force, rotation dw/dz or moment.
struct NodeVector {
    double w = 0;  ///< deflection, mm; or force, N
    double t = 0;  ///< rotation, rad; or moment, N·mm
};

class BeamChain {
public:
    explicit BeamChain(BeamModel model);

    const BeamModel& model() const { return model_; }

    /// Number of negative eigenvalues of the stiffness at `omega_rad_s` > 0, without rigidly held motions.
    int negativeEigenvalues(double omega_rad_s);

    /// The motion under `load`, one for each node, at `omega_rad_s`.
    std::vector<NodeVector> solve(double omega_rad_s, std::vector<NodeVector> load);

private:
    Matrix2<double> pivotOf(std::size_t node, const Matrix2<double>& left) const;
    void computeStiffness(double omega_rad_s);

    BeamModel model_;
    std::vector<PieceConstants<double>> constants_;
    std::vector<PieceStiffness<double>> stiffness_;
};

}  // namespace lathelier::beam
