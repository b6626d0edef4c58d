#include "engine/report/answer_ruler.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/report/colours.h"
#include "engine/report/svg.h"

namespace lathelier::report {

std::optional<Ruler> rulerOf(const Answer& answer)
{
    if (!answer.value || !std::isfinite(*answer.value) || (!answer.lower_limit && !answer.upper_limit))
        return std::nullopt;
    const double uncertainty =
        std::isfinite(answer.expanded_uncertainty.value_or(0)) ? std::abs(answer.expanded_uncertainty.value_or(0)) : 0;
    const double low = *answer.value - uncertainty, high = *answer.value + uncertainty;
    const bool from_zero = !answer.lower_limit && !answer.is_signed;
    const double lower = answer.lower_limit.value_or(from_zero ? 0 : std::min(low, *answer.upper_limit));
    const double upper = answer.upper_limit.value_or(std::max(high, *answer.lower_limit));
    const double margin = 0.25 * std::max({upper - lower, high - low, 1e-12 * std::abs(upper)});
    const double start = from_zero ? std::min(0.0, low) : std::min(lower, low) - margin;
    const double end = std::max(upper, high) + margin;
    if (!(end > start)) return std::nullopt;
    const auto place = [&](double value) { return std::clamp((value - start) / (end - start), 0.0, 1.0); };
    Ruler ruler;
    ruler.within_from = answer.lower_limit ? place(*answer.lower_limit) : 0;
    ruler.within_to = answer.upper_limit ? place(*answer.upper_limit) : 1;
    ruler.is_lower_limited = answer.lower_limit.has_value();
    ruler.is_upper_limited = answer.upper_limit.has_value();
    ruler.value = place(*answer.value);
    ruler.low = place(low);
    ruler.high = place(high);
    ruler.start = start;
    ruler.end = end;
    return ruler;
}

std::string rulerSvg(const Answer& answer, const Language& language)
{
    const auto ruler = rulerOf(answer);
    if (!ruler) return {};
    constexpr double width = 620, left = 12, right = 608, middle = 15;
    const auto x = [&](double place) { return left + place * (right - left); };
    Svg svg(width, 46, fmt::format("{}, {}", valueLine(answer, language), limitText(answer, language)));
    svg.rect(left, middle - 5, right - left, 10, "#e4e7eb");
    svg.rect(x(ruler->within_from), middle - 5, x(ruler->within_to) - x(ruler->within_from), 10, "#bfe3d0");
    const auto limit = [&](double place, double value) {
        svg.line(x(place), middle - 10, x(place), middle + 10, "#1f2933", 2);
        svg.text(x(place), 42, Svg::Anchor::Middle, 12, text(shownValue(value, answer.unit, language), language));
    };
    if (ruler->is_lower_limited) limit(ruler->within_from, *answer.lower_limit);
    if (ruler->is_upper_limited) limit(ruler->within_to, *answer.upper_limit);
    svg.line(x(ruler->low), middle, x(ruler->high), middle, "#1f2933", 3);
    svg.line(x(ruler->low), middle - 4, x(ruler->low), middle + 4, "#1f2933", 2);
    svg.line(x(ruler->high), middle - 4, x(ruler->high), middle + 4, "#1f2933", 2);
    const double at = x(ruler->value);
    svg.path(fmt::format("M{} 2H{}L{} 12Z", coordinate(at - 6), coordinate(at + 6), coordinate(at)), "none", 0,
             "#1f2933");
    return fmt::format("<figure class=\"ruler\">{}</figure>\n", svg.finish());
}

}  // namespace lathelier::report
