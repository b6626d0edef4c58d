#include "engine/receptance/receptance_quantities.h"

#include "engine/core/units.h"

namespace lathelier::receptance {
namespace {

std::vector<double> realParts(const ShaftReceptanceResult& result)
{
    std::vector<double> parts;
    for (const Complex& value : result.frf.value) parts.push_back(value.real());
    return parts;
}

std::vector<double> imaginaryParts(const ShaftReceptanceResult& result)
{
    std::vector<double> parts;
    for (const Complex& value : result.frf.value) parts.push_back(value.imag());
    return parts;
}

}  // namespace

const std::vector<QuantityOf<ShaftReceptanceResult>>& quantitiesOf(const ShaftReceptanceResult*)
{
    using R = ShaftReceptanceResult;
    static const auto all = describedBy<R>(
        quantity<R>("length_mm", &R::length_mm, {LT_TEXT("Engine", "Length"), unit::mm}),
        quantity<R>("natural_frequencies_hz", &R::natural_frequencies_hz,
                    {LT_TEXT("Engine", "Natural frequencies"), unit::hz, 2}),
        quantity<R>("receptance.frequency_hz", [](const R& r) { return r.frf.frequency_hz; }),
        quantity<R>("receptance.real_mm_N", realParts), quantity<R>("receptance.imag_mm_N", imaginaryParts));
    return all;
}

const std::vector<QuantityOf<SpindleIdentification>>& quantitiesOf(const SpindleIdentification*)
{
    using R = SpindleIdentification;
    static const auto all =
        describedBy<R>(quantity<R>("frequency_hz", &R::frequency_hz), quantity<R>("condition", &R::condition),
                       quantity<R>("residual_rms_percent", &R::residual_rms_percent),
                       quantity<R>("hold_out_rms_percent", &R::hold_out_rms_percent), quantity<R>("frfs", &R::frfs));
    return all;
}

}  // namespace lathelier::receptance
