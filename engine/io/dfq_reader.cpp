// Q-DAS ASCII back into values: one K-field a line.
#include <cmath>
#include <map>

#include "engine/io/dfq_writer.h"
#include "engine/io/encoding.h"
#include "engine/io/file_kind.h"
#include "engine/io/io_codes.h"
#include "engine/io/number.h"
#include "engine/io/text_lines.h"

namespace lathelier {
namespace {

constexpr std::int64_t mostCharacteristics = 100000;

/// "K2001/3 R1" taken apart.
struct FieldLine {
    std::int64_t key = 0;    ///< 2001
    std::int64_t index = 0;  ///< 3; 0 when none is written: it belongs to the part, or to the only characteristic
    std::string_view value;
};

FieldLine parseLine(const Lines& lines)
{
    const std::string_view line = lines.line();
    const std::string_view row = trimmed(line);
    const std::size_t blank = std::min(row.find_first_of(" \t"), row.size());
    const std::string_view field = row.substr(0, blank);
    const std::size_t slash = std::min(field.find('/'), field.size());
    const auto key = field.starts_with('K') && slash == 5 ? wholeInteger(field.substr(1, 4)) : std::nullopt;
    if (!key || *key < 0) throw malformed(lines.number(), line, row, LT_TEXT("Engine", "a field such as K0001/1"));
    FieldLine result{*key, 0, trimmed(row.substr(blank))};
    if (slash < field.size()) {
        const auto index = wholeInteger(field.substr(slash + 1));
        if (!index || *index < 0 || *index > mostCharacteristics)
            throw malformed(lines.number(), line, field.substr(slash),
                            LT_TEXT("Engine", "the number of a characteristic"));
        result.index = *index;
    }
    return result;
}

double numberOf(const Lines& lines, const FieldLine& field)
{
    for (const char decimal : {'.', ','})
        if (const auto value = wholeNumber(field.value, decimal); value && std::isfinite(*value)) return *value;
    throw malformed(lines.number(), lines.line(), field.value, LT_TEXT("Engine", "a number"));
}

std::int64_t integerOf(const Lines& lines, const FieldLine& field, std::int64_t largest)
{
    const auto value = wholeInteger(field.value);
    if (value && *value >= 0 && *value <= largest) return *value;
    throw malformed(lines.number(), lines.line(), field.value, LT_TEXT("Engine", "a whole number"));
}

class DfqReader {
public:
    void take(const Lines& lines)
    {
        const FieldLine field = parseLine(lines);
        const std::string value(field.value);
        sawField_ = true;
        switch (field.key) {
            case 100: announced_ = integerOf(lines, field, mostCharacteristics); return;
            case 1001: file_.part_number = value; return;
            case 1002: file_.part_description = value; return;
            case 1082: file_.machine = value; return;
            case 2001: at(field).number = value; return;
            case 2002: at(field).description = value; return;
            case 2022: at(field).decimals = static_cast<int>(integerOf(lines, field, 255)); return;
            case 2101: at(field).nominal = numberOf(lines, field); return;
            case 2110: at(field).lower_limit = numberOf(lines, field); return;
            case 2111: at(field).upper_limit = numberOf(lines, field); return;
            case 2142: at(field).unit = value; return;
            case 1: at(field).values.push_back(numberOf(lines, field)); return;
            case 2: mark(lines, field); return;
            case 4: file_.measured = value; return;
            default: return;  // the standard has hundreds of fields; the others say nothing of the values
        }
    }

    QdasFile finish(const Lines& lines)
    {
        if (!sawField_) throw Error(errors::fileEmpty, {});
        if (announced_ && static_cast<std::int64_t>(characteristics_.size()) > *announced_) throw countDiffers(lines);
        if (announced_ && !characteristics_.empty() && characteristics_.rbegin()->first > *announced_)
            throw countDiffers(lines);
        if (announced_ && static_cast<std::int64_t>(characteristics_.size()) < *announced_)
            throw Error(errors::truncated, {{"line", lines.number()},
                                            {"column", std::int64_t{1}},
                                            {"found", static_cast<std::int64_t>(characteristics_.size())},
                                            {"expected", *announced_},
                                            {"items", LT_TEXT("Engine", "characteristics")}});
        for (auto& [index, characteristic] : characteristics_)
            file_.characteristics.push_back(std::move(characteristic));
        return std::move(file_);
    }

private:
    QdasCharacteristic& at(const FieldLine& field) { return characteristics_[std::max<std::int64_t>(field.index, 1)]; }

    /// An attribute other than 0 says that the value before it does not count.
    void mark(const Lines& lines, const FieldLine& field)
    {
        QdasCharacteristic& characteristic = at(field);
        if (integerOf(lines, field, 65535) == 0) return;
        if (characteristic.values.empty())
            throw malformed(lines.number(), lines.line(), lines.line(),
                            LT_TEXT("Engine", "a value before its attribute"));
        characteristic.values.back() = std::nan("");
    }

    Error countDiffers(const Lines& lines) const
    {
        return Error(errors::malformed, {{"line", lines.number()},
                                         {"column", std::int64_t{1}},
                                         {"found", characteristics_.rbegin()->first},
                                         {"expected", LT_TEXT("Engine", "as many characteristics as K0100 says")}});
    }

    QdasFile file_;
    std::map<std::int64_t, QdasCharacteristic> characteristics_;
    std::optional<std::int64_t> announced_;
    bool sawField_ = false;
};

}  // namespace

QdasFile readDfq(const std::string& name, std::string_view bytes)
{
    try {
        const DecodedText text =
            readableText(bytes, Encoding::Auto, LT_TEXT("Engine", "a Q-DAS file with K-fields"), {});
        Lines lines(text.view());
        DfqReader reader;
        while (lines.next())
            if (!trimmed(lines.line()).empty()) reader.take(lines);
        return reader.finish(lines);
    } catch (Error& error) {
        error.with("path", name);
        throw;
    }
}

}  // namespace lathelier
