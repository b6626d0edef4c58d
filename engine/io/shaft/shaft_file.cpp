#include "engine/io/shaft/shaft_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/io/file.h"
#include "engine/io/io_codes.h"
#include "engine/io/json/json_fields.h"
#include "engine/io/text/encoding.h"
#include "engine/io/text/number.h"
#include "engine/io/text/text_lines.h"
#include "engine/shaft/shaft_codes.h"
#include "engine/shaft/shaft_contour.h"
#include "engine/shaft/shaft_rules.h"

namespace lathelier::io {
namespace {

constexpr int piecesOfBore = 50;
constexpr int conesOfArc = 50;

void checkSchema(const JsonCursor& root)
{
    if (const auto schema = root.member("schema"); schema && schema->string() != "lathelier-shaft")
        schema->reject(LT_TEXT("Engine", "“lathelier-shaft”"));
    if (const auto version = root.member("schema_version"); version && version->integer() != 1)
        version->reject(LT_TEXT("Engine", "version 1"));
}

/// One line of a stock file.
struct StockLine {
    double start_radius_mm, start_bore_mm, end_radius_mm, end_bore_mm, length_mm;
};

constexpr double largestNumber_mm = 1e5;  // as for the rows of a SHAFT.json

StockLine stockLine(const Lines& lines, std::string_view content)
{
    const Text expected =
        LT_TEXT("Engine", "outer and bore radius at the start, outer and bore radius at the end, length");
    std::vector<std::string_view> words;
    splitWords(content, words);
    std::array<double, 5> numbers{};
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i >= numbers.size()) throw malformed(lines.number(), lines.line(), words[i], expected);
        const auto value = wholeNumber(words[i], '.');
        if (!value || !std::isfinite(*value) || *value < 0)
            throw malformed(lines.number(), lines.line(), words[i], LT_TEXT("Engine", "a number that is 0 or more"));
        if (*value > largestNumber_mm)
            throw malformed(lines.number(), lines.line(), words[i], LT_TEXT("Engine", "at most 100 000 mm"));
        numbers[i] = *value;
    }
    if (words.size() < numbers.size())
        throw malformed(lines.number(), lines.line(), lines.line().substr(lines.line().size()), expected);
    for (const std::size_t end : {std::size_t{0}, std::size_t{2}})
        if (numbers[4] > 0 && numbers[end + 1] >= numbers[end])
            throw malformed(lines.number(), lines.line(), words[end + 1],
                            LT_TEXT("Engine", "a bore radius below the outer radius"));
    return {numbers[0], numbers[1], numbers[2], numbers[3], numbers[4]};
}

void append(const StockLine& line, std::vector<ShaftSegment>& segments)
{
    const int pieces = line.start_bore_mm == line.end_bore_mm ? 1 : piecesOfBore;
    const auto between = [pieces](double start, double end, double piece) {
        return start + (end - start) * piece / pieces;
    };
    for (int i = 0; i < pieces; ++i)
        segments.push_back({line.length_mm / pieces, 2 * between(line.start_radius_mm, line.end_radius_mm, i),
                            2 * between(line.start_radius_mm, line.end_radius_mm, i + 1),
                            2 * between(line.start_bore_mm, line.end_bore_mm, i + 0.5), std::nullopt, ""});
}

/// Removes empty entries: null, empty strings, lists and objects, and bores of zero diameter.
void forgetEmpty(Json& json)
{
    for (auto member = json.begin(); member != json.end();) {
        if (member->is_structured()) forgetEmpty(*member);
        const bool solid = json.is_object() && member.key() == "bore_diameter_mm" && *member == 0.0;
        const bool empty = member->is_null() || (member->is_structured() && member->empty()) ||
                           (member->is_string() && member->get_ref<const std::string&>().empty());
        member = json.is_object() && (solid || empty) ? json.erase(member) : std::next(member);
    }
}

}  // namespace

Shaft readShaft(const std::string& json, Notes& notes)
{
    const JsonDocument document{json};
    return readShaft(document.root(), notes);
}

Shaft readShaft(const JsonCursor& object, Notes& notes)
{
    checkSchema(object);
    // Length and volume follow from the rows; stating them in the file is accepted.
    auto shaft = readFields<Shaft>(object, notes, {"schema", "schema_version", "length_mm", "volume_mm3"});
    for (const ShaftMark& mark : shaft.marks)
        if (mark.kind == MarkKind::Unexplained)
            notes.push_back({notes::shaftUnexplained,
                             {{"z_start_mm", mark.z_start_mm.value_or(0)}, {"z_end_mm", mark.z_end_mm.value_or(0)}}});
    return shaft;
}

Material readMaterial(const std::string& json, Notes& notes)
{
    const JsonDocument document{json};
    return readFields<Material>(document.root(), notes);
}

Shaft readStock(std::string_view text)
{
    Shaft shaft;
    for (Lines lines(text); lines.next();) {
        const std::string_view content = trimmed(lines.line().substr(0, lines.line().find('#')));
        if (!content.empty()) append(stockLine(lines, content), shaft.segments);
    }
    if (!(shaft.length_mm() > 0)) throw Error(errors::shaftEmpty, {});
    return shaft;
}

Shaft readShaftFile(std::string_view bytes, Notes& notes, const Progress& progress)
{
    const DecodedText text = decodeText(bytes, Encoding::Auto, progress);
    const std::string_view content = trimmed(text.view());
    if (content.empty()) throw Error(errors::fileEmpty, {});
    const std::size_t first = content.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos || content[first] != '{') return readStock(text.view());
    const Shaft shaft = readShaft(std::string(text.view()), notes);
    checkBores(shaft);
    return beamView(shaft);
}

std::string shaftText(const Shaft& shaft)
{
    Json root = objectOf(infos<Shaft>(), lathelier::toValues(shaft));
    forgetEmpty(root);
    root["schema"] = "lathelier-shaft";
    root["schema_version"] = 1;
    return root.dump(2) + "\n";
}

std::string stockText(const Shaft& shaft)
{
    std::string text;
    const auto line = [&text](std::initializer_list<double> numbers) {
        for (const double number : numbers)
            text.append(text.empty() || text.back() == '\n' ? "" : " ").append(Json(number).dump());
        text += '\n';
    };
    for (const ShaftSegment& segment : shaft.segments) {
        const ContourPiece contour{{0, segment.start_diameter_mm / 2},
                                   {segment.length_mm, segment.end_diameter_mm / 2},
                                   segment.arc_radius_mm.value_or(0)};
        const int pieces = segment.arc_radius_mm && segment.length_mm > 0 ? conesOfArc : 1;
        const double bore_mm = segment.bore_diameter_mm / 2;
        const double step_mm = segment.length_mm / pieces;
        for (int i = 0; i < pieces; ++i) {
            const bool first = i == 0, last = i + 1 == pieces;
            line({first ? segment.start_diameter_mm / 2 : contour.radiusAt_mm(i * step_mm), bore_mm,
                  last ? segment.end_diameter_mm / 2 : contour.radiusAt_mm((i + 1) * step_mm), bore_mm, step_mm});
        }
    }
    return text;
}

}  // namespace lathelier::io
