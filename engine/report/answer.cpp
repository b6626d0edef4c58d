#include "engine/report/answer.h"

#include <fmt/format.h>

#include "engine/report/cells.h"

namespace lathelier::report {
namespace {

std::string numberText(double value, const Answer& answer, const Language& language)
{
    const std::string digits = shownNumber(value, answer.unit, answer.decimals, language);
    return answer.is_signed && value > 0 ? "+" + digits : digits;
}

std::string unitText(const Answer& answer, const Language& language)
{
    return answer.unit.empty() ? std::string()
                               : fmt::format(" {}", text(shownUnit(answer.unit, language).unit, language));
}

/// A limit is shown with the digits it was stated with.
std::string limitNumber(double value, const Answer& answer, const Language& language)
{
    return text(shownValue(value, answer.unit, language), language);
}

}  // namespace

std::string valueText(const Answer& answer, const Language& language)
{
    if (!answer.value) return {};
    std::string result = numberText(*answer.value, answer, language);
    if (answer.expanded_uncertainty)
        if (const std::string digits =
                shownNumber(*answer.expanded_uncertainty, answer.unit, answer.decimals, language);
            !digits.empty())
            result += " ± " + digits;
    return keptTogether(result + unitText(answer, language));
}

std::string valueLine(const Answer& answer, const Language& language)
{
    std::string quantity = captionText(answer.quantity, language);
    if (!answer.subject.empty()) quantity += ", " + answer.subject;
    const std::string value = valueText(answer, language);
    return value.empty() ? quantity : quantity + " " + value;
}

std::string limitText(const Answer& answer, const Language& language)
{
    const std::string unit = unitText(answer, language);
    const auto say = [&](Text pattern, const Values& values) {
        return keptTogether(fill(text(pattern, language), values, language) + unit);
    };
    if (answer.lower_limit && answer.upper_limit) {
        const double lower = *answer.lower_limit, upper = *answer.upper_limit;
        if (lower == -upper)
            return say(LT_TEXT("Engine", "limit ±{limit}"), {{"limit", limitNumber(upper, answer, language)}});
        return say(LT_TEXT("Engine", "limits {lower} … {upper}"),
                   {{"lower", limitNumber(lower, answer, language)},
                    {"upper", fmt::format("{}{}", upper > 0 ? "+" : "", limitNumber(upper, answer, language))}});
    }
    if (answer.upper_limit)
        return say(LT_TEXT("Engine", "limit {limit}"), {{"limit", limitNumber(*answer.upper_limit, answer, language)}});
    if (answer.lower_limit)
        return say(LT_TEXT("Engine", "at least {limit}"),
                   {{"limit", limitNumber(*answer.lower_limit, answer, language)}});
    return text(LT_TEXT("Engine", "no limit given"), language);
}

std::string verdictText(const Answer& answer, const Language& language)
{
    if (!answer.verdict_words.empty()) return text(answer.verdict_words, language);
    return text(answer.verdict ? name(*answer.verdict) : LT_TEXT("Engine", "no limit given"), language);
}

std::string assumedText(const Answer& answer, const Language& language)
{
    std::string list;
    for (const UsedValue& value : answer.used) {
        if (value.origin != ValueOrigin::Assumed) continue;
        list += fmt::format("{}{} {}", list.empty() ? "" : ", ", text(value.label, language),
                            text(shownValue(value.value, value.unit, language), language));
        if (!value.unit.empty()) list += fmt::format(" {}", text(shownUnit(value.unit, language).unit, language));
    }
    if (list.empty()) return {};
    return keptTogether(fill(text(LT_TEXT("Engine", "assumed: {values}"), language), {{"values", list}}, language));
}

std::string sentenceText(const Answer& answer, const Language& language)
{
    return keptTogether(fill(text(answer.sentence, language), answer.values, language));
}

std::string findingText(const Finding& finding, const Language& language)
{
    return keptTogether(fill(text(finding.pattern, language), finding.values, language));
}

std::string plainText(const Answer& answer, const Language& language)
{
    std::string result = valueLine(answer, language);
    if (answer.verdict && (answer.lower_limit || answer.upper_limit)) result += " · " + limitText(answer, language);
    if (answer.verdict) result += "  " + verdictText(answer, language);
    result += "\n";
    if (const std::string sentence = sentenceText(answer, language); !sentence.empty()) result += sentence + "\n";
    for (const Finding& finding : answer.findings) {
        result += "  - " + findingText(finding, language);
        if (finding.verdict) result += "  " + text(shortName(*finding.verdict), language);
        result += "\n";
    }
    if (const std::string assumed = assumedText(answer, language); !assumed.empty()) result += assumed + "\n";
    return result;
}

}  // namespace lathelier::report
