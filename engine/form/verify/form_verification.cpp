#include "engine/form/verify/form_verification.h"

namespace lathelier::form {
namespace {

template <VerifyKind (*check)()>
VerifyKind quick(const Progress&)
{
    return check();
}

}  // namespace

const VerifyPart& formVerification()
{
    static const VerifyPart part{
        "form",
        {quick<verifyLeastSquaresCircles>, quick<verifyMinimumZoneCircles>, quick<verifyInscribedCircles>,
         quick<verifyCircumscribedCircles>, verifyScatteredZones, verifyCertificates, verifyLeastSquaresCylinders,
         verifyMinimumZoneCylinders, quick<verifyStraightness>, quick<verifyGaussianFilter>, quick<verifyHarmonics>},
        verifyNistCircles};
    return part;
}

}  // namespace lathelier::form
