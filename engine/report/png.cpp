#include "engine/report/png.h"

#include <zlib.h>

#include <new>

namespace lathelier::report {
namespace {

void appendNumber(std::string& out, std::uint32_t number)
{
    for (int shift = 24; shift >= 0; shift -= 8) out += static_cast<char>((number >> shift) & 0xFF);
}

void appendChunk(std::string& out, std::string_view type, const std::string& data)
{
    appendNumber(out, static_cast<std::uint32_t>(data.size()));
    const std::string body = std::string(type) + data;
    out += body;
    appendNumber(out, static_cast<std::uint32_t>(
                          crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()))));
}

std::string compressed(const std::string& raw, int level)
{
    uLongf size = compressBound(static_cast<uLong>(raw.size()));
    std::string result(size, '\0');
    if (compress2(reinterpret_cast<Bytef*>(result.data()), &size, reinterpret_cast<const Bytef*>(raw.data()),
                  static_cast<uLong>(raw.size()), level) != Z_OK)
        throw std::bad_alloc();  // only possible failure: the buffer is always large enough
    result.resize(size);
    return result;
}

}  // namespace

std::string encodePng(const IndexedImage& image)
{
    std::string header;
    appendNumber(header, static_cast<std::uint32_t>(image.width));
    appendNumber(header, static_cast<std::uint32_t>(image.height));
    header += std::string("\x08\x03\x00\x00\x00", 5);  // 8 bits, palette, deflate, no filter choice, not interlaced

    std::string palette;
    for (const Rgb& colour : image.palette)
        for (const std::uint8_t part : {colour.red, colour.green, colour.blue}) palette += static_cast<char>(part);

    std::string rows;
    const auto width = static_cast<std::size_t>(image.width);
    for (std::size_t row = 0; row < static_cast<std::size_t>(image.height); ++row) {
        rows += '\0';  // row filter "none": right for palettes
        rows.append(reinterpret_cast<const char*>(image.pixels.data()) + row * width, width);
    }

    std::string out("\x89PNG\r\n\x1a\n", 8);
    appendChunk(out, "IHDR", header);
    appendChunk(out, "PLTE", palette);
    if (image.transparent >= 0) {
        std::string opacity(static_cast<std::size_t>(image.transparent) + 1, '\xFF');
        opacity.back() = '\0';
        appendChunk(out, "tRNS", opacity);
    }
    appendChunk(out, "IDAT", compressed(rows, Z_BEST_COMPRESSION));
    appendChunk(out, "IEND", {});
    return out;
}

std::string encodePng(const GreyImage& image)
{
    std::string header;
    appendNumber(header, static_cast<std::uint32_t>(image.width));
    appendNumber(header, static_cast<std::uint32_t>(image.height));
    header += static_cast<char>(image.bits);
    header += std::string(4, '\0');  // grey, deflate, no filter choice, not interlaced

    std::string rows;
    const auto width = static_cast<std::size_t>(image.width);
    for (std::size_t i = 0; i < image.samples.size(); ++i) {
        if (i % width == 0) rows += '\0';  // row filter "none"
        if (image.bits == 16) rows += static_cast<char>(image.samples[i] >> 8);
        rows += static_cast<char>(image.samples[i] & 0xFF);
    }
    std::string out("\x89PNG\r\n\x1a\n", 8);
    appendChunk(out, "IHDR", header);
    if (!image.comment.empty()) appendChunk(out, "tEXt", std::string("Comment\0", 8) + image.comment);
    appendChunk(out, "IDAT", compressed(rows, Z_DEFAULT_COMPRESSION));
    appendChunk(out, "IEND", {});
    return out;
}

std::string base64(std::string_view bytes)
{
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string result;
    result.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t there = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = (group << 8) | (k < there ? static_cast<std::uint8_t>(bytes[i + k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k) result += k <= there ? digits[(group >> (18 - 6 * k)) & 63U] : '=';
    }
    return result;
}

}  // namespace lathelier::report
