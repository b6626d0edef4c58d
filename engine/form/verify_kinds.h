// The kinds of verify(), one function each.
#pragma once

#include <cmath>
#include <optional>

#include "engine/form/verify.h"

namespace lathelier::form {

/// Gathers the deviations of one kind.
class VerifyTally {
public:
    VerifyTally(std::string kind, Text name, Text unit, double limit)
    {
        kind_.kind = std::move(kind);
        kind_.name = name;
        kind_.unit = unit;
        kind_.limit = limit;
    }
    void nextSet() { ++kind_.sets; }
    void compare(double found, double expected) { take(std::abs(found - expected)); }
    void take(double deviation)
    {
        // Once it is no number it stays so, and fails.
        if (std::isnan(kind_.largest_deviation)) return;
        if (!(deviation <= kind_.largest_deviation)) kind_.largest_deviation = deviation;
    }
    VerifyKind done()
    {
        kind_.pass = kind_.sets > 0 && kind_.largest_deviation <= kind_.limit;
        return kind_;
    }

private:
    VerifyKind kind_;
};

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
/// Errors: fileNotFound, notAFile, fileNotReadable, malformed, referenceDataMissing.
VerifyKind verifyNistCircles(const std::string& directory, const Progress& progress);

}  // namespace lathelier::form
