// Alignment of parts of any shape: a coarse pose without a manual start, then robust point-to-plane steps with the
// motions that the geometry leaves open projected out.
#pragma once

#include "engine/core/progress.h"
#include "engine/core/scan.h"
#include "engine/registration/alignment.h"
#include "engine/registration/compare.h"
#include "engine/registration/general/general_reference.h"

namespace lathelier::registration {

/// Brings `copy` onto `reference`; either may be a cloud or a mesh (a copy's mesh is sampled by area).
/// `method` Point: point-to-point, offered for comparison; anything else: point-to-plane. `initial` Identity: only the
/// fine stage, from the poses as they are. Parts that do not match still get an alignment: the caller judges the
/// overlap.
///
/// Result: `converged` false when the iterations ended before the steps became small. Motions the geometry leaves open
/// are listed in `free_motions` with the note motionNotDetermined, weak ones noted as motionWeak; along free ones the
/// copy stays as near to where it was as it can. Several poses that fit equally well: the smallest rotation, note
/// severalPosesFit. Uncertainty (k = 2, general_uncertainty.h): of the translation of the centre of the points used
/// (`axial_um`, the radius that holds it; `radial_um` the same across its largest direction) and of the rotation
/// (`axis_deg`), for residuals that may be correlated between neighbours and along scan lines. Errors, with `role`
/// (reference, copy): tooFewPoints (fewer than 4), pointsDegenerate (on one point or line). Throws Cancelled.
Alignment alignGeneral(const Scan& reference, const Scan& copy, CompareMethod method, InitialPose initial,
                       const Progress& progress = {});

/// The same onto a reference that was prepared before.
Alignment alignGeneral(const GeneralReference& reference, const Scan& copy, CompareMethod method, InitialPose initial,
                       const Progress& progress = {});

}  // namespace lathelier::registration
