#include "engine/receptance/spindle/spindle_file.h"

#include <nlohmann/json.hpp>

#include "engine/core/json.h"
#include "engine/io/json/json_fields.h"

namespace lathelier::receptance {
namespace {

constexpr std::size_t mostSpindleLines = 1000000;

std::vector<double> ascending(const io::JsonCursor& list)
{
    std::vector<double> result;
    list.items(mostSpindleLines, [&result](const io::JsonCursor& item) {
        const double value = item.number();
        if (!(value >= 0) || (!result.empty() && !(value > result.back())))
            item.reject(LT_TEXT("Engine", "frequencies that ascend from 0 or more"));
        result.push_back(value);
    });
    if (result.empty()) list.reject(LT_TEXT("Engine", "at least one frequency"));
    return result;
}

Complex complexOf(const io::JsonCursor& pair)
{
    std::vector<double> parts;
    pair.items(2, [&parts](const io::JsonCursor& part) { parts.push_back(part.number()); });
    if (parts.size() != 2) pair.reject(LT_TEXT("Engine", "a pair [real, imaginary]"));
    return {parts[0], parts[1]};
}

std::vector<Complex> complexList(const io::JsonCursor& root, const char* key, std::size_t lines)
{
    const io::JsonCursor list = root.at(key, LT_TEXT("Engine", "pairs [real, imaginary], one for each frequency"));
    std::vector<Complex> result;
    list.items(mostSpindleLines, [&result](const io::JsonCursor& pair) { result.push_back(complexOf(pair)); });
    if (result.size() != lines) list.reject(LT_TEXT("Engine", "as many pairs as frequencies"));
    return result;
}

Json listOf(const std::vector<Complex>& values)
{
    Json result = Json::array();
    for (const Complex& value : values) result.push_back(Json::array({number(value.real()), number(value.imag())}));
    return result;
}

}  // namespace

SpindleReceptance readSpindle(const std::string& text, Notes& notes)
{
    const io::JsonDocument document{text};
    const io::JsonCursor root = document.root();
    io::valuesOf(root, {}, notes, {"springs", "frequency_hz", "H_mm_N", "L_mm_Nmm", "P_rad_Nmm"});
    const auto frequency = root.member("frequency_hz");
    if (const auto springs = root.member("springs")) {
        if (frequency) frequency->reject(LT_TEXT("Engine", "either springs or a table, not both"));
        return {io::readFields<SpindleSprings>(*springs, notes)};
    }
    SpindleTable table;
    table.frequency_hz = ascending(root.at("frequency_hz", LT_TEXT("Engine", "springs, or a table by frequency")));
    table.H_mm_N = complexList(root, "H_mm_N", table.frequency_hz.size());
    table.L_mm_Nmm = complexList(root, "L_mm_Nmm", table.frequency_hz.size());
    table.P_rad_Nmm = complexList(root, "P_rad_Nmm", table.frequency_hz.size());
    return {std::move(table)};
}

std::string spindleText(const SpindleReceptance& spindle)
{
    Json root = Json::object();
    if (const SpindleSprings* springs = spindle.springs()) {
        root["springs"] = io::objectOf(infos<SpindleSprings>(), lathelier::toValues(*springs));
        return root.dump(2) + "\n";
    }
    const auto& table = std::get<SpindleTable>(spindle.source);
    root["frequency_hz"] = numbers(table.frequency_hz);
    root["H_mm_N"] = listOf(table.H_mm_N);
    root["L_mm_Nmm"] = listOf(table.L_mm_Nmm);
    root["P_rad_Nmm"] = listOf(table.P_rad_Nmm);
    return root.dump() + "\n";
}

}  // namespace lathelier::receptance
