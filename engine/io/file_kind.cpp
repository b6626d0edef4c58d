#include "engine/io/file_kind.h"

#include "engine/io/io_codes.h"
#include "engine/io/text_lines.h"

namespace lathelier {
namespace {

constexpr std::size_t headBytes = 65536;

struct Magic {
    std::string_view start;
    Text what;
};

/// Files that a person may well drop here, and that must not be mistaken for a cloud.
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
    {"OFF\n", LT_TEXT("Engine", "an OFF mesh")},
    {"OFF\r", LT_TEXT("Engine", "an OFF mesh")},
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
};

}  // namespace

void throwUnknownFormat(Text found, Text expected)
{
    throw Error(errors::formatUnknown, {{"byte", std::int64_t{0}}, {"found", found}, {"expected", expected}});
}

void refuseForeign(std::string_view bytes, Text expected)
{
    for (const Magic& magic : foreign)
        if (bytes.starts_with(magic.start)) throwUnknownFormat(magic.what, expected);
}

DecodedText readableText(std::string_view bytes, Encoding encoding, Text expected, const Progress& progress)
{
    if (bytes.empty()) throw Error(errors::fileEmpty, {});
    refuseForeign(bytes, expected);
    if (!looksLikeText(bytes)) throwUnknownFormat(LT_TEXT("Engine", "binary data"), expected);
    DecodedText text = decodeText(bytes, encoding, progress);
    if (text.view().empty()) throw Error(errors::fileEmpty, {});
    refuseForeign(trimmed(text.view().substr(0, headBytes)), expected);
    return text;
}

}  // namespace lathelier
