#include "engine/surface/task/surface_question.h"

#include "engine/core/field_within.h"
#include "engine/core/units.h"
#include "engine/surface/quiz.h"

namespace lathelier::surface {
namespace {

constexpr int fieldWidth_px = 560, fieldHeight_px = 420;  // of a small field
constexpr int wholeWidth_px = 420, wholeHeight_px = 900;  // of the whole width of the part
constexpr double wholeShare = 0.88;                       // of the diameter, in such a picture

bool isSet(const Values& parameters, const char* key, bool otherwise)
{
    const Value* const value = find(parameters, key);
    const bool* const there = value ? std::get_if<bool>(value) : nullptr;
    return there ? *there : otherwise;
}

/// What the evaluation does not have is kept in a window.
std::vector<Field<SurfaceQuestion>> withKept(std::vector<Field<SurfaceQuestion>> all)
{
    const Values evaluated = toValues(SurfaceParameters{});
    for (Field<SurfaceQuestion>& field : all) field.info.is_kept = !find(evaluated, field.info.key);
    return all;
}

}  // namespace

SyntheticParameters demonstration()
{
    SyntheticParameters p;
    p.cylinder = true;
    p.feed_mm_rev = 0.2;
    p.nose_radius_mm = 0.8;
    p.amplitude_um = 18;
    p.cut = CutDirection::Down;
    p.width = fieldWidth_px;
    p.height = fieldHeight_px;
    p.stamped = true;
    return p;
}

const std::vector<Field<SurfaceQuestion>>& fieldsOf(const SurfaceQuestion*)
{
    using Q = SurfaceQuestion;
    const Text rpm = LT_TEXT("Engine", "rpm");
    static const std::vector<Field<Q>> all = withKept(described<Q>(
        within(&Q::surface, "feed_mm_rev"), within(&Q::surface, "diameter_mm"), within(&Q::surface, "speed_rpm"),
        within(&Q::surface, "mm_per_px"), within(&Q::surface, "scale_px_mm"), within(&Q::surface, "scale_from_feed"),
        within(&Q::surface, "scale_from_file"), within(&Q::surface, "unroll"), within(&Q::surface, "axis_px"),
        within(&Q::surface, "roi"), within(&Q::surface, "feed_direction_deg"), within(&Q::surface, "cut_direction"),
        within(&Q::surface, "expect_hz"), within(&Q::surface, "alpha"),
        within(&Q::surface, "speed_uncertainty_percent"),
        field(speedBeforeKey, &Q::speed_before_rpm, Range{1, 100000},
              Label{LT_TEXT("Engine", "Spindle speed"),
                    LT_TEXT("Engine", "That the first surface was cut with; none: not known."), rpm}),
        field(speedAfterKey, &Q::speed_after_rpm, Range{1, 100000},
              Label{LT_TEXT("Engine", "Speed after"),
                    LT_TEXT("Engine", "That the second surface was cut with; none: as the first."), rpm}),
        field(spareRegionsKey, &Q::spare_regions,
              Label{LT_TEXT("Engine", "Regions kept"),
                    LT_TEXT("Engine", "Those of pictures that were taken away are not used.")}),
        field("lighting", &Q::lighting,
              Label{LT_TEXT("Engine", "Light"),
                    LT_TEXT("Engine",
                            "Where the light came from, for the report. Pictures are compared as if it had been the "
                            "same.")}),
        field("taken_alike", &Q::taken_alike,
              Label{LT_TEXT("Engine", "Both pictures taken alike"),
                    LT_TEXT("Engine", "One scale and one direction of feed for both.")}),
        field("after_mm_per_px", &Q::after_mm_per_px, Range{1e-6, 100},
              Label{LT_TEXT("Engine", "Scale after"),
                    LT_TEXT("Engine", "Of the second picture, where it was taken otherwise; none: as the first."),
                    LT_TEXT("Engine", "mm/px"), true}),
        field("after_feed_direction_deg", &Q::after_feed_direction_deg, Range{-360, 360},
              Label{LT_TEXT("Engine", "Direction of feed after"),
                    LT_TEXT("Engine", "In the second picture, where it was taken otherwise; none: as in the first."),
                    unit::deg, true}),
        field(layRightKey, &Q::lay_right_px, Range{-4096, 4096},
              Label{LT_TEXT("Engine", "Second picture to the right"),
                    LT_TEXT("Engine", "By two clicks on one place in both, in pixels of the comparison."),
                    LT_TEXT("Engine", "px"), true}),
        field(layDownKey, &Q::lay_down_px, Range{-4096, 4096},
              Label{LT_TEXT("Engine", "Second picture down"),
                    LT_TEXT("Engine", "By two clicks on one place in both, in pixels of the comparison."),
                    LT_TEXT("Engine", "px"), true}),
        field(makeKey, &Q::make_picture,
              Label{LT_TEXT("Engine", "Make a picture"),
                    LT_TEXT("Engine",
                            "For training: a picture is made from physics, with sliders, in place of the "
                            "files.")}),
        group("made", &Q::made, Label{LT_TEXT("Engine", "Picture that is made"), {}}),
        field(quizKey, &Q::quiz,
              Label{LT_TEXT("Engine", "Question"), LT_TEXT("Engine", "The picture's vibration is to be found.")}),
        field(quizNumberKey, &Q::quiz_number, Range{1, 1000000},
              Label{LT_TEXT("Engine", "Number of the question"),
                    LT_TEXT("Engine", "Another number is another picture.")}),
        field(quizAnswerKey, &Q::quiz_answer_hz, Range{0.1, 100000},
              Label{LT_TEXT("Engine", "Answer"), LT_TEXT("Engine", "Frequency that was read off the picture."),
                    unit::hz})));
    return all;
}

bool isAsking(const SurfaceQuestion& question)
{
    return question.make_picture && question.quiz && !question.quiz_answer_hz;
}

void applyOwnScale(NamedImage& after, const SurfaceQuestion& question)
{
    if (question.taken_alike) return;
    after.mm_per_px = question.after_mm_per_px;
    after.feed_direction_deg = question.after_feed_direction_deg;
}

bool makesPicture(const Values& parameters)
{
    return isSet(parameters, makeKey, false);
}

bool areTakenAlike(const Values& parameters)
{
    return isSet(parameters, "taken_alike", true);
}

SurfaceParameters parametersOf(const SurfaceQuestion& question, std::size_t pictures)
{
    SurfaceParameters p = question.surface;
    if (question.make_picture) {
        const SyntheticParameters made = pictureOf(question);
        p.feed_mm_rev = made.feed_mm_rev;
        p.diameter_mm = made.diameter_mm;
        p.speed_rpm = {{made.speed_rpm}};
        p.mm_per_px = made.mm_per_px;
        p.scale_px_mm.clear();
        p.scale_from_feed = false;
        p.scale_from_file = false;
        p.feed_direction_deg = made.feed_direction_deg;
        p.cut_direction = made.cut;
        p.axis_px.reset();
        p.roi.clear();
        return p;
    }
    const bool after = pictures > 1 && question.speed_after_rpm;
    if (question.speed_before_rpm || after) p.speed_rpm = {{question.speed_before_rpm.value_or(0)}};
    if (after) p.speed_rpm.push_back({*question.speed_after_rpm});
    if (question.spare_regions && p.roi.size() > pictures) p.roi.resize(pictures);
    return p;
}

Values statedValues(const SurfaceQuestion& question, std::size_t pictures, Values parameters)
{
    for (const auto& [key, value] : toValues(parametersOf(question, pictures))) set(parameters, key, value);
    std::erase_if(parameters, [](const auto& one) {
        return one.first == speedBeforeKey || one.first == speedAfterKey || one.first == spareRegionsKey;
    });
    return parameters;
}

SyntheticParameters pictureOf(const SurfaceQuestion& question)
{
    SyntheticParameters p = question.made;
    if (question.quiz) {
        p.cylinder = true;
        p = quizPicture(question.quiz_number, p);
    }
    if (!p.cylinder) return p;
    p.width = wholeWidth_px;
    p.height = wholeHeight_px;
    p.mm_per_px = wholeShare * p.diameter_mm / p.height;
    return p;
}

}  // namespace lathelier::surface
