#include "engine/surface/surface_quantities.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/core/units.h"

namespace lathelier::surface {

const std::vector<QuantityOf<FeedMarks>>& quantitiesOf(const FeedMarks*)
{
    using R = FeedMarks;
    static const std::vector<QuantityOf<R>> all{
        quantity<R>("pitch_mm", &R::pitch_mm, {LT_TEXT("Engine", "Pitch"), unit::mm, 4}),
        quantity<R>("pitch_px", &R::pitch_px, {LT_TEXT("Engine", "Pitch in the picture"), LT_TEXT("Engine", "px"), 2}),
        quantity<R>("pitch_error_percent", &R::pitch_error_percent,
                    {LT_TEXT("Engine", "Pitch against the feed"), unit::percent, 2}),
        quantity<R>("direction_deg", &R::direction_deg,
                    {LT_TEXT("Engine", "Direction across the marks"), unit::deg, 2}),
        quantity<R>("significance", &R::significance, {LT_TEXT("Engine", "Significance"), {}, 0}),
        quantity<R>("amplitude", &R::amplitude),
        quantity<R>("regularity", &R::regularity, {LT_TEXT("Engine", "Regularity"), {}, 2}),
        quantity<R>("share_percent", &R::share_percent,
                    {LT_TEXT("Engine", "Share of the picture's variance"), unit::percent, 0})};
    return all;
}

const std::vector<QuantityOf<ChatterMarks>>& quantitiesOf(const ChatterMarks*)
{
    using R = ChatterMarks;
    static const std::vector<QuantityOf<R>> all{
        quantity<R>("nu", &R::nu, {LT_TEXT("Engine", "Rest of a wave, ν"), {}, 4}),
        quantity<R>("m", &R::m, {LT_TEXT("Engine", "Whole waves in a revolution, m")}),
        quantity<R>("m_certain", &R::m_certain, {LT_TEXT("Engine", "The picture decides m")}),
        quantity<R>("phase_deg", &R::phase_deg, {LT_TEXT("Engine", "Phase of the regeneration, ε"), unit::deg, 1}),
        quantity<R>("axial_period_mm", &R::axial_period_mm, {LT_TEXT("Engine", "Period along the axis"), unit::mm, 3}),
        quantity<R>("circumferential_pitch_mm", &R::circumferential_pitch_mm,
                    {LT_TEXT("Engine", "Pitch round the part"), unit::mm, 2}),
        quantity<R>("inclination_deg", &R::inclination_deg, {LT_TEXT("Engine", "Crests to the axis"), unit::deg, 1}),
        quantity<R>("frequency_hz", &R::frequency_hz, {LT_TEXT("Engine", "Frequency"), unit::hz, 2}),
        quantity<R>("frequency_uncertainty_hz", &R::frequency_uncertainty_hz,
                    {LT_TEXT("Engine", "Standard uncertainty"), unit::hz, 2}),
        quantity<R>("candidates_hz", &R::candidates_hz, {LT_TEXT("Engine", "Candidates"), unit::hz, 2}),
        quantity<R>("harmonic_of_hz", &R::harmonic_of_hz,
                    {LT_TEXT("Engine", "In symmetric light perhaps"), unit::hz, 2}),
        quantity<R>("nearest_other_hz", &R::nearest_other_hz,
                    {LT_TEXT("Engine", "Distance of the next reading"), unit::hz, 1}),
        quantity<R>("amplitude", &R::amplitude),
        quantity<R>("relative_to_feed", &R::relative_to_feed,
                    {LT_TEXT("Engine", "Strength against the feed line"), {}, 2}),
        quantity<R>("significance", &R::significance, {LT_TEXT("Engine", "Significance"), {}, 0}),
        quantity<R>("regularity", &R::regularity, {LT_TEXT("Engine", "Regularity"), {}, 2}),
        quantity<R>("share_percent", &R::share_percent,
                    {LT_TEXT("Engine", "Share of the picture's variance"), unit::percent, 0}),
        quantity<R>("waves_measured", &R::waves_measured, {LT_TEXT("Engine", "m as measured"), {}, 2}),
        quantity<R>("waves_uncertainty", &R::waves_uncertainty,
                    {LT_TEXT("Engine", "Standard uncertainty of m as measured"), {}, 2}),
        quantity<R>("waves_in_view", &R::waves_in_view, {LT_TEXT("Engine", "Waves in the picture"), {}, 2}),
        quantity<R>("lines", &R::lines, {LT_TEXT("Engine", "Lines seen")}),
        quantity<R>("kind", [](const R& marks) { return std::string(key(marks.kind)); })};
    return all;
}

const std::vector<QuantityOf<ImageMarks>>& quantitiesOf(const ImageMarks*)
{
    using R = ImageMarks;
    static const std::vector<QuantityOf<R>> all = describedBy<R>(
        quantity<R>("path", &R::path),
        quantity<R>("width", &R::width, {LT_TEXT("Engine", "Width"), LT_TEXT("Engine", "px")}),
        quantity<R>("height", &R::height, {LT_TEXT("Engine", "Height"), LT_TEXT("Engine", "px")}),
        quantity<R>("bits", &R::bits, {LT_TEXT("Engine", "Bits of a sample")}),
        quantity<R>("orientation", &R::orientation_applied),
        quantity<R>("orientation_applied", [](const R& marks) { return marks.orientation_applied != 1; }),
        quantity<R>("mm_per_px", &R::mm_per_px, {LT_TEXT("Engine", "Scale"), LT_TEXT("Engine", "mm/px"), 5}),
        quantity<R>("mm_per_px_source", [](const R& marks) { return std::string(key(marks.mm_per_px_source)); }),
        quantity<R>("speed_rpm", &R::speed_rpm, {LT_TEXT("Engine", "Spindle speed"), LT_TEXT("Engine", "rpm"), 0}),
        quantity<R>("saturated_percent", &R::saturated_percent,
                    {LT_TEXT("Engine", "Saturated pixels"), unit::percent, 2}),
        quantity<R>("feed_direction_deg", &R::feed_direction_deg,
                    {LT_TEXT("Engine", "Direction of feed"), unit::deg, 1}),
        quantity<R>("unrolled", &R::unrolled, {LT_TEXT("Engine", "Cylinder unrolled")}),
        quantity<R>("curved", &R::curved, {LT_TEXT("Engine", "Curved and not unrolled")}),
        quantity<R>("threshold", &R::threshold, {LT_TEXT("Engine", "Threshold of significance"), {}, 1}),
        quantity<R>("largest_significance", &R::largest_significance,
                    {LT_TEXT("Engine", "Largest significance"), {}, 1}),
        part<R>("feed_marks", &R::feed_marks), part<R>("second_feed_marks", &R::second_feed_marks),
        part<R>("chatter_marks", &R::chatter_marks),
        quantity<R>("detection_limit_relative_to_feed", &R::detection_limit_relative_to_feed,
                    {LT_TEXT("Engine", "Chatter would be seen from"), {}, 3}),
        quantity<R>("verdict", [](const R& marks) { return std::string(key(marks.verdict)); }));
    return all;
}

const std::vector<QuantityOf<SurfaceComparison>>& quantitiesOf(const SurfaceComparison*)
{
    using R = SurfaceComparison;
    static const std::vector<QuantityOf<R>> all{
        quantity<R>("same_scale", &R::same_scale, {LT_TEXT("Engine", "Scales are known")}),
        quantity<R>("registration_response", &R::registration_response,
                    {LT_TEXT("Engine", "Response of the registration"), {}, 2}),
        quantity<R>("registered", &R::registered, {LT_TEXT("Engine", "One surface in both")}),
        quantity<R>("shift_px",
                    [](const R& comparison) {
                        return std::vector<double>{comparison.shift.x, comparison.shift.y};
                    }),
        quantity<R>("relative_to_feed", [](const R& comparison) {
            std::vector<double> values;
            for (const auto& value : comparison.relative_to_feed) values.push_back(value.value_or(NAN));
            return values;
        })};
    return all;
}

Json toJson(const SurfaceResult& result)
{
    Json json{{"images", Json::array()}};
    for (const ImageMarks& image : result.images) json["images"].push_back(nestedJson(describedValues(image)));
    json["comparison"] = result.comparison ? nestedJson(describedValues(*result.comparison)) : Json();
    return json;
}

}  // namespace lathelier::surface
