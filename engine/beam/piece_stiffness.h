// The dynamic stiffness of one uniform piece of Timoshenko's beam, exact or by a finite element.
//
// Harmonic motion e^(iωt) of a piece of length 2h, with rotation t positive as dw/ds along the piece:
//   κGA (w″ - t′) + ρA ω² w = 0,   EI t″ + κGA (w′ - t) + ρI ω² t = 0
// Solutions e^(λs) with λ² = y/h² from y² - e₁y + e₂ = 0, e₁ = -(a+b) h², e₂ = (ab - c) h⁴, a = ρIω²/EI, b = ρAω²/κGA,
// c = ρAω²/EI. A piece is symmetric about its middle, so its stiffness decouples into one for symmetric and one for
// antisymmetric motion. With T(y) = tanh(√y)/√y, τ₁τ₂ = h² T(y₁) T(y₂), and the divided differences d = h³ [T(y₁) -
// T(y₂)]/(y₁ - y₂), e = h [y₁T(y₁) - y₂T(y₂)]/(y₁ - y₂):
//   symmetric      1/(e + b d)        [ -ρAω² τ₁τ₂   -ρAω² d           ]
//                                     [ -ρAω² d       EI               ]
//   antisymmetric  1/((ab-c) d + b e) [  ρAω²        -ρAω² e           ]   (common factor ω² cancelled: valid at ω = 0)
//                                     [ -ρAω² e      -EI (ab-c) τ₁τ₂   ]
// Only tanh is needed, so nothing overflows however long the piece; d and e come from a power series where |y| is
// small, so nothing cancels however short it is.
//
// The finite element has two nodes, linear deflection and rotation with consistent mass, and a shear stiffness reduced
// by the residual bending flexibility (R. H. MacNeal): nodally exact in statics, order (length)² in frequencies.
#pragma once

#include "engine/beam/matrix2.h"

namespace lathelier::beam {

/// Shape functions within a piece.
enum class BeamMethod { Exact, FiniteElements };

/// Constants of a uniform piece; S is double without damping, Complex with.
template <class S>
struct PieceConstants {
    double half_mm = 0;      ///< half length h
    double mass_t_mm = 0;    ///< ρA, tonne per mm
    double rotary_t_mm = 0;  ///< ρI, tonne·mm² per mm
    S bending_N_mm2 = 0;     ///< complex bending stiffness EI (1+iη)
    S a_s2_mm2 = 0;          ///< ρI/EI
    S b_s2_mm2 = 0;          ///< ρA/κGA
    S c_s2_mm4 = 0;          ///< ρA/EI
};

/// Forces at the ends of a piece by motions of its ends; s runs from left to right. The rest follows by symmetry:
/// left by left is `right.mirrored()`, right by left is `across.transposed()`.
template <class S>
struct PieceStiffness {
    Matrix2<S> right;   ///< force and moment at the right end by its motion, N/mm, N, N·mm
    Matrix2<S> across;  ///< force and moment at the left end by motion of the right end
};

template <class S>
PieceConstants<S> pieceConstants(double length_mm, double mass_t_mm, double rotary_t_mm, const S& bending_N_mm2,
                                 const S& shear_N);

/// At angular frequency `omega_rad_s` ≥ 0.
template <class S>
PieceStiffness<S> exactStiffness(const PieceConstants<S>& piece, double omega_rad_s);
template <class S>
PieceStiffness<S> elementStiffness(const PieceConstants<S>& piece, double omega_rad_s);

template <class S>
PieceStiffness<S> pieceStiffness(BeamMethod method, const PieceConstants<S>& piece, double omega_rad_s)
{
    return method == BeamMethod::Exact ? exactStiffness(piece, omega_rad_s) : elementStiffness(piece, omega_rad_s);
}

}  // namespace lathelier::beam
