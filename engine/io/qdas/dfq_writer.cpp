#include "engine/io/qdas/dfq_writer.h"
#include "engine/io/qdas/dfq.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/core/error.h"
#include "engine/core/utf8.h"
#include "engine/io/file.h"
#include "engine/io/text/encoding.h"
#include "engine/io/text/windows1252.h"

namespace lathelier::io {
namespace {

/// File names may contain any bytes, the file has one encoding.
std::string asUtf8(std::string_view word)
{
    try {
        return std::string(decodeText(word, Encoding::Utf8).view());
    } catch (const Error&) {
        return std::string(decodeText(word, Encoding::Latin1).view());
    }
}

/// Replaces line breaks by blanks.
void addField(std::string& out, std::string_view field, std::string_view value)
{
    out += field;
    out += ' ';
    for (const char c : asUtf8(value)) out += static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? ' ' : c;
    out += "\r\n";
}

void addWord(std::string& out, std::string_view field, const std::string& value)
{
    if (!value.empty()) addField(out, field, value);
}

/// Shortest representation that restores the same double.
void addNumber(std::string& out, std::string_view field, const std::optional<double>& value)
{
    if (value && std::isfinite(*value)) addField(out, field, fmt::format("{}", *value));
}

std::string fieldOf(std::string_view key, std::size_t index)
{
    return fmt::format("{}/{}", key, index);
}

constexpr int attributeValid = 0;
constexpr int attributeInvalid = 255;
constexpr std::size_t longestDescription = 80;

/// K2120, K2121: none, a limit, a natural limit.
std::string_view limitKind(const std::optional<double>& limit, bool isNatural)
{
    if (!limit || !std::isfinite(*limit)) return "0";
    return isNatural ? "2" : "1";
}

void addCharacteristic(std::string& out, const QdasCharacteristic& characteristic, std::size_t index)
{
    addWord(out, fieldOf("K2001", index), characteristic.number);
    addWord(out, fieldOf("K2002", index), std::string(firstCharacters(characteristic.description, longestDescription)));
    addField(out, fieldOf("K2004", index), "0");  // measured values
    addField(out, fieldOf("K2022", index), std::to_string(characteristic.decimals));
    addNumber(out, fieldOf("K2101", index), characteristic.nominal);
    addNumber(out, fieldOf("K2110", index), characteristic.lower_limit);
    addNumber(out, fieldOf("K2111", index), characteristic.upper_limit);
    addField(out, fieldOf("K2120", index), limitKind(characteristic.lower_limit, characteristic.lower_is_natural));
    addField(out, fieldOf("K2121", index), limitKind(characteristic.upper_limit, characteristic.upper_is_natural));
    addWord(out, fieldOf("K2142", index), characteristic.unit);
}

void addValue(std::string& out, const QdasCharacteristic& characteristic, std::size_t which, std::size_t index)
{
    const double value = characteristic.values[which];
    const bool valid = std::isfinite(value);
    addField(out, fieldOf("K0001", index), valid ? fmt::format("{}", value) : "0");
    addField(out, fieldOf("K0002", index), std::to_string(valid ? attributeValid : attributeInvalid));
    if (which < characteristic.measured.size()) addWord(out, fieldOf("K0004", index), characteristic.measured[which]);
}

}  // namespace

std::string toDfq(const QdasFile& file)
{
    std::string out;
    addField(out, "K0100", std::to_string(file.characteristics.size()));
    addWord(out, "K1001", file.part_number);
    addWord(out, "K1002", file.part_description);
    addWord(out, "K1082", file.machine);
    std::size_t rounds = 0;
    for (std::size_t i = 0; i < file.characteristics.size(); ++i) {
        addCharacteristic(out, file.characteristics[i], i + 1);
        rounds = std::max(rounds, file.characteristics[i].values.size());
    }
    // Value by value through all characteristics, as they were measured.
    for (std::size_t v = 0; v < rounds; ++v)
        for (std::size_t i = 0; i < file.characteristics.size(); ++i)
            if (v < file.characteristics[i].values.size()) addValue(out, file.characteristics[i], v, i + 1);
    if (auto narrow = toWindows1252(out)) return *std::move(narrow);
    std::string marked = "\xEF\xBB\xBF";  // byte order mark, by which programs recognise UTF-8
    return marked += out;
}

std::string qdasTime(std::time_t time)
{
    std::tm local{};
    localtime_r(&time, &local);
    char buffer[40];
    return {buffer, std::strftime(buffer, sizeof buffer, "%d.%m.%Y/%H:%M:%S", &local)};
}

void writeDfq(const std::string& path, const QdasFile& file)
{
    writeFile(path, toDfq(file));
}

}  // namespace lathelier::io
