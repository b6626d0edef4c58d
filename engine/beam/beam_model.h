// A shaft in bending as a chain of uniform pieces between nodes, with its supports.
#pragma once

#include <span>
#include <vector>

#include "engine/beam/beam_section.h"
#include "engine/beam/piece_stiffness.h"
#include "engine/core/material.h"
#include "engine/shaft/shaft.h"

namespace lathelier::beam {

/// A spring between the shaft and the ground: chuck, tailstock, steady rest. Infinity is a rigid hold.
struct Support {
    double z_mm = 0;           ///< from the free end: 0 for a tailstock, the length for a chuck
    double radial_N_mm = 0;    ///< radial stiffness
    double tilt_N_mm_rad = 0;  ///< rotational stiffness
    double loss_factor = 0;    ///< of both springs: complex stiffness k (1 + i·loss_factor)
};

/// Parameters of the beam model of a shaft.
struct BeamParameters {
    ShearModel shear = ShearModel::Hutchinson;  ///< formula of the shear coefficient κ
    BeamMethod method = BeamMethod::Exact;      ///< shape functions within a piece
    bool step_correction = false;               ///< limit the stiffness beside steps (uniform_segments.h)
    double modal_damping_ratio = 0;  ///< ζ beside the material's η: adds 2ζ to it, which is the same at each resonance
    double element_length_mm = 2.5;  ///< FiniteElements: longest element, but a hundredth of the shaft at most
    int taper_pieces = 50;           ///< uniform pieces of a taper or arc
    std::vector<Support> supports;   ///< empty: free-free
};

/// One piece of the chain.
struct BeamPiece {
    double length_mm = 0;         ///< length of the piece, > 0
    double mass_t_mm = 0;         ///< mass per length ρA
    double rotary_t_mm = 0;       ///< ρI, tonne·mm² per mm
    double bending_N_mm2 = 0;     ///< bending stiffness EI
    double shear_N = 0;           ///< shear stiffness κGA
    bool same_as_before = false;  ///< equal to the previous piece, whose matrices are reused

    /// With the complex modulus (1 + i·loss_factor), or for S = double without damping.
    template <class S>
    PieceConstants<S> constants(double loss_factor) const;
};
template <>
PieceConstants<double> BeamPiece::constants(double loss_factor) const;
template <>
PieceConstants<Complex> BeamPiece::constants(double loss_factor) const;

/// Support of a node: spring and rigid constraints.
struct NodeSupport {
    double radial_N_mm = 0;       ///< real part of the stiffness
    double radial_loss_N_mm = 0;  ///< imaginary part of the stiffness
    double tilt_N_mm = 0;         ///< N·mm/rad, real part
    double tilt_loss_N_mm = 0;    ///< imaginary part of the stiffness
    Held held;                    ///< rigidly constrained motions

    template <class S>
    Matrix2<S> stiffness() const;
};
template <>
Matrix2<double> NodeSupport::stiffness() const;
template <>
Matrix2<Complex> NodeSupport::stiffness() const;

/// Nodes 0…n from the free end (z = 0) toward the chuck, piece i between nodes i and i+1. Rotations are dw/dz here.
struct BeamModel {
    BeamMethod method = BeamMethod::Exact;  ///< method of all pieces
    double length_mm = 0;                   ///< length of the shaft
    double loss_factor = 0;                 ///< of the modulus: material and modal damping together
    std::vector<BeamPiece> pieces;          ///< n pieces from the free end
    std::vector<NodeSupport> supports;      ///< support of each of the n + 1 nodes
    std::vector<std::size_t> places;        ///< node index of each requested place
};

/// The pieces are cut at the places and supports, for FiniteElements to the length of an element, and so that none is
/// longer than `longest_piece_mm` (0: any). Errors: those of uniformSegments(); placeOutsideShaft; valueOutOfRange (a
/// stiffness, loss factor or material that is not a number ≥ 0).
BeamModel beamModel(const Shaft& shaft, const Material& material, const BeamParameters& parameters,
                    std::span<const double> places_z_mm);

/// The same with every piece cut so that at `frequency_hz` none of them has a natural frequency below it when both its
/// ends are held: half a wavelength is longer than the piece. Then the negative eigenvalues of the chain count its
/// natural frequencies (W. H. Wittrick and F. W. Williams, Q. J. Mech. Appl. Math. 24 (1971) 263).
BeamModel cutForCounting(const BeamModel& model, double frequency_hz);

/// Number of rigid-body motions: 2 when free, 1 with one radial spring, 0 when supported.
int rigidBodyMotions(const BeamModel& model);

}  // namespace lathelier::beam
