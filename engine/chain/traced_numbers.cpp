#include "engine/chain/traced_numbers.h"

#include <nlohmann/json.hpp>

namespace lathelier::chain {
namespace {

/// JSON pointer pattern of a number in the result of a step; * matches every item of a list.
struct Pattern {
    const char* step;
    const char* value;
    const char* uncertainty = nullptr;  // pattern of its uncertainty; nullptr: none
    std::int64_t coverage_factor = 2;
};

constexpr Pattern patterns[] = {
    {"recognise", "/length_mm", "/length_uncertainty_mm"},
    {"recognise", "/noise_mm"},
    {"recognise", "/residual_rmse_mm"},
    {"recognise", "/segments/*/start_diameter_mm", "/segments/*/uncertainty/start_diameter_um"},
    {"recognise", "/segments/*/end_diameter_mm", "/segments/*/uncertainty/end_diameter_um"},
    {"recognise", "/segments/*/z_start_mm", "/segments/*/uncertainty/z_start_um"},
    {"recognise", "/segments/*/z_end_mm", "/segments/*/uncertainty/z_end_um"},
    {"draw", "/length_mm"},
    {"draw", "/volume_mm3"},
    {"draw", "/segments/*/start_diameter_mm"},
    {"draw", "/segments/*/end_diameter_mm"},
    {"draw", "/segments/*/z_start_mm"},
    {"draw", "/segments/*/z_end_mm"},
    {"machine", "/natural_frequencies_hz/*"},
    {"speeds", "/minimum_depth_mm"},
    {"speeds", "/frequency_of_minimum_hz"},
    {"program", "/sections/*/speed_rpm"},
    {"program", "/sections/*/frequency_hz"},
    {"program", "/setups/*/time_s"},
    {"program", "/rest/*/left_mm"},
    {"program", "/check/gouge_um"},
    {"program", "/check/left_max_mm"},
    {"deflection", "/max_um"},
    {"deflection", "/mean_abs_um"},
    {"deflection", "/wear_offset_um"},
    {"deflection", "/largest_correction_um"},
    {"deflection", "/residual_max_um"},
    {"deflection_2", "/max_um"},
    {"deflection_2", "/mean_abs_um"},
    {"deflection_2", "/largest_correction_um"},
    {"deflection_2", "/residual_max_um"},
    {"corrected_check", "/check/gouge_um"},
    {"corrected_check", "/check/left_max_mm"},
    {"copy", "/rmse_mm"},
    {"copy", "/worst/deviation_mm", "/worst/uncertainty_mm"},
    {"copy", "/rows/*/measured_mm", "/rows/*/uncertainty_mm"},
    {"copy", "/rows/*/deviation_mm", "/rows/*/uncertainty_mm"},
    {"proof", "/places/*/predicted_um", "/places/*/predicted_uncertainty_um"},
    {"proof", "/places/*/measured_um", "/places/*/measured_uncertainty_um"},
    {"proof", "/places/*/normalized_error"},
    {"proof", "/largest_normalized_error"},
    {"proof", "/along/*/measured_um", "/along/*/measured_uncertainty_um"},
    {"surface", "/images/*/feed_marks/pitch_mm"},
    {"surface", "/images/*/chatter_marks/frequency_hz", "/images/*/chatter_marks/frequency_uncertainty_hz", 1},
    {"surface", "/comparison/relative_to_feed/*"},
};

/// The pattern with its * replaced in order.
std::string filled(std::string pattern, const std::vector<std::size_t>& items)
{
    for (const std::size_t item : items) {
        const std::size_t star = pattern.find('*');
        if (star == std::string::npos) break;
        pattern.replace(star, 1, std::to_string(item));
    }
    return pattern;
}

const Json* memberAt(const Json& result, const std::string& pointer)
{
    const Json::json_pointer place(pointer);
    return result.contains(place) ? &result.at(place) : nullptr;
}

/// Calls use(items) for every way to fill the stars of the pattern behind those in `items`.
template <class Use>
void forEachPlace(const Json& result, const std::string& pattern, std::vector<std::size_t>& items, const Use& use)
{
    const std::string reached = filled(pattern, items);
    const std::size_t star = reached.find('*');
    if (star == std::string::npos) return use(reached);
    const Json* const list = memberAt(result, reached.substr(0, star - 1));
    if (!list || !list->is_array()) return;
    for (std::size_t i = 0; i < list->size(); ++i) {
        items.push_back(i);
        forEachPlace(result, pattern, items, use);
        items.pop_back();
    }
}

}  // namespace

std::vector<TracedNumber> numbersOf(const std::string& step, const Json& result, const std::string& file)
{
    std::vector<TracedNumber> numbers;
    for (const Pattern& pattern : patterns) {
        if (step != pattern.step) continue;
        std::vector<std::size_t> items;
        forEachPlace(result, pattern.value, items, [&](const std::string& pointer) {
            const Json* const value = memberAt(result, pointer);
            if (!value || !value->is_number()) return;
            std::string last = pointer.substr(pointer.rfind('/') + 1);
            if (last.find_first_not_of("0123456789") ==
                std::string::npos)  // items of a plain list use the key of the list
                last = pointer.substr(0, pointer.rfind('/')).substr(pointer.rfind('/', pointer.rfind('/') - 1) + 1);
            TracedNumber number{step, last, value->get<double>(), file, pointer, {}, pattern.coverage_factor, {}};
            if (pattern.uncertainty) {
                const std::string place = filled(pattern.uncertainty, items);
                const Json* const uncertainty = memberAt(result, place);
                if (uncertainty && uncertainty->is_number()) {
                    number.uncertainty = uncertainty->get<double>();
                    number.uncertainty_pointer = place;
                }
            }
            numbers.push_back(std::move(number));
        });
    }
    return numbers;
}

}  // namespace lathelier::chain
