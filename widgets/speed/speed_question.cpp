#include "widgets/speed/speed_question.h"

#include "engine/core/field_within.h"
#include "engine/core/units.h"

namespace lathelier::speed_panel {
namespace {

constexpr Range speeds{1e-3, 1e5};

}  // namespace

const std::vector<Field<SpeedQuestion>>& fieldsOf(const SpeedQuestion*)
{
    using Q = SpeedQuestion;
    static const auto all = [] {
        auto described = lathelier::described<Q>(
            within(&Q::speed, diameterKey),
            field(lengthKey, &Q::length_mm, Range{1e-3, 1e5},
                  Label{LT_TEXT("Engine", "Overhang L"),
                        LT_TEXT("Engine", "Of the bar from the chuck to its free end; a shaft given takes its place."),
                        unit::mm}),
            within(&Q::speed, cuttingSpeedKey),
            field(lowestKey, &Q::lowest_m_min, speeds,
                  Label{LT_TEXT("Engine", "Least cutting speed"), LT_TEXT("Engine", "That the tool allows."),
                        unit::m_min}),
            field(highestKey, &Q::highest_m_min, speeds,
                  Label{LT_TEXT("Engine", "Greatest cutting speed"), LT_TEXT("Engine", "That the tool allows."),
                        unit::m_min}),
            within(&Q::speed, "rule"), foldedWithin(&Q::speed, "relation"), foldedWithin(&Q::speed, "peak_shift"),
            group("material", &Q::material,
                  Label{LT_TEXT("Engine", "Material of the bar"), LT_TEXT("Engine", "Without it steel is assumed.")}));
        for (Field<Q>& one : described)
            if (one.info.key.starts_with("material")) one.info.advanced = true;
        return described;
    }();
    return all;
}

std::vector<Interval> rangeOf(const SpeedQuestion& question)
{
    if (!question.lowest_m_min && !question.highest_m_min) return {};
    return {{question.lowest_m_min.value_or(speeds.minimum), question.highest_m_min.value_or(speeds.maximum)}};
}

}  // namespace lathelier::speed_panel
