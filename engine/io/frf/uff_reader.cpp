#include <algorithm>
#include <cmath>

#include "engine/io/frf/frf_codes.h"
#include "engine/io/frf/uff.h"
#include "engine/io/frf/uff_fields.h"
#include "engine/io/frf/uff_function.h"
#include "engine/io/io_codes.h"
#include "engine/io/text/number.h"

namespace lathelier::io {
namespace {

using enum UffColumn::Kind;

constexpr UffColumn unitColumns[] = {{10, Integer}, {20, Word}, {10, Integer}};
constexpr int factorWidths[] = {25, 25, 25};
constexpr UffColumn node15Columns[] = {{10, Integer}, {10, Integer}, {10, Integer}, {10, Integer},
                                       {13, Real},    {13, Real},    {13, Real}};
constexpr UffColumn node2411Columns[] = {{10, Integer}, {10, Integer}, {10, Integer}, {10, Integer}};
constexpr int placeWidths[] = {25, 25, 25};
constexpr Text expectedSet = LT_TEXT("Engine", "a data set between separators: -1 in columns 5 and 6");

/// Padding at the end of a file.
bool isFilling(std::string_view line)
{
    return line.find_first_not_of(std::string_view(" \t\0\x1a", 4)) == std::string_view::npos;
}

/// The number of a set, "58" or "58b"; empty when the line is not one.
std::string setTypeOf(std::string_view line)
{
    const std::string_view number = trimmed(line.substr(0, std::min<std::size_t>(line.size(), 6)));
    const auto value = wholeInteger(number);
    if (!value || *value < 1) return {};
    const char mark = line.size() > 6 ? line[6] : ' ';
    if (mark == 'b' || mark == 'B') return std::string(number) + 'b';
    return isBlank(mark) && trimmed(line).size() == number.size() ? std::string(number) : std::string();
}

class UffReader {
public:
    UffReader(std::string_view bytes, const Progress& progress)
        : bytes_(bytes), progress_(progress), lines_(bytes, bytes.starts_with("\xEF\xBB\xBF") ? 3 : 0)
    {
    }

    UffFile read()
    {
        while (nextLine()) {
            progress_.report(static_cast<double>(lines_.offset()) / static_cast<double>(bytes_.size()));
            if (isFilling(lines_.line())) continue;
            if (!isUffSeparator(lines_.line())) {
                passOutside();
                continue;
            }
            if (nextLine() && !isFilling(lines_.line())) readSet();
        }
        if (outside_ > 0 && file_.sets.empty())
            throw malformed(outsideLine_, outsideText_, trimmed(outsideText_), expectedSet);
        if (outside_ > 0) file_.notes.push_back({notes::uffTextOutside, {{"line", outsideLine_}, {"count", outside_}}});
        for (UffSet& set : file_.sets)
            if (set.function && !set.function->units) set.function->units = file_.units;
        return std::move(file_);
    }

private:
    bool nextLine() { return lines_.next(); }

    /// `lines_` is at the number of the set, afterwards at its closing separator.
    void readSet()
    {
        UffSet set;
        set.type = setTypeOf(lines_.line());
        if (set.type.empty())
            throw malformed(lines_.number(), lines_.line(), trimmed(lines_.line()),
                            LT_TEXT("Engine", "the number of a data set"));
        set.line = lines_.number();
        set.byte = static_cast<std::int64_t>(lines_.offset());
        if (set.type == "58") {
            set.function = readUffText(lines_, progress_);
            set.function->units = units_;
            pass(set.line);
        } else if (set.type.ends_with('b')) {
            readBinary(set);
        } else if (set.type == "164") {
            readUnits();
        } else if (set.type == "15" || set.type == "2411") {
            readNodes(set.type == "15");
        } else {
            pass(0);
        }
        file_.sets.push_back(std::move(set));
    }

    void readBinary(UffSet& set)
    {
        const UffBinary binary = readUffBinary(lines_);
        if (set.type == "58b") {
            set.function = readUffBinary(lines_, bytes_, binary);
            set.function->units = units_;
        } else {
            for (std::int64_t k = 0; k < binary.header_lines; ++k)
                if (!nextLine()) throw malformedEnd(lines_, expectedSet);
        }
        const std::size_t begin = lines_.nextOffset();
        const std::string_view payload = uffPayload(bytes_, begin, binary);
        std::size_t end = begin + payload.size();
        std::int64_t number = lines_.number() + std::count(payload.begin(), payload.end(), '\n');
        for (; end < bytes_.size() && (bytes_[end] == '\r' || bytes_[end] == '\n'); ++end)
            number += bytes_[end] == '\n' ? 1 : 0;
        lines_ = Lines(bytes_, end, number + 1);
        if (!nextLine()) return;
        if (!isUffSeparator(lines_.line()))
            throw Error(errors::malformed, {{"byte", static_cast<std::int64_t>(end)},
                                            {"found", excerptOf(lines_.line())},
                                            {"expected", LT_TEXT("Engine", "a separator behind the stated bytes")}});
    }

    static std::string excerptOf(std::string_view line)
    {
        std::string text = uffText(line.substr(0, 40));
        for (char& c : text) c = static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
        return text;
    }

    /// Goes to the closing separator. `line`: line of a set of which only padding should remain.
    void pass(std::int64_t line)
    {
        bool isMore = false;
        while (nextLine() && !isUffSeparator(lines_.line())) isMore = isMore || !trimmed(lines_.line()).empty();
        if (!isMore || line == 0) return;
        if (file_.notes.empty()) file_.notes.push_back({notes::uffDataBeyond, {{"line", line}}});
        set(file_.notes.front().values, "count", ++beyond_);
    }

    /// A line of text outside the sets, which the format allows. Error malformed for numbers and for the head of a set:
    /// a separator is missing or stands too early.
    void passOutside()
    {
        std::vector<std::string_view> words;
        splitWords(lines_.line(), words);
        const auto isNumber = [](std::string_view word) { return wholeNumber(word, '.').has_value(); };
        if (std::all_of(words.begin(), words.end(), isNumber) || !setTypeOf(lines_.line()).empty())
            throw malformed(lines_.number(), lines_.line(), trimmed(lines_.line()), expectedSet);
        if (outside_++ > 0) return;
        outsideLine_ = lines_.number();
        outsideText_ = lines_.line();
    }

    /// The next line of the set, false at its end.
    bool nextOfSet() { return nextLine() && !isUffSeparator(lines_.line()); }

    void readUnits()
    {
        constexpr Text expected = LT_TEXT("Engine", "the factors of units, larger than 0");
        if (!nextOfSet()) throw malformed(lines_.number(), lines_.line(), lines_.line(), expected);
        const UffFields fields(lines_.number(), lines_.line(), unitColumns);
        std::vector<double> factors;
        if (!nextOfSet()) throw malformed(lines_.number(), lines_.line(), lines_.line(), expected);
        readUffNumbers(lines_.number(), lines_.line(), factorWidths, factors);
        if (factors.size() < 2 || !(factors[0] > 0) || !(factors[1] > 0))
            throw malformed(lines_.number(), lines_.line(), trimmed(lines_.line()), expected);
        units_ = UffUnits{fields.integer(0), fields.text(1), factors[0], factors[1]};
        if (!file_.units) file_.units = units_;
        pass(0);
    }

    void readNodes(bool is15)
    {
        while (nextOfSet()) {
            if (trimmed(lines_.line()).empty()) continue;
            UffNode node;
            if (is15) {
                const UffFields fields(lines_.number(), lines_.line(), node15Columns);
                node = {fields.integer(0), {fields.number(4), fields.number(5), fields.number(6)}};
            } else {
                const UffFields fields(lines_.number(), lines_.line(), node2411Columns);
                std::vector<double> place;
                constexpr Text expected = LT_TEXT("Engine", "the place of a node");
                if (!nextOfSet()) throw malformed(lines_.number(), lines_.line(), lines_.line(), expected);
                readUffNumbers(lines_.number(), lines_.line(), placeWidths, place);
                if (place.size() != 3)
                    throw malformed(lines_.number(), lines_.line(), trimmed(lines_.line()), expected);
                node = {fields.integer(0), {place[0], place[1], place[2]}};
            }
            file_.nodes.push_back(node);
        }
    }

    std::string_view bytes_;
    const Progress& progress_;
    Lines lines_;
    UffFile file_;
    std::optional<UffUnits> units_;
    std::int64_t outside_ = 0, outsideLine_ = 0;  // lines of text between sets, the first of them
    std::string_view outsideText_;
    std::int64_t beyond_ = 0;  // number of sets with more values than declared
};

}  // namespace

bool isUff(std::string_view head)
{
    if (head.starts_with("\xEF\xBB\xBF")) head.remove_prefix(3);
    try {
        Lines lines(head.substr(0, 4096));
        bool isFirst = true;
        while (lines.next()) {
            if (trimmed(lines.line()).empty()) continue;
            // Behind other lines only the exact columns of a separator count.
            const bool separates = isFirst ? isUffSeparator(lines.line()) && lines.line().front() == ' '
                                           : lines.line().starts_with("    -1") && trimmed(lines.line()) == "-1";
            if (separates && lines.next()) {
                const bool isInColumns =
                    lines.line().size() >= 6 && lines.line().front() == ' ' && detail::isDigit(lines.line()[5]);
                if (!setTypeOf(lines.line()).empty() && (isFirst || isInColumns)) return true;
            }
            if (isFirst && separates) return false;
            isFirst = false;
        }
        return false;
    } catch (const Error&) {
        return false;
    }
}

UffFile readUff(std::string_view bytes, const Progress& progress)
{
    if (bytes.empty()) throw Error(errors::fileEmpty, {});
    UffFile file = UffReader(bytes, progress).read();
    if (file.sets.empty())
        throw Error(errors::formatUnknown, {{"byte", std::int64_t{0}},
                                            {"found", LT_TEXT("Engine", "no data set")},
                                            {"expected", LT_TEXT("Engine", "a universal file (UFF)")}});
    return file;
}

}  // namespace lathelier::io
