#include "widgets/surface/surface_question.h"

#include "engine/core/field_within.h"

namespace lathelier::surface_panel {
namespace {

constexpr int fieldWidth_px = 560, fieldHeight_px = 420;  // of a small field
constexpr int wholeWidth_px = 420, wholeHeight_px = 900;  // of the whole width of the part
constexpr double wholeShare = 0.88;                       // of the diameter, in such a picture

}  // namespace

surface::SyntheticParameters demonstration()
{
    surface::SyntheticParameters p;
    p.cylinder = true;
    p.feed_mm_rev = 0.2;
    p.nose_radius_mm = 0.8;
    p.amplitude_um = 18;
    p.cut = surface::CutDirection::Down;
    p.width = fieldWidth_px;
    p.height = fieldHeight_px;
    p.stamped = true;
    return p;
}

const std::vector<Field<SurfaceQuestion>>& fieldsOf(const SurfaceQuestion*)
{
    using Q = SurfaceQuestion;
    const Text rpm = LT_TEXT("Engine", "rpm");
    static const std::vector<Field<Q>> all = described<Q>(
        within(&Q::surface, "feed_mm_rev"), within(&Q::surface, "diameter_mm"),
        field(
            "speed_before_rpm", &Q::speed_before_rpm, Range{1, 100000},
            Label{LT_TEXT("Engine", "Spindle speed"), LT_TEXT("Engine", "That the first surface was cut with."), rpm}),
        field("speed_after_rpm", &Q::speed_after_rpm, Range{1, 100000},
              Label{LT_TEXT("Engine", "Speed after"),
                    LT_TEXT("Engine", "That the second surface was cut with; none: as the first."), rpm}),
        within(&Q::surface, "mm_per_px"), within(&Q::surface, "scale_px_mm"), within(&Q::surface, "scale_from_feed"),
        within(&Q::surface, "feed_direction_deg"), within(&Q::surface, "cut_direction"), within(&Q::surface, "unroll"),
        within(&Q::surface, "expect_hz"),
        field(makeKey, &Q::make_picture,
              Label{LT_TEXT("Engine", "Make a picture"),
                    LT_TEXT("Engine",
                            "For training: a picture is made from physics, with sliders, in place of the "
                            "files.")}),
        within(&Q::surface, "axis_px"), foldedWithin(&Q::surface, "roi"), within(&Q::surface, "alpha"),
        within(&Q::surface, "speed_uncertainty_percent"),
        group("made", &Q::made, Label{LT_TEXT("Engine", "Picture that is made"), {}}));
    return all;
}

bool makesPicture(const Values& parameters)
{
    const Value* const make = find(parameters, makeKey);
    const bool* const is_made = make ? std::get_if<bool>(make) : nullptr;
    return is_made && *is_made;
}

surface::SurfaceParameters parametersOf(const SurfaceQuestion& question, std::size_t pictures)
{
    surface::SurfaceParameters p = question.surface;
    p.speed_rpm.clear();
    if (question.make_picture) {
        const surface::SyntheticParameters made = pictureOf(question);
        p.feed_mm_rev = made.feed_mm_rev;
        p.diameter_mm = made.diameter_mm;
        p.speed_rpm = {{made.speed_rpm}};
        p.mm_per_px = made.mm_per_px;
        p.scale_px_mm.clear();
        p.scale_from_feed = false;
        p.feed_direction_deg = made.feed_direction_deg;
        p.cut_direction = made.cut;
        p.axis_px.reset();
        p.roi.clear();
        return p;
    }
    if (question.speed_before_rpm) p.speed_rpm.push_back({*question.speed_before_rpm});
    if (pictures > 1 && question.speed_after_rpm) {
        if (p.speed_rpm.empty()) p.speed_rpm.push_back({*question.speed_after_rpm});
        p.speed_rpm.push_back({*question.speed_after_rpm});
    }
    if (p.roi.size() > pictures) p.roi.resize(pictures);
    return p;
}

surface::SyntheticParameters pictureOf(const SurfaceQuestion& question)
{
    surface::SyntheticParameters p = question.made;
    if (!p.cylinder) return p;
    p.width = wholeWidth_px;
    p.height = wholeHeight_px;
    p.mm_per_px = wholeShare * p.diameter_mm / p.height;
    return p;
}

}  // namespace lathelier::surface_panel
