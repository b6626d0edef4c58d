#include "engine/form/verify.h"

#include <algorithm>
#include <functional>

#include "engine/form/verify_kinds.h"

namespace lathelier::form {

VerifyResult verify(const std::string& reference_data, const Progress& progress)
{
    VerifyResult result;
    const std::vector<std::function<VerifyKind()>> checks{
        verifyLeastSquaresCircles,
        verifyMinimumZoneCircles,
        verifyInscribedCircles,
        verifyCircumscribedCircles,
        [&] { return verifyScatteredZones(progress); },
        [&] { return verifyCertificates(progress); },
        [&] { return verifyLeastSquaresCylinders(progress); },
        [&] { return verifyMinimumZoneCylinders(progress); },
        verifyStraightness,
        verifyGaussianFilter,
        verifyHarmonics,
    };
    for (std::size_t i = 0; i < checks.size(); ++i) {
        progress.report(static_cast<double>(i) / static_cast<double>(checks.size() + 1));
        result.kinds.push_back(checks[i]());
    }
    result.reference_data = reference_data;
    if (!reference_data.empty()) result.kinds.push_back(verifyNistCircles(reference_data, progress));
    result.pass = std::all_of(result.kinds.begin(), result.kinds.end(), [](const VerifyKind& k) { return k.pass; });
    progress.report(1);
    return result;
}

}  // namespace lathelier::form
