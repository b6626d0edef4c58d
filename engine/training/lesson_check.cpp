#include "engine/training/lesson_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/training/lesson.h"

namespace lathelier::training {
namespace {

std::vector<std::string> keysOf(const std::vector<FieldChoice>& choices)
{
    std::vector<std::string> keys;
    keys.reserve(choices.size());
    for (const FieldChoice& choice : choices) keys.push_back(choice.key);
    return keys;
}

/// A number of the state; NaN where it is unknown.
double numberOf(const std::string& key, const LessonState& state)
{
    const QuantityOf<LessonState>* quantity = findQuantity(key);
    if (!quantity) return LessonState::unknown;
    const Value value = quantity->get(state);
    const double* number = std::get_if<double>(&value);
    return number ? *number : LessonState::unknown;
}

bool isMetByWord(const Check& check, const std::string& word)
{
    if (check.comparison == Comparison::Equal) return word == check.word;
    return check.comparison == Comparison::Different && word != check.word;
}

}  // namespace

const QuantityOf<LessonState>* findQuantity(std::string_view key)
{
    const auto& all = quantities<LessonState>();
    const auto found = std::find_if(all.begin(), all.end(), [key](const auto& q) { return q.info.key == key; });
    return found == all.end() ? nullptr : &*found;
}

std::vector<std::string> wordsOf(std::string_view quantity)
{
    if (quantity == "verdict") return {"stable", "chatter", "undecided"};
    if (quantity == "relation") return keysOf(relationChoices());
    if (quantity == "view") return keysOf(viewChoices());
    if (quantity != "scenario") return {};
    std::vector<std::string> keys;
    keys.reserve(scenarios().size() + 1);
    for (const Scenario& scenario : scenarios()) keys.push_back(scenario.key);
    keys.emplace_back(ownScenario);
    return keys;
}

const std::vector<std::string>& comparisonSigns()
{
    static const std::vector<std::string> all{"<", "<=", ">", ">=", "=", "!="};
    return all;
}

bool isMet(const Check& check, const LessonState& state)
{
    const QuantityOf<LessonState>* quantity = findQuantity(check.quantity);
    if (!quantity) return false;
    const Value value = quantity->get(state);
    if (const std::string* word = std::get_if<std::string>(&value)) return isMetByWord(check, *word);
    const double left = numberOf(check.quantity, state);
    const double right = check.other.empty() ? check.number : check.number * numberOf(check.other, state);
    if (std::isnan(left) || std::isnan(right)) return false;
    const bool equal = left == right || std::abs(left - right) <= 0.5 * std::pow(10.0, -quantity->info.decimals);
    switch (check.comparison) {
        case Comparison::Less: return left < right;
        case Comparison::AtMost: return left <= right;
        case Comparison::Greater: return left > right;
        case Comparison::AtLeast: return left >= right;
        case Comparison::Equal: return equal;
        case Comparison::Different: break;
    }
    return !equal;
}

bool isDone(const Step& step, const LessonState& state)
{
    return std::all_of(step.checks.begin(), step.checks.end(),
                       [&state](const Check& check) { return isMet(check, state); });
}

std::string written(const Check& check)
{
    const std::string& sign = comparisonSigns().at(static_cast<std::size_t>(check.comparison));
    if (!check.word.empty()) return fmt::format("{} {} {}", check.quantity, sign, check.word);
    if (check.other.empty()) return fmt::format("{} {} {}", check.quantity, sign, check.number);
    return fmt::format("{} {} {} * {}", check.quantity, sign, check.number, check.other);
}

}  // namespace lathelier::training
