#include "engine/io/image/image.h"

#include "engine/io/image/image_canvas.h"
#include "engine/io/io_codes.h"

namespace lathelier::io {
namespace {

constexpr std::string_view pngHead("\x89PNG\r\n\x1a\n", 8);
constexpr std::string_view jpegHead("\xFF\xD8\xFF", 3);

bool isTiff(std::string_view head)
{
    using namespace std::string_view_literals;
    for (const std::string_view begin : {"II*\0"sv, "MM\0*"sv, "II+\0"sv, "MM\0+"sv})
        if (head.starts_with(begin)) return true;
    return false;
}

}  // namespace

bool isImage(std::string_view head)
{
    return head.starts_with(pngHead) || head.starts_with(jpegHead) || isTiff(head);
}

Image readImage(const std::string& name, std::string_view bytes, const Progress& progress)
{
    try {
        if (bytes.empty()) throw Error(errors::fileEmpty, {});
        if (bytes.starts_with(pngHead)) return readPng(name, bytes, progress);
        if (bytes.starts_with(jpegHead)) return readJpeg(name, bytes, progress);
        if (isTiff(bytes)) return readTiff(name, bytes, progress);
        throw Error(errors::formatUnknown, {{"byte", std::int64_t{0}},
                                            {"found", LT_TEXT("Engine", "something else")},
                                            {"expected", std::string(imageExpected)}});
    } catch (Error& error) {
        error.with("path", name);
        throw;
    }
}

FileFacts imageFacts(const std::string& name, const Image& image)
{
    FileFacts facts;
    facts.path = name;
    facts.format = image.format;
    facts.details = {{"width", std::int64_t{image.width}},
                     {"height", std::int64_t{image.height}},
                     {"bits", std::int64_t{image.bits}},
                     {"channels", std::int64_t{image.channels}},
                     {"orientation", std::int64_t{image.orientation}}};
    if (image.um_per_px > 0) facts.details.emplace_back("um_per_px", image.um_per_px);
    return facts;
}

}  // namespace lathelier::io
