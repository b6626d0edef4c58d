// JPEG by libjpeg-turbo (ITU-T T.81), brightness only. The markers are scanned beforehand, so that size, orientation
// and colour profile are known and limits are checked before libjpeg is called.
#include <cstdio>  // jpeglib.h needs it
// clang-format off
#include <jpeglib.h>
#include <jerror.h>
// clang-format on

#include <array>
#include <csetjmp>

#include "engine/io/image/image_canvas.h"
#include "engine/io/image/image_codes.h"
#include "engine/io/io_codes.h"

namespace lathelier::io {
namespace {

constexpr long mostMemory_bytes = 700'000'000;  // coefficients of a progressive picture of 100 Mpx
constexpr int mostScans = 200;  // a progressive picture has about ten; thousands of empty ones take hours

/// Content of the markers before decoding.
struct JpegFacts {
    ImageHeader header;
    int orientation = 1;
    bool has_profile = false;
};

[[noreturn]] void refuseFormat(std::size_t byte, Text found)
{
    throw Error(errors::imageUnsupported,
                {{"byte", static_cast<std::int64_t>(byte)},
                 {"found", found},
                 {"expected", LT_TEXT("Engine", "a JPEG picture in grey or colour of 8 bits")}});
}

[[noreturn]] void endsEarly(std::size_t byte, std::int64_t row, Value expected)
{
    throw Error(errors::imageEndsEarly,
                {{"byte", static_cast<std::int64_t>(byte)}, {"row", row}, {"expected", std::move(expected)}});
}

bool isFrame(int marker)
{
    return marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
}

/// The start of frame: precision, height, width, components.
void readFrame(std::string_view data, int marker, std::size_t byte, std::size_t file_bytes, JpegFacts& facts)
{
    if (data.size() < 6) endsEarly(byte + data.size(), 0, {});
    const auto at = [&data](std::size_t i) { return static_cast<std::uint8_t>(data[i]); };
    facts.header = {at(3) * 256 + at(4), at(1) * 256 + at(2), at(0), at(5)};
    if (facts.header.bits != 8 || (marker != 0xC0 && marker != 0xC1 && marker != 0xC2))
        refuseFormat(byte, facts.header.bits != 8 ? LT_TEXT("Engine", "another number of bits than 8")
                                                  : LT_TEXT("Engine", "lossless, hierarchical or arithmetic coding"));
    if (facts.header.channels == 4) refuseFormat(byte, LT_TEXT("Engine", "CMYK"));
    if (facts.header.channels != 1 && facts.header.channels != 3)
        refuseFormat(byte, LT_TEXT("Engine", "a number of components that is neither 1 nor 3"));
    checkHeader(facts.header, file_bytes, byte);
}

JpegFacts walkMarkers(std::string_view bytes)
{
    JpegFacts facts;
    std::size_t at = 2;  // after the SOI marker
    while (true) {
        while (at < bytes.size() && bytes[at] == '\xFF' && at + 1 < bytes.size() && bytes[at + 1] == '\xFF') ++at;
        if (at + 4 > bytes.size()) endsEarly(bytes.size(), 0, {});
        const int marker = static_cast<std::uint8_t>(bytes[at + 1]);
        if (bytes[at] != '\xFF' || marker == 0xD9 || marker == 0xDA)
            throw Error(errors::malformed, {{"byte", static_cast<std::int64_t>(at)},
                                            {"found", std::int64_t{marker}},
                                            {"expected", LT_TEXT("Engine", "a JPEG marker before the first scan")}});
        if (marker == 0x01 || (marker >= 0xD0 && marker <= 0xD8)) {  // markers without a length
            at += 2;
            continue;
        }
        const std::size_t length =
            static_cast<std::uint8_t>(bytes[at + 2]) * std::size_t{256} + static_cast<std::uint8_t>(bytes[at + 3]);
        const std::size_t begin = at + 4;
        const std::string_view data = bytes.substr(begin, std::min(length < 2 ? 0 : length - 2, bytes.size() - begin));
        if (marker == 0xE1 && data.starts_with(std::string_view("Exif\0\0", 6)))
            facts.orientation = exifOrientation(data.substr(6));
        if (marker == 0xE2 && data.starts_with("ICC_PROFILE")) facts.has_profile = true;
        if (isFrame(marker)) {
            readFrame(data, marker, begin, bytes.size(), facts);
            return facts;
        }
        at = begin + (length < 2 ? 0 : length - 2);
    }
}

/// State shared with the callbacks of libjpeg. Trivially destructible, as longjmp requires.
struct JpegDecoder {
    jpeg_decompress_struct jpeg{};
    jpeg_error_mgr errors{};
    jpeg_source_mgr source{};
    jpeg_progress_mgr monitor{};
    std::jmp_buf back{};
    bool ended = false;
    std::array<char, JMSG_LENGTH_MAX> message{};
    const Progress* progress = nullptr;

    JpegDecoder() = default;
    JpegDecoder(const JpegDecoder&) = delete;
    JpegDecoder& operator=(const JpegDecoder&) = delete;
    ~JpegDecoder() { jpeg_destroy_decompress(&jpeg); }
};

JpegDecoder& decoderOf(j_common_ptr jpeg)
{
    return *static_cast<JpegDecoder*>(jpeg->client_data);
}

[[noreturn]] void failJpeg(j_common_ptr jpeg)
{
    JpegDecoder& decoder = decoderOf(jpeg);
    jpeg->err->format_message(jpeg, decoder.message.data());
    std::longjmp(decoder.back, 1);
}

/// Level -1 is a warning: damaged data, which libjpeg would replace.
void heed(j_common_ptr jpeg, int level)
{
    if (level < 0) failJpeg(jpeg);
}

boolean refill(j_decompress_ptr jpeg)
{
    JpegDecoder& decoder = decoderOf(reinterpret_cast<j_common_ptr>(jpeg));
    decoder.ended = true;
    std::longjmp(decoder.back, 1);
}

void skip(j_decompress_ptr jpeg, long count)
{
    if (count <= 0) return;
    if (static_cast<std::size_t>(count) > jpeg->src->bytes_in_buffer) refill(jpeg);
    jpeg->src->next_input_byte += count;
    jpeg->src->bytes_in_buffer -= static_cast<std::size_t>(count);
}

void watch(j_common_ptr jpeg)
{
    const auto* decompress = reinterpret_cast<j_decompress_ptr>(jpeg);
    JpegDecoder& decoder = decoderOf(jpeg);
    if (decompress->input_scan_number > mostScans || decoder.progress->stopped()) {
        std::snprintf(decoder.message.data(), decoder.message.size(), "more than %d scans", mostScans);
        std::longjmp(decoder.back, 1);
    }
}

bool beginJpeg(JpegDecoder& decoder, std::string_view bytes)
{
    if (setjmp(decoder.back)) return false;  // NOLINT(cert-err52-cpp): libjpeg leaves by longjmp only
    decoder.jpeg.err = jpeg_std_error(&decoder.errors);
    decoder.errors.error_exit = failJpeg;
    decoder.errors.emit_message = heed;
    decoder.jpeg.client_data = &decoder;
    jpeg_create_decompress(&decoder.jpeg);
    decoder.jpeg.mem->max_memory_to_use = mostMemory_bytes;
    decoder.source.init_source = [](j_decompress_ptr) {};
    decoder.source.term_source = [](j_decompress_ptr) {};
    decoder.source.fill_input_buffer = refill;
    decoder.source.skip_input_data = skip;
    decoder.source.resync_to_restart = jpeg_resync_to_restart;
    decoder.source.next_input_byte = reinterpret_cast<const JOCTET*>(bytes.data());
    decoder.source.bytes_in_buffer = bytes.size();
    decoder.jpeg.src = &decoder.source;
    decoder.monitor.progress_monitor = watch;
    decoder.jpeg.progress = &decoder.monitor;
    jpeg_read_header(&decoder.jpeg, TRUE);
    decoder.jpeg.out_color_space = JCS_GRAYSCALE;
    decoder.jpeg.dct_method = JDCT_ISLOW;
    jpeg_start_decompress(&decoder.jpeg);
    return true;
}

bool readJpegRow(JpegDecoder& decoder, std::uint8_t* row)
{
    if (setjmp(decoder.back)) return false;  // NOLINT(cert-err52-cpp)
    JSAMPROW rows[1] = {row};
    return jpeg_read_scanlines(&decoder.jpeg, rows, 1) == 1;
}

bool finishJpeg(JpegDecoder& decoder)
{
    if (setjmp(decoder.back)) return false;  // NOLINT(cert-err52-cpp)
    return jpeg_finish_decompress(&decoder.jpeg) != 0;
}

[[noreturn]] void refuseJpeg(const JpegDecoder& decoder, std::size_t size, std::int64_t rows, const Progress& progress)
{
    progress.check();
    const auto row = static_cast<std::int64_t>(decoder.jpeg.output_scanline);
    const std::size_t byte = size - decoder.source.bytes_in_buffer;
    if (decoder.ended) endsEarly(size, row, rows);
    throw Error(
        errors::imageDamaged,
        {{"byte", static_cast<std::int64_t>(byte)}, {"row", row}, {"reason", std::string(decoder.message.data())}});
}

}  // namespace

Image readJpeg(const std::string& name, std::string_view bytes, const Progress& progress)
{
    const JpegFacts facts = walkMarkers(bytes);
    JpegDecoder decoder;
    decoder.progress = &progress;
    if (!beginJpeg(decoder, bytes)) refuseJpeg(decoder, bytes.size(), facts.header.height, progress);
    if (decoder.jpeg.output_width != facts.header.width || decoder.jpeg.output_height != facts.header.height ||
        decoder.jpeg.output_components != 1)
        refuseFormat(0, LT_TEXT("Engine", "several frames"));
    Image image = emptyImage("jpeg", facts.header);
    std::vector<std::uint8_t> row(static_cast<std::size_t>(image.width));
    for (int y = 0; y < image.height; ++y) {
        if (y % 64 == 0) progress.report(double(y) / image.height);
        if (!readJpegRow(decoder, row.data())) refuseJpeg(decoder, bytes.size(), image.height, progress);
        putRow(image, y, row.data(), 1, false);
    }
    if (!finishJpeg(decoder)) refuseJpeg(decoder, bytes.size(), image.height, progress);
    if (facts.has_profile) image.notes.push_back({notes::imageProfileIgnored, {{"path", name}}});
    applyOrientation(image, facts.orientation, name);
    return image;
}

}  // namespace lathelier::io
