// Receptance coupling of a free shaft to a machine, both with known receptances.
//
// Rigid joint j between beam b and spindle s (T. L. Schmitz and R. R. Donaldson, CIRP Annals 49 (2000) 303):
//   G_ac = Hb_ac - Hb_aj (Hb_jj + Hs)⁻¹ Hb_jc
// Valid for Hs = 0 (clamped). An elastic joint adds its compliance to Hs; several joints stack their coordinates, with
// Hs block diagonal. At frequencies far below the first resonance both terms are large and cancel: there
// BeamReceptance::at() with a chuck stiffness is the better way.
// Signs: θ = dw/dx with x from the chuck face toward the free end, for both parts.
#pragma once

#include <Eigen/Core>
#include <span>

#include "engine/receptance/spindle/spindle_receptance.h"

namespace lathelier::receptance {

/// Receptances of the free shaft required for coupling at one joint.
struct FreeReceptances {
    ReceptanceMatrix ac;  ///< response place by excitation place
    ReceptanceMatrix aj;  ///< response place by joint
    ReceptanceMatrix jj;  ///< joint by joint
    ReceptanceMatrix jc;  ///< joint by excitation place
};

/// Rigid coupling at one joint to a part of receptance `spindle`.
ReceptanceMatrix coupled(const FreeReceptances& beam, const ReceptanceMatrix& spindle);

/// A joint of several, such as chuck and tailstock.
struct Joint {
    ReceptanceMatrix aj;     ///< of the free shaft: response place by this joint
    ReceptanceMatrix jc;     ///< of the free shaft: this joint by excitation place
    ReceptanceMatrix other;  ///< of the part joined here
};

/// Rigid coupling at several joints. `beam_jj`: the free shaft's receptance of joint i by joint k at [i * n + k].
ReceptanceMatrix coupled(const ReceptanceMatrix& beam_ac, std::span<const Joint> joints,
                         std::span<const ReceptanceMatrix> beam_jj);

/// A spindle behind an elastic joint: Hs + K⁻¹.
ReceptanceMatrix behindJoint(const ReceptanceMatrix& spindle, const SpindleSprings& joint);

/// A driving-point receptance with an added mass: G/(1 - ω² m G). A negative mass removes one, such as that of an
/// accelerometer.
Complex withMass(const Complex& receptance_mm_N, double mass_kg, double frequency_hz);

}  // namespace lathelier::receptance
