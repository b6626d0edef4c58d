// Dispatch to the readers by content.
#include "engine/io/cloud/scan_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "engine/io/cloud/obj_reader.h"
#include "engine/io/cloud/pcd_reader.h"
#include "engine/io/cloud/ply_header.h"
#include "engine/io/cloud/ply_reader.h"
#include "engine/io/cloud/raw_scan.h"
#include "engine/io/cloud/stl_reader.h"
#include "engine/io/cloud/text_reader.h"
#include "engine/io/file.h"
#include "engine/io/io_codes.h"
#include "engine/io/text/number.h"
#include "engine/io/text/readable_text.h"
#include "engine/io/text/text_lines.h"
#include "engine/io/text/units.h"

namespace lathelier::io {
namespace {

constexpr Text expectedKinds = LT_TEXT("Engine", "points as text, PLY, PCD, STL or OBJ");

/// The first word of the first line that is neither blank nor a remark.
std::string_view firstWord(std::string_view text)
{
    Lines lines(text.substr(0, textHeadBytes));
    std::vector<std::string_view> words;
    while (lines.next()) {
        splitWords(lines.line(), words);
        if (!words.empty() && words[0].front() != '#') return words[0];
    }
    return {};
}

bool looksLikePcd(std::string_view text)
{
    if (text.starts_with("# .PCD")) return true;
    const std::string_view word = firstWord(text);
    return (word == "VERSION" || word == "FIELDS" || word == "COLUMNS") &&
           text.substr(0, textHeadBytes).find("DATA ") != std::string_view::npos;
}

bool looksLikeAsciiStl(std::string_view text)
{
    if (lowerCase(firstWord(text)) != "solid") return false;
    const std::string head = lowerCase(text.substr(0, textHeadBytes));
    return head.find("facet") != std::string::npos || head.find("endsolid") != std::string::npos;
}

bool isObjKeyword(std::string_view word)
{
    static constexpr std::array<std::string_view, 11> keywords = {"v", "vn", "vt",     "vp",     "f", "g",
                                                                  "o", "s",  "mtllib", "usemtl", "l"};
    return std::find(keywords.begin(), keywords.end(), word) != keywords.end();
}

/// Vertices and faces by their keywords, also below an invalid first line, which the OBJ reader then rejects; as a
/// table the faces would be read as points.
bool looksLikeObj(std::string_view text)
{
    const bool startsSo = isObjKeyword(firstWord(text));
    std::size_t vertices = 0, faces = 0, others = 0;
    Lines lines(text.substr(0, textHeadBytes));
    std::vector<std::string_view> words;
    while (lines.next()) {
        splitWords(lines.line(), words);
        if (words.empty() || words[0].front() == '#') continue;
        // A decimal comma is accepted in a vertex.
        const bool isVertex =
            words.size() >= 4 && words[0] == "v" && (wholeNumber(words[1], '.') || wholeNumber(words[1], ','));
        const bool isFace = words.size() >= 4 && words[0] == "f" && words[1].find_first_not_of("-0123456789/") != 0;
        if (startsSo && (isVertex || words[0] == "f")) return true;
        vertices += isVertex ? 1 : 0;
        faces += isFace ? 1U : 0U;
        others += isObjKeyword(words[0]) ? 0U : 1U;
    }
    return vertices >= 3 && (faces > 0 || others * 2 < vertices);
}

std::uint64_t binaryStlSize(std::string_view bytes)
{
    std::uint32_t facets = 0;
    std::memcpy(&facets, bytes.data() + 80, 4);
    return 84 + std::uint64_t{50} * facets;
}

/// A damaged binary STL (size inconsistent with its count) is recognised by its facets: normals of unit length or zero.
bool isDamagedBinaryStl(std::string_view bytes)
{
    if (bytes.size() < 134 || binaryStlSize(bytes) <= 84 || bytes.substr(0, 134).find('\0') == std::string_view::npos)
        return false;
    const std::size_t facets = std::min<std::size_t>((bytes.size() - 84) / 50, 20);
    for (std::size_t i = 0; i < facets; ++i) {
        std::array<float, 12> values{};
        std::memcpy(values.data(), bytes.data() + 84 + 50 * i, sizeof(values));
        const double length =
            std::hypot(static_cast<double>(values[0]), static_cast<double>(values[1]), static_cast<double>(values[2]));
        if (!(length == 0 || std::abs(length - 1) < 0.01)) return false;
        if (!std::all_of(values.begin(), values.end(), [](float value) { return std::abs(value) < 1e9F; }))
            return false;
    }
    return true;
}

using ScanReader = RawScan (*)(const ScanSource&);

ScanReader binaryReader(std::string_view bytes)
{
    // Text in UTF-32 can have the size of an STL whose number of facets is one of its characters.
    if (hasUtf32Mark(bytes)) return nullptr;
    if (bytes.size() >= 84 && binaryStlSize(bytes) == bytes.size()) return readBinaryStl;
    if (startsLikePly(bytes)) {
        const std::string_view head = bytes.substr(0, textHeadBytes);
        if (head.find("format binary") != std::string_view::npos) return readPly;
    }
    if (bytes.starts_with("# .PCD") || firstWord(bytes) == "VERSION" || firstWord(bytes) == "FIELDS") {
        const std::string_view head = bytes.substr(0, textHeadBytes);
        if (head.find("DATA binary") != std::string_view::npos) return readPcd;
    }
    return nullptr;
}

ScanReader textReader(std::string_view text)
{
    if (startsLikePly(text)) return readPly;
    if (looksLikePcd(text)) return readPcd;
    if (looksLikeAsciiStl(text)) return readAsciiStl;
    if (looksLikeObj(text)) return readObj;
    return readTextScan;
}

/// The text reader selected by the file name.
ScanReader readerByName(std::string_view name)
{
    const std::string lower = lowerCase(name.substr(name.size() - std::min<std::size_t>(name.size(), 4)));
    if (lower == ".ply") return readPly;
    if (lower == ".pcd") return readPcd;
    if (lower == ".stl") return readAsciiStl;
    return lower == ".obj" ? readObj : readTextScan;
}

/// By content; without a distinctive format by name, so that a damaged mesh is not read as a table.
ScanFile readAnyScan(const std::string& name, std::string_view bytes, const ImportOptions& options,
                     const Progress& progress)
{
    const Progress reading = progress.part(0, 0.95);
    const auto finish = [&](RawScan raw) { return finishScan(std::move(raw), name, options, progress.part(0.95, 1)); };
    if (bytes.empty()) throw Error(errors::fileEmpty, {});
    refuseForeign(bytes, expectedKinds);
    if (const ScanReader reader = binaryReader(bytes)) return finish(reader({bytes, {}, {}, options, reading}));
    if (isDamagedBinaryStl(bytes)) return finish(readBinaryStl({bytes, {}, {}, options, reading}));
    const DecodedText text = readableText(bytes, options.encoding, expectedKinds, reading);
    ScanReader reader = textReader(text.view());
    if (reader == readTextScan) {
        refuseForeignName(name, false, expectedKinds);
        if (looksLikeQdas(text.view())) throwUnknownFormat(LT_TEXT("Engine", "a Q-DAS file"), expectedKinds);
        reader = readerByName(name);
    }
    return finish(reader({bytes, text.view(), text.encoding(), options, reading}));
}

}  // namespace

bool hasScanFormat(std::string_view bytes)
{
    if (binaryReader(bytes) || isDamagedBinaryStl(bytes)) return true;
    if (!looksLikeText(bytes)) return false;
    const DecodedText text = decodeText(bytes.substr(0, headForKind), Encoding::Auto);
    return textReader(text.view()) != readTextScan;
}

ScanFile readScan(const std::string& name, std::string_view bytes, const ImportOptions& options,
                  const Progress& progress)
{
    try {
        return readAnyScan(name, bytes, options, progress);
    } catch (Error& error) {
        error.with("path", name);
        throw;
    }
}

ScanFile readScan(const std::string& path, const ImportOptions& options, const Progress& progress)
{
    const FileBytes file(path, progress);
    return readScan(path, file.view(), options, progress);
}

}  // namespace lathelier::io
