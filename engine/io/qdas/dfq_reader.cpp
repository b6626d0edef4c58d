// Reader of Q-DAS ASCII: one K-field per line.
#include "engine/io/qdas/dfq_reader.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "engine/io/io_codes.h"
#include "engine/io/qdas/dfq.h"
#include "engine/io/text/encoding.h"
#include "engine/io/text/number.h"
#include "engine/io/text/readable_text.h"
#include "engine/io/text/text_lines.h"

namespace lathelier::io {
namespace {

constexpr std::int64_t mostCharacteristics = 100000;

/// A parsed field "K2001/3 R1".
struct FieldLine {
    std::int64_t key = 0;    ///< field number, 2001
    std::int64_t index = 0;  ///< index, 3; 0 when absent: part, or the only characteristic
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
        if (!trimmed(lines.line()).starts_with('K')) return takeShortLine(lines);
        const FieldLine field = parseLine(lines);
        const std::string value(field.value);
        sawField_ = true;
        if (field.key >= 1000 && field.key < 2000) file_.parts = std::max(file_.parts, field.index);
        switch (field.key) {
            case 100: announced_ = integerOf(lines, field, mostCharacteristics); return;
            case 1001: return setFirst(file_.part_number, value);
            case 1002: return setFirst(file_.part_description, value);
            case 1082: return setFirst(file_.machine, value);
            case 2001: at(field).shown.number = value; return;
            case 2002: at(field).shown.description = value; return;
            case 2022: at(field).shown.decimals = static_cast<int>(integerOf(lines, field, 255)); return;
            case 2101: at(field).shown.nominal = numberOf(lines, field); return;
            case 2110: at(field).shown.lower_limit = numberOf(lines, field); return;
            case 2111: at(field).shown.upper_limit = numberOf(lines, field); return;
            case 2120: at(field).lower_kind = integerOf(lines, field, 2); return;
            case 2121: at(field).upper_kind = integerOf(lines, field, 2); return;
            case 2142: at(field).shown.unit = value; return;
            case 1: add(at(field), numberOf(lines, field)); return;
            case 2: mark(lines, field); return;
            case 4: stamp(field); return;
            default: return;  // the other fields of the standard do not affect the values
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
        for (auto& [index, read] : characteristics_) {
            QdasCharacteristic& shown = read.shown;
            if (read.lower_kind == 0) shown.lower_limit.reset();  // AQDEF: the limit is not valid
            if (read.upper_kind == 0) shown.upper_limit.reset();
            shown.lower_is_natural = read.lower_kind == 2 && shown.lower_limit;
            shown.upper_is_natural = read.upper_kind == 2 && shown.upper_limit;
            while (!shown.measured.empty() && shown.measured.back().empty()) shown.measured.pop_back();
            file_.characteristics.push_back(std::move(shown));
        }
        return std::move(file_);
    }

private:
    struct Read {
        QdasCharacteristic shown;
        std::optional<std::int64_t> lower_kind, upper_kind;
    };

    Read& at(const FieldLine& field) { return characteristics_[std::max<std::int64_t>(field.index, 1)]; }

    static void setFirst(std::string& word, const std::string& value)
    {
        if (word.empty()) word = value;  // of the first part
    }

    static void add(Read& read, double value)
    {
        read.shown.values.push_back(value);
        read.shown.measured.emplace_back();
    }

    /// An attribute other than 0 marks the preceding value as invalid.
    void mark(const Lines& lines, const FieldLine& field)
    {
        Read& read = at(field);
        if (integerOf(lines, field, 65535) == 0) return;
        if (read.shown.values.empty())
            throw malformed(lines.number(), lines.line(), lines.line(),
                            LT_TEXT("Engine", "a value before its attribute"));
        read.shown.values.back() = std::nan("");
    }

    /// Time of the preceding value; without an index of all characteristics.
    void stamp(const FieldLine& field)
    {
        const auto set = [&field](Read& read) {
            if (!read.shown.measured.empty() && read.shown.measured.back().empty())
                read.shown.measured.back() = field.value;
        };
        if (field.index > 0) return set(at(field));
        for (auto& [index, read] : characteristics_) set(read);
    }

    /// The short form: one line holds a value of each characteristic, followed by attribute and time.
    void takeShortLine(const Lines& lines)
    {
        const std::string_view line = lines.line();
        if (!sawField_)
            throw malformed(lines.number(), line, trimmed(line), LT_TEXT("Engine", "a field such as K0001/1"));
        std::string_view rest = line;
        for (std::int64_t index = 1; index <= mostCharacteristics; ++index) {
            const std::size_t end = std::min(rest.find('\x0F'), rest.size());
            takeShortValue(lines, rest.substr(0, end), index);
            if (end == rest.size()) return;
            rest.remove_prefix(end + 1);
        }
    }

    void takeShortValue(const Lines& lines, std::string_view cell, std::int64_t index)
    {
        std::vector<std::string_view> parts;
        for (std::size_t begin = 0; begin <= cell.size();) {
            const std::size_t end = std::min(cell.find('\x14', begin), cell.size());
            parts.push_back(trimmed(cell.substr(begin, end - begin)));
            begin = end + 1;
        }
        FieldLine field{1, index, parts[0]};
        if (announced_ && index > *announced_)
            throw malformed(lines.number(), lines.line(), cell, LT_TEXT("Engine", "a field such as K0001/1"));
        add(at(field), field.value.empty() ? std::nan("") : numberOf(lines, field));
        if (parts.size() > 1 && !parts[1].empty()) mark(lines, {2, index, parts[1]});
        if (parts.size() > 2) stamp({4, index, parts[2]});
    }

    Error countDiffers(const Lines& lines) const
    {
        return Error(errors::malformed, {{"line", lines.number()},
                                         {"column", std::int64_t{1}},
                                         {"found", characteristics_.rbegin()->first},
                                         {"expected", LT_TEXT("Engine", "as many characteristics as K0100 says")}});
    }

    QdasFile file_;
    std::map<std::int64_t, Read> characteristics_;
    std::optional<std::int64_t> announced_;
    bool sawField_ = false;
};

constexpr Text expectedQdas = LT_TEXT("Engine", "a Q-DAS file with K-fields");

/// Short lines contain control characters, which would be taken as binary data.
DecodedText decodedDfq(std::string_view bytes)
{
    if (isDfq(bytes)) return decodeText(bytes, Encoding::Auto);
    return readableText(bytes, Encoding::Auto, expectedQdas, {});
}

QdasFile readDfqFields(const DecodedText& text)
{
    Lines lines(text.view());
    DfqReader reader;
    while (lines.next())
        if (!trimmed(lines.line()).empty()) reader.take(lines);
    return reader.finish(lines);
}

}  // namespace

bool isDfq(std::string_view bytes)
{
    constexpr std::size_t headBytes = 4096;
    try {
        return looksLikeQdas(decodeText(bytes.substr(0, headBytes), Encoding::Auto).view());
    } catch (const Error&) {
        return false;
    }
}

QdasFile readDfq(const std::string& name, std::string_view bytes)
{
    try {
        return readDfqFields(decodedDfq(bytes));
    } catch (Error& error) {
        error.with("path", name);
        throw;
    }
}

FileFacts readDfqFacts(const std::string& name, std::string_view bytes)
{
    try {
        const DecodedText text = decodedDfq(bytes);
        const QdasFile file = readDfqFields(text);
        FileFacts facts;
        facts.path = name;
        facts.format = "qdas";
        facts.encoding = text.encoding();
        std::int64_t values = 0;
        for (const QdasCharacteristic& c : file.characteristics) values += static_cast<std::int64_t>(c.values.size());
        facts.rows = values;
        set(facts.details, "parts", file.parts);
        set(facts.details, "characteristics", static_cast<std::int64_t>(file.characteristics.size()));
        set(facts.details, "values", values);
        if (!file.part_number.empty()) set(facts.details, "part_number", file.part_number);
        if (!file.part_description.empty()) set(facts.details, "part_description", file.part_description);
        if (!file.machine.empty()) set(facts.details, "machine", file.machine);
        return facts;
    } catch (Error& error) {
        error.with("path", name);
        throw;
    }
}

}  // namespace lathelier::io
