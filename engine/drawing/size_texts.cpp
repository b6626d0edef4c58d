#include "engine/drawing/size_texts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/core/units.h"

namespace lathelier::drawing {

std::string SizeTexts::number(double value, int decimals) const
{
    return shortNumber(value, decimals, options_.decimal_separator);
}

bool SizeTexts::isReplaced(const Size& size) const
{
    return size.measured_mm && std::abs(*size.measured_mm - size.value_mm) > same_mm;
}

bool SizeTexts::isMeasured(const Size& size) const
{
    if (size.tolerance || isReplaced(size)) return false;
    return size.measured_mm || options_.measured;
}

std::string SizeTexts::part(const Size& size) const
{
    if (!isMeasured(size)) return nominalSize(size.value_mm, size.tolerance, options_.decimal_separator);
    return measuredSize(size.value_mm, size.U_um, options_.decimal_separator);
}

DimensionText SizeTexts::composed(std::string text, const Size& leading)
{
    DimensionText result{std::move(text), isMeasured(leading)};
    if (!isReplaced(leading)) return result;
    differences_.push_back({result.text, leading.value_mm, *leading.measured_mm, leading.U_um});
    result.text += fmt::format(" [{}]", differences_.size());
    return result;
}

DimensionText SizeTexts::text(const std::string& prefix, const Size& size)
{
    return composed(prefix + part(size), size);
}

std::string SizeTexts::withUnit(double value, const std::optional<double>& expanded, bool measured, int decimals,
                                const std::string& unit) const
{
    if (!measured || !expanded) return number(value, decimals) + unit;
    const auto fixedNumber = [&](double shown) {
        std::string text = fmt::format("{:.{}f}", shown, decimals);
        if (const std::size_t point = text.find('.'); point != std::string::npos)
            text.replace(point, 1, options_.decimal_separator);
        return text;
    };
    return fixedNumber(value) + unit + " ±" + fixedNumber(std::max(*expanded, std::pow(10.0, -decimals))) + unit;
}

}  // namespace lathelier::drawing
