// Receptances of a shaft between places along it, one line of frequency after the other.
//
// The dynamic stiffness of a chain of pieces is block tridiagonal with 2×2 blocks. One sweep from the free end and one
// from the chuck give for each node the stiffness l and r of the parts to its left and right (without the supports s at
// the node); then G at a node is (l + s + r)⁻¹, and motion propagates from node to node by -Y⁻¹ Bᵀ, where Y is the
// pivot of the next node and B the coupling. O(pieces) a line, two inversions of 2×2 each, no growing exponentials.
//
// Signs: θ = dw/dx with x from the chuck face toward the free end (x = length - z). L and N change their sign with the
// direction of x; H and P do not.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "engine/beam/beam_model.h"
#include "engine/core/progress.h"

namespace lathelier::beam {

/// [[H, L], [N, P]]: H = w per F (mm/N), L = w per M (mm/(N·mm)), N = θ per F (rad/N), P = θ per M (rad/(N·mm)).
using ReceptanceMatrix = Eigen::Matrix2cd;

/// Computes line by line. Contains scratch memory: use one copy per thread.
class BeamReceptance {
public:
    explicit BeamReceptance(BeamModel model);

    std::size_t places() const { return model_.places.size(); }

    /// To result[a * places() + c]: the response at place a per excitation at place c. At 0 Hz the static compliance,
    /// NaN for a shaft that can move without bending. Precondition: frequency ≥ 0, memory for places()² matrices.
    void at(double frequency_hz, std::span<ReceptanceMatrix> result);

    /// The same of the shaft on a machine: `chuck_stiffness` (the inverse of a receptance matrix, signs as above)
    /// supports its end at the chuck. Equal to receptance coupling up to rounding, without its cancellation at low
    /// frequencies.
    void at(double frequency_hz, const ReceptanceMatrix& chuck_stiffness, std::span<ReceptanceMatrix> result);

private:
    void compute(double frequency_hz, std::span<ReceptanceMatrix> result);
    void sweep();
    void fillFrom(std::size_t order, std::span<ReceptanceMatrix> result) const;

    BeamModel model_;
    bool isMovable_;                                  ///< true: rigid-body motions exist
    std::vector<std::size_t> byNode_;                 ///< indices of the places in ascending order of their node
    std::vector<PieceConstants<Complex>> constants_;  ///< by piece
    std::vector<Matrix2<Complex>> support_;           ///< support stiffness by node
    std::vector<PieceStiffness<Complex>> stiffness_;  ///< by piece, at the current frequency
    std::vector<Matrix2<Complex>> right_;             ///< by node: stiffness of the part toward the chuck
    std::vector<Matrix2<Complex>> pass_;              ///< by piece: motion of the right node per motion of the left one
    std::vector<Matrix2<Complex>> driving_;           ///< (l + s + r)⁻¹ of the places in order of nodes
};

/// All lines: values[line * places² + a * places + c]. On all cores; the same bits for any number of them.
/// Errors: those of beamModel(); Throws Cancelled.
std::vector<ReceptanceMatrix> beamReceptances(const Shaft& shaft, const Material& material,
                                              const BeamParameters& parameters, std::span<const double> places_z_mm,
                                              std::span<const double> frequency_hz, const Progress& progress = {});

}  // namespace lathelier::beam
