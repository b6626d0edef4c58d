#include "engine/io/text/readable_text.h"

#include <algorithm>
#include <cctype>
#include <vector>

#include "engine/io/io_codes.h"
#include "engine/io/text/number.h"
#include "engine/io/text/text_lines.h"
#include "engine/io/text/units.h"

namespace lathelier::io {
namespace {

struct Magic {
    std::string_view start;
    Text what;
};

constexpr Text surfaceFile = LT_TEXT("Engine", "a surface height map (SDF, BCR)");
constexpr Text ptxScan = LT_TEXT("Engine", "a PTX scan");

/// Kinds of foreign files that must not be read as a cloud.
const Magic foreign[] = {
    {"\x89PNG", LT_TEXT("Engine", "a PNG picture")},
    {"\xFF\xD8\xFF", LT_TEXT("Engine", "a JPEG picture")},
    {"GIF8", LT_TEXT("Engine", "a GIF picture")},
    {"%PDF", LT_TEXT("Engine", "a PDF document")},
    {"PK\x03\x04", LT_TEXT("Engine", "a ZIP archive or an Office document")},
    {"\x1F\x8B", LT_TEXT("Engine", "a gzip archive")},
    {"7z\xBC\xAF", LT_TEXT("Engine", "a 7z archive")},
    {"\x28\xB5\x2F\xFD", LT_TEXT("Engine", "a zstd archive")},
    {"\xFD"
     "7zXZ",
     LT_TEXT("Engine", "an xz archive")},
    {"ASTM-E57", LT_TEXT("Engine", "an E57 scan")},
    {"LASF", LT_TEXT("Engine", "a LAS scan")},
    {"ISO-10303-21", LT_TEXT("Engine", "a STEP file")},
    {"# vtk DataFile", LT_TEXT("Engine", "a VTK file")},
    {"{\\rtf", LT_TEXT("Engine", "an RTF document")},
    {"<?xml", LT_TEXT("Engine", "an XML document")},
    {"<!DOCTYPE", LT_TEXT("Engine", "an HTML document")},
    {"<!doctype", LT_TEXT("Engine", "an HTML document")},
    {"<html", LT_TEXT("Engine", "an HTML document")},
    {"<HTML", LT_TEXT("Engine", "an HTML document")},
    {"\x7F"
     "ELF",
     LT_TEXT("Engine", "a program")},
    {"SQLite format", LT_TEXT("Engine", "a database")},
    {"TDSm", LT_TEXT("Engine", "a TDMS measurement of LabVIEW")},
    {"TDSh", LT_TEXT("Engine", "a TDMS measurement of LabVIEW")},
    {"\x93NUMPY", LT_TEXT("Engine", "a NumPy array (NPY)")},
    {"\x89HDF\r\n\x1A\n", LT_TEXT("Engine", "an HDF5 file")},
    {"CDF\x01", LT_TEXT("Engine", "a NetCDF file")},
    {"CDF\x02", LT_TEXT("Engine", "a NetCDF file")},
    {"MDF     ", LT_TEXT("Engine", "an MDF measurement")},
    {"fLaC", LT_TEXT("Engine", "a FLAC recording")},
    {"OggS", LT_TEXT("Engine", "an Ogg recording")},
    {"aBCR-1", surfaceFile},
    {"bBCR-1", surfaceFile},
    {"aISO-1", surfaceFile},
    {"bISO-1", surfaceFile},
    {"aNIST-1", surfaceFile},
    {"bNIST-1", surfaceFile},
    {"DIGITAL SURF", LT_TEXT("Engine", "a surface of Digital Surf (SUR)")},
    {"DSCOMPRESSED", LT_TEXT("Engine", "a surface of Digital Surf (SUR)")},
    {"GWYP", LT_TEXT("Engine", "a Gwyddion surface")},
    {"\xD0\xCF\x11\xE0", LT_TEXT("Engine", "an Office document")},
    {"glTF", LT_TEXT("Engine", "a glTF mesh")},
};

/// "RIFF", "RF64" or "RIFX", the size, and "WAVE".
bool looksLikeWav(std::string_view bytes)
{
    if (bytes.size() < 12 || bytes.substr(8, 4) != "WAVE") return false;
    return bytes.starts_with("RIFF") || bytes.starts_with("RIFX") || bytes.starts_with("RF64");
}

/// The header of LabVIEW's LVM, which may follow blank lines and stand in quotes, or its end mark.
bool looksLikeLabView(std::string_view text)
{
    constexpr std::size_t searchedLines = 100;
    Lines lines(text.substr(0, textHeadBytes));
    bool isFirst = true;
    for (std::size_t i = 0; i < searchedLines && lines.next(); ++i) {
        std::string_view line = trimmed(lines.line());
        if (line.starts_with('"')) line.remove_prefix(1);
        if (line.empty()) continue;
        if (isFirst && lowerCase(line.substr(0, 19)) == "labview measurement") return true;
        if (lowerCase(line.substr(0, 17)) == "***end_of_header*") return true;
        isFirst = false;
    }
    return false;
}

/// True when the first lines hold whole numbers, then numbers, as many as stated.
bool haveNumbers(Lines& lines, std::initializer_list<std::size_t> counts, bool whole)
{
    std::vector<std::string_view> words;
    for (const std::size_t count : counts) {
        if (!lines.next()) return false;
        splitWords(lines.line(), words);
        if (words.size() != count) return false;
        for (const std::string_view word : words)
            if (whole ? !wholeInteger(word).has_value() : !wholeNumber(word, '.').has_value()) return false;
    }
    return true;
}

/// Leica's PTX: columns and rows of the grid, the place and three axes of the scanner, a matrix of 4 × 4.
bool looksLikePtx(std::string_view text)
{
    Lines lines(text.substr(0, 4096));
    return haveNumbers(lines, {1, 1}, true) && haveNumbers(lines, {3, 3, 3, 3, 4, 4, 4, 4}, false);
}

/// Meaning of a file extension.
struct Extension {
    std::string_view end;  ///< extension with its point, lower case
    Text what;
    bool holds_scan = false;  ///< a format of the scan reader
};

constexpr Text programText = LT_TEXT("Engine", "the source text of a program");
constexpr Text qdasFile = LT_TEXT("Engine", "a Q-DAS file");
constexpr Text offMesh = LT_TEXT("Engine", "an OFF mesh");
constexpr Text jsonText = LT_TEXT("Engine", "a JSON text");

const Extension foreignExtensions[] = {
    {".ply", LT_TEXT("Engine", "a PLY scan"), true},
    {".pcd", LT_TEXT("Engine", "a PCD scan"), true},
    {".stl", LT_TEXT("Engine", "an STL mesh"), true},
    {".obj", LT_TEXT("Engine", "an OBJ mesh"), true},
    {".off", offMesh},
    {".coff", offMesh},
    {".noff", offMesh},
    {".e57", LT_TEXT("Engine", "an E57 scan")},
    {".ptx", ptxScan},
    {".las", LT_TEXT("Engine", "a LAS scan")},
    {".laz", LT_TEXT("Engine", "a LAS scan")},
    {".step", LT_TEXT("Engine", "a STEP file")},
    {".stp", LT_TEXT("Engine", "a STEP file")},
    {".igs", LT_TEXT("Engine", "an IGES file")},
    {".iges", LT_TEXT("Engine", "an IGES file")},
    {".dxf", LT_TEXT("Engine", "a DXF drawing")},
    {".dfq", qdasFile},
    {".dfd", qdasFile},
    {".dfx", qdasFile},
    {".uff", LT_TEXT("Engine", "a universal file (UFF)")},
    {".unv", LT_TEXT("Engine", "a universal file (UFF)")},
    {".mat", LT_TEXT("Engine", "a MAT file")},
    {".json", jsonText},
    {".nc", LT_TEXT("Engine", "an NC program")},
    {".ngc", LT_TEXT("Engine", "an NC program")},
    {".mpf", LT_TEXT("Engine", "an NC program")},
    {".html", LT_TEXT("Engine", "an HTML document")},
    {".htm", LT_TEXT("Engine", "an HTML document")},
    {".xml", LT_TEXT("Engine", "an XML document")},
    {".md", LT_TEXT("Engine", "a text document")},
    {".c", programText},
    {".cc", programText},
    {".cpp", programText},
    {".cxx", programText},
    {".h", programText},
    {".hpp", programText},
    {".py", programText},
    {".m", programText},
    {".js", programText},
    {".ts", programText},
    {".java", programText},
    {".cs", programText},
    {".go", programText},
    {".rs", programText},
    {".f90", programText},
    {".sh", programText},
    {".bat", programText},
    {".cmake", programText},
    {".bas", programText},
};

/// "OFF", "COFF", "STCN4OFF"… after blank lines and remarks.
bool looksLikeOff(std::string_view text)
{
    Lines lines(text.substr(0, textHeadBytes));
    while (lines.next()) {
        std::string_view word = trimmed(lines.line());
        if (word.empty() || word.front() == '#') continue;
        word = word.substr(0, word.find_first_of(" \t#"));
        for (const std::string_view prefix : {"ST", "C", "N", "4", "n"})
            if (word.size() > 3 && word.starts_with(prefix)) word.remove_prefix(prefix.size());
        return word == "OFF";
    }
    return false;
}

bool isWord(std::string_view text)
{
    const auto fits = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.'; };
    return !text.empty() && std::all_of(text.begin(), text.end(), fits);
}

/// "import numpy as np", "from math import pi"
bool isPythonImport(std::string_view line)
{
    std::vector<std::string_view> words;
    splitWords(line, words);
    if (words.size() < 2 || !isWord(words[1])) return false;
    if (words[0] == "import") return words.size() == 2 || (words.size() == 4 && words[2] == "as");
    return words[0] == "from" && words.size() >= 4 && words[2] == "import";
}

/// A line specific to source code or JSON.
bool isProgramLine(std::string_view line)
{
    line = trimmed(line);
    if (line.empty()) return false;
    for (const std::string_view start : {"#include <", "#include \"", "#pragma ", "#define ", "#ifndef ", "#ifdef ",
                                         "#!/", "using namespace ", "namespace ", "template <", "public class "})
        if (line.starts_with(start)) return true;
    for (const std::string_view whole : {"}", "};", "},", "})", "});", "];", "]);", "{", "[", "]", "],"})
        if (line == whole) return true;
    if (line.ends_with('{') || line.ends_with("= [") || line.ends_with("=[") || line.ends_with("([") ||
        line.ends_with("= (") || line.ends_with("};") || line.ends_with(": ["))
        return true;
    if (line.starts_with("def ") && line.ends_with(':')) return true;
    return isPythonImport(line);
}

std::string_view endOf(std::string_view text, std::size_t bytes)
{
    return text.substr(text.size() - std::min(text.size(), bytes));
}

/// Zero padding up to a disk cluster is accepted; more indicates a file of another kind.
void refuseLongFilling(std::string_view bytes, Text expected)
{
    constexpr std::size_t largestFilling = textHeadBytes;
    if (bytes.size() <= largestFilling) return;
    const std::string_view end = endOf(bytes, largestFilling);
    if (end.find_first_not_of(std::string_view("\0\x1a", 2)) != std::string_view::npos) return;
    throw Error(errors::formatUnknown, {{"byte", static_cast<std::int64_t>(bytes.size() - largestFilling)},
                                        {"found", LT_TEXT("Engine", "nothing but zero bytes to the end")},
                                        {"expected", expected}});
}

}  // namespace

void throwUnknownFormat(Text found, Text expected)
{
    throw Error(errors::formatUnknown, {{"byte", std::int64_t{0}}, {"found", found}, {"expected", expected}});
}

void refuseForeign(std::string_view bytes, Text expected)
{
    for (const Magic& magic : foreign)
        if (bytes.starts_with(magic.start)) throwUnknownFormat(magic.what, expected);
    if (looksLikeWav(bytes)) throwUnknownFormat(LT_TEXT("Engine", "a WAV recording"), expected);
    if (looksLikeOff(bytes)) throwUnknownFormat(offMesh, expected);
    if (looksLikeLabView(bytes)) throwUnknownFormat(LT_TEXT("Engine", "a LabVIEW measurement (LVM)"), expected);
    if (looksLikePtx(bytes)) throwUnknownFormat(ptxScan, expected);
}

void refuseForeignName(std::string_view name, bool isTable, Text expected)
{
    const std::string lower = lowerCase(name.substr(name.size() - std::min<std::size_t>(name.size(), 8)));
    for (const Extension& extension : foreignExtensions)
        if (lower.size() > extension.end.size() && lower.ends_with(extension.end) && (isTable || !extension.holds_scan))
            throwUnknownFormat(extension.what, expected);
}

void refuseProgram(std::string_view text, Text expected)
{
    Lines lines(text.substr(0, textHeadBytes));
    while (lines.next())
        if (isProgramLine(lines.line()))
            throw Error(errors::formatUnknown, {{"line", lines.number()},
                                                {"column", std::int64_t{1}},
                                                {"found", LT_TEXT("Engine", "the source text of a program or JSON")},
                                                {"expected", expected}});
}

bool looksLikeQdas(std::string_view text)
{
    Lines lines(text.substr(0, textHeadBytes));
    while (lines.next()) {
        const std::string_view line = trimmed(lines.line());
        if (line.empty()) continue;
        if (line.size() < 7 || line.front() != 'K') return false;
        const bool digits = line.find_first_not_of("0123456789", 1) == 5;
        return digits && (line[5] == ' ' || line[5] == '/' || line[5] == '\t');
    }
    return false;
}

DecodedText readableText(std::string_view bytes, Encoding encoding, Text expected, const Progress& progress)
{
    if (bytes.empty()) throw Error(errors::fileEmpty, {});
    refuseForeign(bytes, expected);
    refuseLongFilling(bytes, expected);
    if (!looksLikeText(bytes)) throwUnknownFormat(LT_TEXT("Engine", "binary data"), expected);
    DecodedText text = decodeText(bytes, encoding, progress);
    if (text.view().empty()) throw Error(errors::fileEmpty, {});
    refuseForeign(trimmed(text.view().substr(0, textHeadBytes)), expected);
    return text;
}

DecodedText readableTable(std::string_view name, std::string_view bytes, Encoding encoding, Text expected,
                          const Progress& progress)
{
    refuseForeignName(name, true, expected);
    DecodedText text = readableText(bytes, encoding, expected, progress);
    if (looksLikeQdas(text.view())) throwUnknownFormat(qdasFile, expected);
    refuseProgram(text.view(), expected);
    return text;
}

}  // namespace lathelier::io
