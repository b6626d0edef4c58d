#include "engine/series/series_question.h"

namespace lathelier::series {
namespace {

constexpr double mostValues = 100000;

}  // namespace

const std::vector<Field<SeriesQuestion>>& fieldsOf(const SeriesQuestion*)
{
    using Q = SeriesQuestion;
    static const std::vector<Field<Q>> all = [] {
        std::vector<Field<Q>> made{
            field(
                databaseKey, &Q::database,
                Label{LT_TEXT("Engine", "Database"),
                      LT_TEXT("Engine", "Of the archive where it is no file: postgresql://HOST/NAME, service=NAME.")}),
            field(characteristicKey, &Q::characteristic,
                  Label{LT_TEXT("Engine", "Characteristic"),
                        LT_TEXT("Engine", "Its key, such as zones.seat.mean_mm; empty: the answer of the task.")}),
            field(taskKey, &Q::task,
                  Label{LT_TEXT("Engine", "Task"),
                        LT_TEXT("Engine",
                                "Of which the characteristic is: compare, roundness…; empty: that of the latest "
                                "evaluation.")}),
            field("from", &Q::from,
                  Label{LT_TEXT("Engine", "From"), LT_TEXT("Engine", "First date, such as 2026-11-29.")}),
            field("to", &Q::to, Label{LT_TEXT("Engine", "To"), LT_TEXT("Engine", "Last date, included.")}),
            field("most", &Q::most, Range{1, mostValues},
                  Label{LT_TEXT("Engine", "Most values"), LT_TEXT("Engine", "The latest so many.")}),
            field(
                "recipe", &Q::recipe,
                Label{LT_TEXT("Engine", "Recipe"), LT_TEXT("Engine", "SHA-256 of the recipe; empty: any."), {}, true}),
            field(partKey, &Q::part,
                  Label{LT_TEXT("Engine", "Part"),
                        LT_TEXT("Engine",
                                "Shown in detail: the UUID of its evaluation, or its beginning; empty: the "
                                "latest."),
                        {},
                        true})};
        made.back().info.is_kept = true;
        return made;
    }();
    return all;
}

}  // namespace lathelier::series
