#include "engine/drawing/dimension_texts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lathelier::drawing {
namespace {

std::string separated(std::string text, const std::string& separator)
{
    const std::size_t point = text.find('.');
    if (point != std::string::npos) text.replace(point, 1, separator);
    return text;
}

std::string trimmed(std::string text)
{
    if (text.find('.') == std::string::npos) return text;
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
}

/// "+0.02", "−0.01", "0": the minus sign of typography.
std::string deviation(double value_um, const std::string& separator)
{
    std::string size = shortNumber(std::abs(value_um) / 1000, 4, separator);
    if (size != "0") size.insert(0, value_um > 0 ? "+" : "\u2212");
    return size;
}

}  // namespace

std::string shortNumber(double value, int decimals, const std::string& separator)
{
    std::string text = trimmed(fmt::format("{:.{}f}", value, decimals));
    if (text == "-0") text = "0";
    if (text.starts_with('-')) text.replace(0, 1, "\u2212");
    return separated(std::move(text), separator);
}

std::string roundedNumber(double value, const std::string& separator)
{
    if (!(value > 0)) return "0";
    const int before = static_cast<int>(std::floor(std::log10(value)));
    const double step = std::pow(10.0, before - 2);
    return separated(
        fmt::format("{:.{}f}", before > 2 ? std::round(value / step) * step : value, std::max(0, 2 - before)),
        separator);
}

std::string nominalSize(double size_mm, const std::optional<SizeTolerance>& tolerance, const std::string& separator)
{
    std::string text = shortNumber(size_mm, 3, separator);
    if (!tolerance) return text;
    const bool has_limits = tolerance->lower_um && tolerance->upper_um;
    const double lower = tolerance->lower_um.value_or(0), upper = tolerance->upper_um.value_or(0);
    const bool symmetric = upper > 0 && std::abs(lower + upper) < 1e-9;
    const std::string limits = symmetric ? "±" + shortNumber(upper / 1000, 4, separator)
                                         : deviation(upper, separator) + "/" + deviation(lower, separator);
    if (!tolerance->iso_class.empty()) {
        text += " " + tolerance->iso_class;
        if (!has_limits) return text;
        return text + " (" + limits + ")";
    }
    return has_limits ? text + " " + limits : text;
}

std::string measuredSize(double size_mm, const std::optional<double>& uncertainty_um, const std::string& separator)
{
    if (!uncertainty_um) return shortNumber(size_mm, 3, separator);
    const double u_mm = std::abs(*uncertainty_um) / 1000;
    const int decimals = u_mm < 0.1 ? 3 : u_mm < 1 ? 2 : 1;
    const double least = std::pow(10.0, -decimals);
    return separated(fmt::format("{:.{}f}", size_mm, decimals), separator) + " ±" +
           separated(fmt::format("{:.{}f}", std::max(u_mm, least), decimals), separator);
}

std::string threadDesignation(const ShaftMark& mark, const std::string& separator)
{
    if (!mark.designation.empty()) return mark.designation;
    if (!mark.major_mm || !mark.pitch_mm) return {};
    const double starts = mark.starts.value_or(1);
    std::string text = fmt::format("M{}×{}", shortNumber(*mark.major_mm, 2, separator),
                                   shortNumber(*mark.pitch_mm * std::max(1.0, starts), 3, separator));
    if (starts > 1) text += fmt::format(" (P{})", shortNumber(*mark.pitch_mm, 3, separator));
    if (mark.hand.value_or(1) < 0) text += " LH";
    return text;
}

std::string translated(Text text, const DrawingOptions& options)
{
    return options.translate ? options.translate(text) : std::string(text.english);
}

}  // namespace lathelier::drawing
