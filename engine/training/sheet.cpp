#include "engine/training/sheet.h"

#include <algorithm>
#include <cmath>

#include "engine/core/random.h"
#include "engine/core/texts.h"
#include "engine/core/units.h"
#include "engine/report/cells.h"
#include "engine/report/quantity_table.h"

namespace lathelier::training {
namespace {

constexpr double mostPoints = 10;
constexpr int mostExercises = 100;
constexpr std::uint64_t testStream = 100;

/// "1980 – 2120", several separated by commas; the text of the choice if the answer is one.
Value expectedOf(const SheetRow& row)
{
    std::string all;
    for (const Interval& range : row.grade.expected) {
        if (!row.exercise.choices.empty()) return row.exercise.choices.at(static_cast<std::size_t>(range.from));
        if (!all.empty()) all += "; ";
        all += fixed(range.from, row.exercise.decimals);
        if (range.to > range.from) all.append(" … ").append(fixed(range.to, row.exercise.decimals));
    }
    return all;
}

Value answerOf(const SheetRow& row)
{
    const double answer = row.answered.answer;
    if (!std::isfinite(answer)) return {};
    if (row.exercise.choices.empty()) return fixed(answer, row.exercise.decimals);
    const bool is_choice = answer >= 0 && answer < static_cast<double>(row.exercise.choices.size());
    return is_choice ? Value(row.exercise.choices[static_cast<std::size_t>(answer)]) : Value();
}

const FieldChoice& choiceOf(ExerciseKind kind)
{
    return exerciseChoices().at(static_cast<std::size_t>(kind));
}

void count(PupilTotal& total, const SheetRow& row)
{
    ++total.answers;
    total.correct += row.grade.correct ? 1 : 0;
    total.points += row.grade.points;
    total.most_points += mostPoints;
    if (std::isfinite(row.answered.needed_s)) total.needed_s += row.answered.needed_s;
}

}  // namespace

std::vector<Exercise> makeTest(std::uint32_t seed, int count)
{
    std::vector<Exercise> test;
    const int wanted = std::clamp(count, 0, mostExercises);
    test.reserve(static_cast<std::size_t>(wanted));
    const auto kinds = static_cast<int>(exerciseChoices().size());
    for (int i = 0; i < wanted; ++i) {
        const std::uint64_t bits = randomBits(seed, testStream, static_cast<std::uint64_t>(i));
        test.push_back(makeExercise(static_cast<ExerciseKind>(i % kinds), static_cast<std::uint32_t>(bits >> 32)));
    }
    return test;
}

Sheet sheetOf(std::span<const Answered> answers, const Progress& progress)
{
    Sheet sheet;
    sheet.rows.reserve(answers.size());
    for (const Answered& answered : answers) {
        progress.report(static_cast<double>(sheet.rows.size()) / static_cast<double>(answers.size()));
        SheetRow row{answered, makeExercise(answered.kind, answered.seed), {}};
        row.grade = grade(row.exercise, answered.answer, progress.quiet());
        auto total = std::find_if(sheet.totals.begin(), sheet.totals.end(),
                                  [&](const PupilTotal& t) { return t.pupil == answered.pupil; });
        if (total == sheet.totals.end()) {
            sheet.totals.emplace_back().pupil = answered.pupil;
            total = std::prev(sheet.totals.end());
        }
        count(*total, row);
        count(sheet.whole, row);
        sheet.rows.push_back(std::move(row));
    }
    progress.report(1);
    return sheet;
}

const std::vector<QuantityOf<SheetRow>>& quantitiesOf(const SheetRow*)
{
    using R = SheetRow;
    static const auto all = describedBy<R>(
        quantity<R>("pupil", [](const R& r) { return r.answered.pupil; }, {LT_TEXT("Engine", "Pupil")}),
        quantity<R>("exercise", [](const R& r) { return choiceOf(r.answered.kind).key; }),
        quantity<R>("exercise_name", [](const R& r) { return choiceOf(r.answered.kind).label; },
                    {LT_TEXT("Engine", "Exercise"), {}, 0, false}),
        quantity<R>("seed", [](const R& r) { return r.answered.seed; }, {LT_TEXT("Engine", "Number"), {}, 0}),
        quantity<R>("answer", [](const R& r) { return r.answered.answer; }),
        quantity<R>("answer_words", &answerOf, {LT_TEXT("Engine", "Answer"), {}, 0, false}),
        quantity<R>("expected_words", &expectedOf, {LT_TEXT("Engine", "Right"), {}, 0, false}),
        quantity<R>("unit", [](const R& r) { return r.exercise.unit; }, {LT_TEXT("Engine", "Unit"), {}, 0, false}),
        quantity<R>("correct", [](const R& r) { return r.grade.correct; }),
        quantity<R>("points", [](const R& r) { return r.grade.points; }, {LT_TEXT("Engine", "Points"), {}, 0}),
        quantity<R>("needed_s", [](const R& r) { return r.answered.needed_s; },
                    {LT_TEXT("Engine", "Time"), unit::s, 0}));
    return all;
}

const std::vector<QuantityOf<PupilTotal>>& quantitiesOf(const PupilTotal*)
{
    using T = PupilTotal;
    static const auto all =
        describedBy<T>(quantity<T>("pupil", &T::pupil, {LT_TEXT("Engine", "Pupil")}),
                       quantity<T>("answers", &T::answers, {LT_TEXT("Engine", "Answers"), {}, 0}),
                       quantity<T>("correct", &T::correct, {LT_TEXT("Engine", "Correct"), {}, 0}),
                       quantity<T>("points", &T::points, {LT_TEXT("Engine", "Points"), {}, 0}),
                       quantity<T>("most_points", &T::most_points, {LT_TEXT("Engine", "Most points"), {}, 0}),
                       quantity<T>("needed_s", &T::needed_s, {LT_TEXT("Engine", "Time"), unit::s, 0}));
    return all;
}

std::string sheetCsv(const Sheet& sheet)
{
    return report::csvOf(
        std::span<const SheetRow>(sheet.rows),
        {"pupil", "exercise", "seed", "answer", {"expected_words", "expected"}, "correct", "points", "needed_s"});
}

report::Document sheetReport(const Sheet& sheet)
{
    report::Document document;
    document.title = LT_TEXT("Engine", "Training: results");
    report::Section totals{LT_TEXT("Engine", "Points"), {}};
    totals.blocks.push_back(report::quantityTable(LT_TEXT("Engine", "All answers"), sheet.whole,
                                                  {"answers", "correct", "points", "most_points"}));
    totals.blocks.push_back(report::listTable(LT_TEXT("Engine", "By pupil"), std::span<const PupilTotal>(sheet.totals),
                                              {"pupil", "answers", "correct", "points", "most_points", "needed_s"}));
    document.sections.push_back(std::move(totals));
    document.sections.push_back(
        {LT_TEXT("Engine", "Answers"),
         {report::listTable(
              LT_TEXT("Engine", "By exercise"), std::span<const SheetRow>(sheet.rows),
              {"pupil", "exercise_name", "seed", "answer_words", "expected_words", "unit", "points", "needed_s"}),
          report::Paragraph{LT_TEXT("Engine",
                                    "Every exercise follows from its kind and number alone: the same number gives the "
                                    "same exercise, which was graded again for this sheet."),
                            {}}}});
    return document;
}

}  // namespace lathelier::training
