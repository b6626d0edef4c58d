#include "engine/gcode/program_item.h"

#include <algorithm>
#include <cmath>

#include "engine/core/item_numbers.h"
#include "engine/shaft/shaft_item.h"

namespace lathelier::gcode {
namespace {

constexpr const char* textKey = "text";
constexpr const char* clampingKey = "clamping";
constexpr const char* zeroKey = "z_zero_mm";
constexpr const char* fromKey = "corrected_from";
constexpr const char* placesKey = "correction_z_mm";
constexpr const char* radiiKey = "correction_radius_mm";

template <class T>
T valueOr(const Values& values, const char* key, T otherwise)
{
    const Value* const value = find(values, key);
    const T* const stated = value ? std::get_if<T>(value) : nullptr;
    return stated ? *stated : otherwise;
}

/// A project file writes whole numbers as such.
double numberOr(const Values& values, const char* key, double otherwise)
{
    const double whole = static_cast<double>(valueOr(values, key, std::int64_t{0}));
    return valueOr(values, key, whole == 0 ? otherwise : whole);
}

}  // namespace

Values toValues(const ProgramItem& program)
{
    Values values = program.stock ? lathelier::toValues(*program.stock) : Values{};
    set(values, textKey, program.text);
    set(values, clampingKey, std::int64_t{program.clamping});
    set(values, zeroKey, program.z_zero_mm);
    if (program.corrected_from.empty()) return values;
    set(values, fromKey, program.corrected_from);
    requireKeepable(program.correction.z_mm.size());
    set(values, placesKey, program.correction.z_mm);
    set(values, radiiKey, program.correction.radius_mm);
    return values;
}

std::optional<ProgramItem> programOf(const Values& values)
{
    ProgramItem program;
    program.text = valueOr(values, textKey, std::string());
    if (program.text.empty()) return std::nullopt;
    program.clamping = static_cast<int>(std::clamp<std::int64_t>(valueOr(values, clampingKey, std::int64_t{1}), 1, 2));
    program.z_zero_mm = numberOr(values, zeroKey, 0);
    program.stock = shaftOf(values);
    program.corrected_from = valueOr(values, fromKey, std::string());
    if (!std::isfinite(program.z_zero_mm)) return std::nullopt;
    if (program.corrected_from.empty()) return program;
    const auto z_mm = numbersIn(values, placesKey), radius_mm = numbersIn(values, radiiKey);
    if (!z_mm || !radius_mm || z_mm->size() != radius_mm->size() || !std::is_sorted(z_mm->begin(), z_mm->end()))
        return std::nullopt;
    program.correction.z_mm = *z_mm;
    program.correction.radius_mm = *radius_mm;
    return program;
}

}  // namespace lathelier::gcode
