#include "engine/receptance/spindle/spindle_item.h"

#include <algorithm>
#include <functional>
#include <string>

#include "engine/core/error.h"
#include "engine/core/item_numbers.h"

namespace lathelier::receptance {
namespace {

/// An entry of the receptance matrix as two lists.
struct Entry {
    const char* real;                            ///< key of the real parts
    const char* imaginary;                       ///< key of the imaginary parts
    std::vector<Complex> SpindleTable::*values;  ///< member of SpindleTable
};
constexpr Entry entries[] = {{"H_real_mm_N", "H_imag_mm_N", &SpindleTable::H_mm_N},
                             {"L_real_mm_Nmm", "L_imag_mm_Nmm", &SpindleTable::L_mm_Nmm},
                             {"P_real_rad_Nmm", "P_imag_rad_Nmm", &SpindleTable::P_rad_Nmm}};

std::optional<SpindleTable> tableFromValues(const Values& values)
{
    SpindleTable table;
    auto frequency_hz = numbersIn(values, "frequency_hz");
    if (!frequency_hz || frequency_hz->empty() || frequency_hz->front() < 0) return std::nullopt;
    table.frequency_hz = std::move(*frequency_hz);
    const std::vector<double>& lines = table.frequency_hz;
    if (std::adjacent_find(lines.begin(), lines.end(), std::greater_equal<>()) != lines.end()) return std::nullopt;
    for (const Entry& entry : entries) {
        const auto real = numbersIn(values, entry.real);
        const auto imaginary = numbersIn(values, entry.imaginary);
        if (!real || !imaginary || real->size() != lines.size() || imaginary->size() != lines.size())
            return std::nullopt;
        std::vector<Complex>& list = table.*entry.values;
        list.reserve(lines.size());
        for (std::size_t line = 0; line < lines.size(); ++line) list.emplace_back((*real)[line], (*imaginary)[line]);
    }
    return table;
}

}  // namespace

Values toValues(const SpindleReceptance& spindle)
{
    if (const SpindleSprings* springs = spindle.springs()) return lathelier::toValues(*springs);
    const auto& table = std::get<SpindleTable>(spindle.source);
    requireKeepable(table.frequency_hz.size());
    Values values{{"frequency_hz", table.frequency_hz}};
    for (const Entry& entry : entries) {
        std::vector<double> real, imaginary;
        real.reserve(table.frequency_hz.size());
        imaginary.reserve(table.frequency_hz.size());
        for (const Complex& value : table.*entry.values) {
            real.push_back(value.real());
            imaginary.push_back(value.imag());
        }
        set(values, entry.real, std::move(real));
        set(values, entry.imaginary, std::move(imaginary));
    }
    return values;
}

std::optional<SpindleReceptance> spindleOf(const Values& values)
{
    if (find(values, "frequency_hz")) {
        auto table = tableFromValues(values);
        return table ? std::optional(SpindleReceptance{std::move(*table)}) : std::nullopt;
    }
    for (const FieldInfo& info : infos<SpindleSprings>())
        if (!find(values, info.key)) return std::nullopt;
    try {
        return SpindleReceptance{fromValues<SpindleSprings>(values)};
    } catch (const Error&) {  // a value outside the range of SpindleSprings
        return std::nullopt;
    }
}

}  // namespace lathelier::receptance
