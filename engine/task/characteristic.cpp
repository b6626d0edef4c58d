#include "engine/task/characteristic.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>

#include "engine/core/units.h"
#include "engine/core/verdict_json.h"

namespace lathelier::task {
namespace {

struct UnitOfKey {
    std::string_view suffix;  ///< of the key, with its underscore
    Text shown;
};

/// Longest first: "_N_mm2" ends as "_mm2" does.
constexpr UnitOfKey unitsOfKeys[] = {{"_N_mm_rad", LT_TEXT("Engine", "N·mm/rad")},
                                     {"_mm_min", LT_TEXT("Engine", "mm/min")},
                                     {"_um_per_V", LT_TEXT("Engine", "µm/V")},
                                     {"_percent", unit::percent},
                                     {"_N_mm2", unit::N_mm2},
                                     {"_N_mm", unit::N_mm},
                                     {"_mm_N", LT_TEXT("Engine", "mm/N")},
                                     {"_um_N", LT_TEXT("Engine", "µm/N")},
                                     {"_m_min", unit::m_min},
                                     {"_mm_rev", unit::mm_rev},
                                     {"_rpm", unit::rpm},
                                     {"_deg", unit::deg},
                                     {"_rad", LT_TEXT("Engine", "rad")},
                                     {"_mm2", LT_TEXT("Engine", "mm²")},
                                     {"_mm3", unit::mm3},
                                     {"_um", unit::um},
                                     {"_mm", unit::mm},
                                     {"_hz", unit::hz},
                                     {"_kHz", LT_TEXT("Engine", "kHz")},
                                     {"_MPa", LT_TEXT("Engine", "MPa")},
                                     {"_upr", LT_TEXT("Engine", "UPR")},
                                     {"_kg", LT_TEXT("Engine", "kg")},
                                     {"_N", unit::newton},
                                     {"_s", unit::s},
                                     {"_V", LT_TEXT("Engine", "V")}};

constexpr std::string_view expanded = "_expanded_uncertainty";
constexpr std::string_view valueStems[] = {"value", "mean", "deviation"};
constexpr std::string_view besideStems[] = {"uncertainty", "limit", "lower", "upper"};

struct SplitKey {
    std::string stem;
    std::string suffix;  ///< of its unit; empty: none
    std::string unit;
};

SplitKey split(const std::string& key)
{
    for (const UnitOfKey& unit : unitsOfKeys)
        if (key.size() > unit.suffix.size() && key.ends_with(unit.suffix))
            return {key.substr(0, key.size() - unit.suffix.size()), std::string(unit.suffix), unit.shown.english};
    return {key, {}, {}};
}

template <std::size_t N>
bool isOneOf(const std::string& stem, const std::string_view (&stems)[N])
{
    return std::find(std::begin(stems), std::end(stems), stem) != std::end(stems);
}

std::optional<double> numberOf(const Json& object, const std::string& key)
{
    const auto found = object.find(key);
    if (found == object.end() || !found->is_number()) return std::nullopt;
    const double value = found->get<double>();
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::optional<Verdict> verdictIn(const Json& word)
{
    return word.is_string() ? verdictOf(word.get_ref<const std::string&>()) : std::nullopt;
}

class Collector {
public:
    std::vector<Characteristic> take(const Json& result)
    {
        object(result, "");
        return std::move(found_);
    }

private:
    void object(const Json& json, const std::string& prefix)
    {
        for (const auto& [key, value] : json.items()) {
            std::string whole = prefix;
            if (!whole.empty()) whole += '.';
            whole += key;
            if (value.is_number())
                number(json, key, whole);
            else if (value.is_object() && !isCurve(value))
                object(value, whole);
            else if (value.is_array())
                list(value, whole);
        }
    }

    /// What describes a list of numbers longer than a point: a histogram, a map.
    static bool isCurve(const Json& object)
    {
        constexpr std::size_t ofPoint = 3;
        return std::any_of(object.begin(), object.end(), [](const Json& value) {
            return value.is_array() && value.size() > ofPoint && !value.front().is_object();
        });
    }

    void number(const Json& json, const std::string& key, const std::string& whole)
    {
        const std::optional<double> value = numberOf(json, key);
        if (!value) return;
        const SplitKey name = split(key);
        if (name.stem.ends_with(expanded)) return;
        const bool is_value = isOneOf(name.stem, valueStems);
        if (isOneOf(name.stem, besideStems) && hasValue(json, name.suffix)) return;
        Characteristic one{unique(whole), name.unit, *value, {}, {}, {}, {}};
        one.expanded_uncertainty = numberOf(json, name.stem + std::string(expanded) + name.suffix);
        if (is_value) {
            if (!one.expanded_uncertainty) one.expanded_uncertainty = numberOf(json, "uncertainty" + name.suffix);
            one.lower_limit = numberOf(json, "lower" + name.suffix);
            one.upper_limit = numberOf(json, "upper" + name.suffix);
            if (const auto limit = numberOf(json, "limit" + name.suffix)) {
                one.lower_limit = -*limit;
                one.upper_limit = *limit;
            }
            const auto verdict = json.find("verdict");
            if (verdict != json.end()) one.verdict = verdictIn(*verdict);
        }
        found_.push_back(std::move(one));
    }

    static bool hasValue(const Json& json, const std::string& suffix)
    {
        return std::any_of(std::begin(valueStems), std::end(valueStems),
                           [&](std::string_view stem) { return json.contains(std::string(stem) + suffix); });
    }

    void list(const Json& json, const std::string& prefix)
    {
        std::size_t place = 0;
        for (const Json& item : json) {
            ++place;
            if (!item.is_object()) return;
            if (const auto name = nameOf(item, place)) object(item, prefix + "." + *name);
        }
    }

    static std::optional<std::string> nameOf(const Json& item, std::size_t place)
    {
        const auto word = [&item](const char* key) {
            const auto found = item.find(key);
            return found != item.end() && found->is_string() ? found->get<std::string>() : std::string();
        };
        if (const std::string name = word("name"); !name.empty() && !item.contains("path")) return name;
        if (const auto section = item.find("section"); section != item.end() && section->is_number_integer())
            return std::to_string(section->get<std::int64_t>());
        // Which findings there are differs from part to part.
        if (item.contains("kind")) return std::nullopt;
        if (item.contains("verdict")) return std::to_string(place);
        return std::nullopt;
    }

    /// Two items of one name ("bump" twice): the further ones are numbered.
    std::string unique(const std::string& key)
    {
        std::string made = key;
        for (int number = 2; !keys_.insert(made).second; ++number) {
            made = key;
            made.append("#").append(std::to_string(number));
        }
        return made;
    }

    std::vector<Characteristic> found_;
    std::set<std::string> keys_;
};

}  // namespace

Text unitNamed(std::string_view shown)
{
    for (const UnitOfKey& one : unitsOfKeys)
        if (shown == one.shown.english) return one.shown;
    return {};
}

std::string withoutUnit(const std::string& key)
{
    return split(key).stem;
}

std::vector<Characteristic> characteristicsOf(const Json& result)
{
    return result.is_object() ? Collector().take(result) : std::vector<Characteristic>();
}

std::vector<Characteristic> characteristicsOf(const Outcome& outcome)
{
    std::vector<Characteristic> all;
    if (outcome.answer) {
        const report::Answer answer = outcome.answer({});
        if (answer.value && std::isfinite(*answer.value)) {
            const auto finite = [](const std::optional<double>& value) {
                return value && std::isfinite(*value) ? value : std::nullopt;
            };
            all.push_back({"answer", answer.unit.english, *answer.value, finite(answer.expanded_uncertainty),
                           finite(answer.lower_limit), finite(answer.upper_limit), answer.verdict});
        }
    }
    if (outcome.json)
        for (Characteristic& one : characteristicsOf(outcome.json())) all.push_back(std::move(one));
    if (!outcome.understanding.isWhole())
        for (Characteristic& one : all) one.verdict.reset();
    return all;
}

Json toJson(const Characteristic& characteristic)
{
    return {{"key", characteristic.key},
            {"unit", characteristic.unit},
            {"value", lathelier::number(characteristic.value)},
            {"expanded_uncertainty", lathelier::number(characteristic.expanded_uncertainty)},
            {"lower_limit", lathelier::number(characteristic.lower_limit)},
            {"upper_limit", lathelier::number(characteristic.upper_limit)},
            {"verdict", verdictJson(characteristic.verdict)}};
}

std::optional<Characteristic> characteristicFrom(const Json& json)
{
    if (!json.is_object()) return std::nullopt;
    const auto key = json.find("key"), unit = json.find("unit");
    const std::optional<double> value = numberOf(json, "value");
    if (key == json.end() || !key->is_string() || unit == json.end() || !unit->is_string() || !value)
        return std::nullopt;
    Characteristic one{key->get<std::string>(), unit->get<std::string>(), *value, {}, {}, {}, {}};
    one.expanded_uncertainty = numberOf(json, "expanded_uncertainty");
    one.lower_limit = numberOf(json, "lower_limit");
    one.upper_limit = numberOf(json, "upper_limit");
    if (const auto verdict = json.find("verdict"); verdict != json.end()) one.verdict = verdictIn(*verdict);
    return one;
}

}  // namespace lathelier::task
