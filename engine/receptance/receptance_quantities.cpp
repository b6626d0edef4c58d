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
    static const auto all = describedBy<R>(
        quantity<R>("frequency_hz", &R::frequency_hz), quantity<R>("condition", &R::condition),
        quantity<R>("residual_rms_percent", &R::residual_rms_percent),
        quantity<R>("hold_out_rms_percent", &R::hold_out_rms_percent),
        quantity<R>("expected_rms_percent", &R::expected_rms_percent), quantity<R>("chi2_per_dof", &R::chi2_per_dof),
        quantity<R>("noise_from", [](const R& r) { return key(r.noise_from); }), quantity<R>("frfs", &R::frfs));
    return all;
}

const std::vector<QuantityOf<CheckedResponse>>& quantitiesOf(const CheckedResponse*)
{
    using R = CheckedResponse;
    static const auto all =
        describedBy<R>(quantity<R>("rod", [](const R& r) { return r.rod + 1; }, {LT_TEXT("Engine", "Rod"), {}, 0}),
                       quantity<R>("respond", &R::respond, {LT_TEXT("Engine", "Response node"), {}, 0}),
                       quantity<R>("excite", &R::excite, {LT_TEXT("Engine", "Force node"), {}, 0}),
                       quantity<R>("used", &R::used, {LT_TEXT("Engine", "Used"), {}, 0}),
                       quantity<R>("rms_percent", &R::rms_percent, {LT_TEXT("Engine", "Residual"), unit::percent, 2}),
                       quantity<R>("chi2_per_dof", &R::chi2_per_dof, {LT_TEXT("Engine", "χ² per degree"), {}, 2}));
    return all;
}

}  // namespace lathelier::receptance
