// What can be verified of form: circles, cylinders, straightness, the Gaussian filter, harmonics.
#pragma once

#include <string>

#include "engine/core/verification.h"

namespace lathelier::form {

/// Circles: whole turns and quarter arcs, also a thousand radii off, with deviations that leave the least-squares
/// answer exact; lobes, ellipse, nested squares and Reuleaux triangle for the other three; scattered points against
/// all their possible contacts; the certificate's gap. Cylinders in several poses, straightness, the Gaussian filter
/// and harmonics. From a folder: NIST circle sets (`.ds`, `.fit`).
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
