#include "engine/io/shaft/shaft_kind.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "engine/io/json/json_head.h"
#include "engine/io/shaft/shaft_file.h"
#include "engine/io/text/encoding.h"
#include "engine/io/text/number.h"
#include "engine/io/text/text_lines.h"
#include "engine/io/text/units.h"

namespace lathelier::io {
namespace {

constexpr std::size_t mostStockLines = 200;  ///< longer tables of five columns are more likely measurements than a
                                             ///< stock

bool hasStockName(const std::string& path)
{
    const std::string extension = lowerCase(std::filesystem::path(path).extension().string());
    return extension.empty() || extension == ".txt" || extension == ".stock";
}

/// Five numbers that are the outer and bore radius at both ends, and a length.
bool isStockLine(const std::vector<std::string_view>& words)
{
    std::array<double, 5> numbers{};
    if (words.size() != numbers.size()) return false;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const auto number = wholeNumber(words[i], '.');
        if (!number || !(*number >= 0) || !std::isfinite(*number)) return false;
        numbers[i] = *number;
    }
    return numbers[4] == 0 || (numbers[1] < numbers[0] && numbers[3] < numbers[2]);
}

/// Every line of the whole file is one of a stock file.
bool isStock(std::string_view head)
{
    if (head.size() >= headForKind) return false;
    const DecodedText text = decodeText(head, Encoding::Auto);
    std::vector<std::string_view> words;
    std::size_t found = 0;
    for (Lines lines(text.view()); lines.next();) {
        splitWords(trimmed(lines.line().substr(0, lines.line().find('#'))), words);
        if (words.empty()) continue;
        if (!isStockLine(words) || ++found > mostStockLines) return false;
    }
    return found > 0;
}

Likeness likeShaft(const std::string& path, std::string_view head, const Values&)
{
    const std::vector<std::string> keys = keysOfHead(head);
    if (hasKey(keys, "segments") && !hasKey(keys, "command")) return Likeness::Certain;
    try {
        if (hasStockName(path) && looksLikeText(head) && isStock(head)) return Likeness::Likely;
    } catch (const Error&) {
        return Likeness::No;  // a line is too long, or the bytes are not text
    }
    return Likeness::No;
}

double largestDiameter_mm(const Shaft& shaft)
{
    double largest_mm = 0;
    for (const ShaftSegment& segment : shaft.segments)
        largest_mm = std::max({largest_mm, segment.start_diameter_mm, segment.end_diameter_mm});
    return largest_mm;
}

}  // namespace

ShaftFile loadShaft(const FileToRead& file)
{
    ShaftFile loaded;
    try {
        loaded.shaft = readShaftFile(file.bytes, loaded.notes, file.progress);
    } catch (Error& error) {
        throw error.with("path", file.path);
    }
    for (Note& note : loaded.notes) set(note.values, "path", file.path);
    const Shaft& shaft = loaded.shaft;
    FileFacts& facts = loaded.facts;
    facts.path = file.path;
    facts.format = keysOfHead(file.bytes.substr(0, headForKind)).empty() ? "stock" : "shaft_json";
    facts.unit = "mm";
    facts.unit_source = "stated";
    if (!shaft.name.empty()) set(facts.details, "name", shaft.name);
    set(facts.details, "segments", static_cast<std::int64_t>(shaft.segments.size()));
    set(facts.details, "length_mm", shaft.length_mm());
    set(facts.details, "largest_diameter_mm", largestDiameter_mm(shaft));
    if (shaft.material) set(facts.details, "material", shaft.material->name);
    return loaded;
}

const FileKind& shaftFiles()
{
    static const FileKind kind{"shaft",
                               LT_TEXT("Engine", "Shafts"),
                               "*.json *.txt *.stock",
                               {},
                               {},
                               likeShaft,
                               [](const FileToRead& file, Notes& notes) {
                                   ShaftFile loaded = loadShaft(file);
                                   notes.insert(notes.end(), loaded.notes.begin(), loaded.notes.end());
                                   return std::move(loaded.facts);
                               }};
    return kind;
}

}  // namespace lathelier::io
