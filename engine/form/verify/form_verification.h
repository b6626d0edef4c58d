// Verification of the form room: circles, cylinders, straightness, the Gaussian filter, harmonics.
#pragma once

#include <string>

#include "engine/core/verification.h"

namespace lathelier::form {

/// Circles: full turns and quarter arcs, also a thousand radii from the origin, with deviations orthogonal to the
/// least-squares parameters; lobes, ellipse, nested squares and Reuleaux triangle for the other three circles;
/// scattered points against all possible contact sets; the certificate's gap. Cylinders in several poses, straightness,
/// the Gaussian filter and harmonics. From a folder: NIST circle sets (`.ds`, `.fit`).
const VerifyPart& formVerification();

/// Answers are known to rounding; certified ones agree between programs to some billionths of a millimetre.
inline constexpr double answerLimit_mm = 2e-9;

VerifyKind verifyLeastSquaresCircles();
VerifyKind verifyMinimumZoneCircles();
VerifyKind verifyInscribedCircles();
VerifyKind verifyCircumscribedCircles();
VerifyKind verifyScatteredZones(const Progress& progress);
VerifyKind verifyCertificates(const Progress& progress);
VerifyKind verifyLeastSquaresCylinders(const Progress& progress);
VerifyKind verifyMinimumZoneCylinders(const Progress& progress);
VerifyKind verifyStraightness();
VerifyKind verifyGaussianFilter();
VerifyKind verifyHarmonics();
/// Errors: fileNotFound, notAFile, fileNotReadable, malformed, referenceDataMissing (no circle sets in the folder).
VerifyKind verifyNistCircles(const std::string& directory, const Progress& progress);

}  // namespace lathelier::form
