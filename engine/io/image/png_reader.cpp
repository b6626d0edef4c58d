// PNG by libpng (W3C PNG Specification, 3rd edition). The chunks are scanned beforehand, so that size, orientation and
// colour profile are known and limits are checked before libpng is called.
#include <png.h>

#include <array>
#include <csetjmp>
#include <cstring>

#include "engine/io/image/image_canvas.h"
#include "engine/io/image/image_codes.h"
#include "engine/io/io_codes.h"

namespace lathelier::io {
namespace {

constexpr std::size_t signatureSize = 8;
constexpr std::size_t chunkFrame = 12;  // bytes of length, type and checksum of a chunk

/// Content of the chunks before decoding.
struct PngFacts {
    ImageHeader header;
    int orientation = 1;
    bool has_profile = false;
    bool has_alpha = false;
    double um_per_px = 0;  ///< by a pHYs chunk in pixels per metre; 0: none
};

std::uint32_t numberAt(std::string_view bytes, std::size_t at)
{
    std::uint32_t result = 0;
    for (std::size_t i = 0; i < 4; ++i) result = result << 8 | static_cast<std::uint8_t>(bytes[at + i]);
    return result;
}

void readPngHeader(std::string_view data, std::size_t byte, std::size_t file_bytes, PngFacts& facts)
{
    if (data.size() != 13)
        throw Error(errors::malformed, {{"byte", static_cast<std::int64_t>(byte)},
                                        {"found", static_cast<std::int64_t>(data.size())},
                                        {"expected", LT_TEXT("Engine", "an IHDR chunk of 13 bytes")}});
    const int colour = static_cast<std::uint8_t>(data[9]);
    facts.header = {numberAt(data, 0), numberAt(data, 4), static_cast<std::uint8_t>(data[8]),
                    colour == 2   ? 3
                    : colour == 6 ? 4
                    : colour == 4 ? 2
                                  : 1};
    facts.has_alpha = colour == 4 || colour == 6;
    checkHeader(facts.header, file_bytes, byte);
}

PngFacts walkChunks(std::string_view bytes)
{
    PngFacts facts;
    bool has_header = false;
    std::size_t at = signatureSize;
    while (at + chunkFrame <= bytes.size()) {
        const std::size_t length = numberAt(bytes, at);
        const std::string_view type = bytes.substr(at + 4, 4);
        const std::string_view data = bytes.substr(at + 8, std::min(length, bytes.size() - at - 8));
        if (!has_header) {
            if (type != "IHDR")
                throw Error(errors::malformed, {{"byte", static_cast<std::int64_t>(at + 4)},
                                                {"found", LT_TEXT("Engine", "another chunk")},
                                                {"expected", LT_TEXT("Engine", "an IHDR chunk")}});
            readPngHeader(data, at + 8, bytes.size(), facts);
            has_header = true;
        }
        if (type == "iCCP") facts.has_profile = true;
        if (type == "tRNS") facts.has_alpha = true;
        if (type == "pHYs" && data.size() == 9 && data[8] == 1 && numberAt(data, 0) == numberAt(data, 4) &&
            numberAt(data, 0) > 0)
            facts.um_per_px = 1e6 / numberAt(data, 0);
        if (type == "eXIf") facts.orientation = exifOrientation(data);
        if (length > bytes.size() - at - chunkFrame) break;
        at += length + chunkFrame;
    }
    if (!has_header)
        throw Error(
            errors::imageEndsEarly,
            {{"byte", static_cast<std::int64_t>(bytes.size())}, {"row", std::int64_t{0}}, {"expected", Value()}});
    return facts;
}

/// State shared with the callbacks of libpng. Trivially destructible, as longjmp requires.
struct PngDecoder {
    png_structp png = nullptr;
    png_infop info = nullptr;
    const char* bytes = nullptr;
    std::size_t size = 0;
    std::size_t at = 0;
    int row = 0;
    bool ended = false;
    std::array<char, 120> message{};

    PngDecoder() = default;
    PngDecoder(const PngDecoder&) = delete;
    PngDecoder& operator=(const PngDecoder&) = delete;
    ~PngDecoder() { png_destroy_read_struct(&png, &info, nullptr); }
};

[[noreturn]] void failPng(png_structp png, png_const_charp message)
{
    auto* decoder = static_cast<PngDecoder*>(png_get_error_ptr(png));
    std::strncpy(decoder->message.data(), message, decoder->message.size() - 1);
    png_longjmp(png, 1);
}

void givePng(png_structp png, png_bytep out, std::size_t count)
{
    auto* decoder = static_cast<PngDecoder*>(png_get_io_ptr(png));
    if (count > decoder->size - decoder->at) {
        decoder->at = decoder->size;
        decoder->ended = true;
        png_error(png, "end of file");
    }
    std::memcpy(out, decoder->bytes + decoder->at, count);
    decoder->at += count;
}

/// Prepares reading; true when the rows can be read as `channels` samples of one or two bytes.
bool beginPng(PngDecoder& decoder)
{
    if (setjmp(png_jmpbuf(decoder.png))) return false;  // NOLINT(cert-err52-cpp): libpng leaves by longjmp only
    png_set_read_fn(decoder.png, &decoder, givePng);
    png_set_user_limits(decoder.png, mostImageSide_px, mostImageSide_px);
    png_set_chunk_malloc_max(decoder.png, png_alloc_size_t{8} << 20);
    png_set_keep_unknown_chunks(decoder.png, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);  // text, profiles, times…
    png_read_info(decoder.png, decoder.info);
    png_set_palette_to_rgb(decoder.png);
    png_set_expand_gray_1_2_4_to_8(decoder.png);
    png_set_strip_alpha(decoder.png);
    png_set_interlace_handling(decoder.png);
    png_read_update_info(decoder.png, decoder.info);
    return true;
}

bool readPngRow(PngDecoder& decoder, png_bytep row)
{
    if (setjmp(png_jmpbuf(decoder.png))) return false;  // NOLINT(cert-err52-cpp)
    png_read_row(decoder.png, row, nullptr);
    return true;
}

bool finishPng(PngDecoder& decoder)
{
    if (setjmp(png_jmpbuf(decoder.png))) return false;  // NOLINT(cert-err52-cpp)
    png_read_end(decoder.png, nullptr);
    return true;
}

[[noreturn]] void refusePng(const PngDecoder& decoder, int rows)
{
    const auto byte = static_cast<std::int64_t>(decoder.at);
    const std::int64_t row = decoder.row;
    if (decoder.ended)
        throw Error(errors::imageEndsEarly, {{"byte", byte}, {"row", row}, {"expected", std::int64_t{rows}}});
    throw Error(errors::imageDamaged, {{"byte", byte}, {"row", row}, {"reason", std::string(decoder.message.data())}});
}

void readPngRows(PngDecoder& decoder, Image& image, const Progress& progress)
{
    const int channels = png_get_channels(decoder.png, decoder.info);
    const bool wide = png_get_bit_depth(decoder.png, decoder.info) == 16;
    const bool interlaced = png_get_interlace_type(decoder.png, decoder.info) != PNG_INTERLACE_NONE;
    const std::size_t row_bytes = png_get_rowbytes(decoder.png, decoder.info);
    const int passes = interlaced ? 7 : 1;
    std::vector<png_byte> buffer(row_bytes * (interlaced ? static_cast<std::size_t>(image.height) : 1));
    for (int pass = 0; pass < passes; ++pass)
        for (int row = 0; row < image.height; ++row) {
            if (row % 64 == 0) progress.report((pass + double(row) / image.height) / passes);
            decoder.row = row;
            png_byte* samples = buffer.data() + (interlaced ? static_cast<std::size_t>(row) * row_bytes : 0);
            if (!readPngRow(decoder, samples)) refusePng(decoder, image.height);
            if (pass == passes - 1) putRow(image, row, samples, channels, wide);
        }
    decoder.row = image.height;
    if (!finishPng(decoder)) refusePng(decoder, image.height);
}

}  // namespace

Image readPng(const std::string& name, std::string_view bytes, const Progress& progress)
{
    const PngFacts facts = walkChunks(bytes);
    PngDecoder decoder;
    decoder.bytes = bytes.data();
    decoder.size = bytes.size();
    decoder.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &decoder, failPng, failPng);
    decoder.info = decoder.png ? png_create_info_struct(decoder.png) : nullptr;
    if (!decoder.info) throw std::bad_alloc();
    if (!beginPng(decoder)) refusePng(decoder, static_cast<int>(facts.header.height));
    Image image = emptyImage("png", facts.header);
    readPngRows(decoder, image, progress);
    setScale(image, facts.um_per_px, name);
    if (facts.has_alpha) image.notes.push_back({notes::imageAlphaDropped, {{"path", name}}});
    if (facts.has_profile) image.notes.push_back({notes::imageProfileIgnored, {{"path", name}}});
    applyOrientation(image, facts.orientation, name);
    return image;
}

}  // namespace lathelier::io
