#include <utility>

#include "engine/core/field_within.h"
#include "engine/form/roundness/no_filter.h"
#include "engine/trajectory/task/roundness_task.h"

namespace lathelier::trajectory {
namespace {

using Q = RoundnessQuestion;

Field<Q> sectionField()
{
    FieldInfo info;
    info.key = sectionKey;
    info.kind = FieldInfo::Kind::Integer;
    info.label = LT_TEXT("Engine", "Section");
    info.help = LT_TEXT("Engine", "Number of the section of the record; without it the one that deviates most.");
    info.minimum = 0;
    info.maximum = 1e9;
    info.optional = true;
    return {info, [](const Q& q) -> Value { return q.section ? Value(std::int64_t{*q.section}) : Value(); },
            [](Q& q, const Value& value) {
                const auto* const number = std::get_if<std::int64_t>(&value);
                q.section = number ? std::optional(static_cast<int>(*number)) : std::nullopt;
            }};
}

}  // namespace

const std::vector<Field<Q>>& fieldsOf(const Q*)
{
    static const auto all = [] {
        std::vector<Field<Q>> made{form::noFilterField(&Q::no_filter)};
        for (const FieldInfo& info : infos<form::RoundnessParameters>()) made.push_back(within(&Q::form, info.key));
        made.push_back(
            field("mirrored", &Q::mirrored,
                  Label{LT_TEXT("Engine", "Mirrored"), LT_TEXT("Engine", "Superimpose also the other way round.")}));
        made.push_back(sectionField());
        const Values of_form = toValues(form::RoundnessParameters{});
        for (const FieldInfo& info : infos<TrajectoryParameters>())
            if (!find(of_form, info.key)) made.push_back(within(&Q::record, info.key));
        return made;
    }();
    return all;
}

TrajectoryParameters RoundnessQuestion::ofRecord() const
{
    TrajectoryParameters all = record;
    all.form = form;
    all.outliers = std::exchange(all.form.outliers, form::OutlierRule::None);
    return all;
}

}  // namespace lathelier::trajectory
