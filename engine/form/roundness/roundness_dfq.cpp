#include "engine/form/roundness/roundness_dfq.h"

#include <algorithm>

#include "engine/core/utf8.h"
#include "engine/form/roundness/roundness_quantities.h"
#include "engine/form/roundness/roundness_report.h"

namespace lathelier::form {
namespace {

constexpr std::size_t longestPartNumber = 30;  // of K1001, in characters

/// "data/shaft_03.csv" → "shaft_03"
std::string stemOf(const std::string& name)
{
    const std::string file = name.substr(name.find_last_of('/') + 1);
    const std::size_t dot = file.find_last_of('.');
    return dot == std::string::npos || dot == 0 ? file : file.substr(0, dot);
}

/// What the profiles of one feature have in common, without a trailing number that distinguishes them.
std::string partOf(const std::vector<RoundnessResult>& results)
{
    if (results.empty()) return {};
    const std::string first = stemOf(results.front().name);
    std::string common = first;
    for (const RoundnessResult& result : results) {
        const std::string stem = stemOf(result.name);
        const auto [end, other] = std::mismatch(common.begin(), common.end(), stem.begin(), stem.end());
        common.erase(end, common.end());
    }
    if (results.size() > 1) common.erase(common.find_last_not_of("0123456789_-. ") + 1);
    const std::string part = std::string(firstBytes(common.empty() ? first : common, longestPartNumber));
    return part.empty() ? "roundness" : part;
}

const QuantityOf<RoundnessResult>& deviationBy(ReferenceCircle circle)
{
    return quantityOf<RoundnessResult>("RONt_" + std::string(name(circle)) + "_um");
}

io::QdasCharacteristic& characteristicFor(const RoundnessResult& result, ReferenceCircle circle, io::QdasFile& file)
{
    const QuantityInfo& info = deviationBy(circle).info;
    io::QdasCharacteristic wanted;
    wanted.description = std::string(info.label.english) + " " + filterName(bandOf(result.parameters));
    wanted.unit = info.unit.english;
    wanted.nominal = 0;
    wanted.lower_limit = 0;
    wanted.lower_is_natural = true;
    if (circle == result.parameters.circle && result.parameters.tolerance_um)
        wanted.upper_limit = *result.parameters.tolerance_um;
    for (io::QdasCharacteristic& known : file.characteristics)
        if (known.description == wanted.description && known.upper_limit == wanted.upper_limit) return known;
    wanted.number = std::to_string(file.characteristics.size() + 1);
    return file.characteristics.emplace_back(std::move(wanted));
}

}  // namespace

io::QdasFile qdasFile(const std::vector<RoundnessResult>& results, const std::vector<std::string>& measured)
{
    io::QdasFile file;
    file.part_number = partOf(results);
    file.part_description = "Lathelier roundness";
    const std::string now = io::qdasTime(std::time(nullptr));
    for (std::size_t i = 0; i < results.size(); ++i)
        for (const ReferenceCircle circle :
             {ReferenceCircle::LSCI, ReferenceCircle::MZCI, ReferenceCircle::MICI, ReferenceCircle::MCCI}) {
            io::QdasCharacteristic& characteristic = characteristicFor(results[i], circle, file);
            characteristic.values.push_back(std::get<double>(deviationBy(circle).get(results[i])));
            characteristic.measured.push_back(i < measured.size() && !measured[i].empty() ? measured[i] : now);
        }
    return file;
}

}  // namespace lathelier::form
