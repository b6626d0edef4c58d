// TIFF by libtiff (Adobe, TIFF revision 6.0): strips and tiles of 8 or 16 bits, grey, palette or RGB; stored plainly or
// by LZW, deflate or PackBits. Warnings and errors are collected by handlers of this file.
#include <tiffio.h>

#include <array>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <memory>

#include "engine/io/image/image_canvas.h"
#include "engine/io/image/image_codes.h"
#include "engine/io/image/tiff_pages.h"
#include "engine/io/text/units.h"

namespace lathelier::io {
namespace {

/// The file in memory, and the first message of libtiff.
struct Source {
    std::string_view bytes;
    std::uint64_t at = 0;
    bool ended = false;
    std::array<char, 200> message{};

    bool failed() const { return message[0] != '\0'; }
};

Source& sourceOf(thandle_t handle)
{
    return *static_cast<Source*>(handle);
}

tmsize_t giveTiff(thandle_t handle, void* out, tmsize_t count)
{
    Source& source = sourceOf(handle);
    const std::uint64_t there = source.at < source.bytes.size() ? source.bytes.size() - source.at : 0;
    const std::uint64_t given =
        std::min<std::uint64_t>(there, static_cast<std::uint64_t>(std::max<tmsize_t>(count, 0)));
    if (given < static_cast<std::uint64_t>(count)) source.ended = true;
    if (given > 0) std::memcpy(out, source.bytes.data() + source.at, given);
    source.at += given;
    return static_cast<tmsize_t>(given);
}

toff_t seek(thandle_t handle, toff_t offset, int whence)
{
    Source& source = sourceOf(handle);
    source.at = whence == SEEK_CUR ? source.at + offset : whence == SEEK_END ? source.bytes.size() + offset : offset;
    return source.at;
}

__attribute__((format(printf, 2, 0))) void keep(Source& source, const char* format, va_list arguments)
{
    if (!source.failed()) std::vsnprintf(source.message.data(), source.message.size(), format, arguments);
}

__attribute__((format(printf, 4, 0))) int onError(TIFF*, void* source, const char*, const char* format,
                                                  va_list arguments)
{
    keep(*static_cast<Source*>(source), format, arguments);
    return 1;
}

/// Private tags of cameras and microscopes are not damage.
__attribute__((format(printf, 4, 0))) int onWarning(TIFF*, void* source, const char*, const char* format,
                                                    va_list arguments)
{
    if (!std::strstr(format, "Unknown field")) keep(*static_cast<Source*>(source), format, arguments);
    return 1;
}

struct Close {
    void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};
using Tiff = std::unique_ptr<TIFF, Close>;

Tiff open(Source& source)
{
    const std::unique_ptr<TIFFOpenOptions, decltype(&TIFFOpenOptionsFree)> options(TIFFOpenOptionsAlloc(),
                                                                                   TIFFOpenOptionsFree);
    if (!options) throw std::bad_alloc();
    TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), static_cast<tmsize_t>(mostImageBytes));
    TIFFOpenOptionsSetErrorHandlerExtR(options.get(), onError, &source);
    TIFFOpenOptionsSetWarningHandlerExtR(options.get(), onWarning, &source);
    // m: no mapping. h: the first directory only, read at once.
    return Tiff(TIFFClientOpenExt(
        "picture", "rm", &source, giveTiff, [](thandle_t, void*, tmsize_t) -> tmsize_t { return 0; }, seek,
        [](thandle_t) { return 0; }, [](thandle_t handle) -> toff_t { return sourceOf(handle).bytes.size(); }, nullptr,
        nullptr, options.get()));
}

/// Properties of the samples by the directory.
struct SampleLayout {
    std::uint16_t bits = 1, samples = 1, photometric = 0, planar = PLANARCONFIG_CONTIG, format = SAMPLEFORMAT_UINT;
    std::uint16_t compression = COMPRESSION_NONE, orientation = 1;
    std::array<std::uint16_t*, 3> palette{};
    bool has_profile = false;
    double um_per_px = 0;  ///< by the resolution and its unit; 0: none stated

    int colours() const { return photometric == PHOTOMETRIC_RGB ? 3 : 1; }
};

/// µm of the unit that ImageJ names in its description, "unit=um"; 0 without one.
double unitOfImageJ_um(std::string_view description)
{
    constexpr std::string_view key = "\nunit=";
    const std::size_t at = description.find(key);
    if (!description.starts_with("ImageJ=") || at == std::string_view::npos) return 0;
    std::string_view word = description.substr(at + key.size());
    word = word.substr(0, word.find_first_of("\r\n"));
    if (word == "\\u00B5m") return 1;  // as ImageJ escapes µm
    const auto unit = lengthUnit(word);
    return unit ? unit->mm * 1e3 : 0;
}

double scaleOf(TIFF* tiff)
{
    constexpr double um_per_inch = 25400, um_per_cm = 1e4;
    float across = 0, down = 0;
    std::uint16_t unit = RESUNIT_INCH;
    const char* description = nullptr;
    if (!TIFFGetField(tiff, TIFFTAG_XRESOLUTION, &across) || !(across > 0)) return 0;
    if (TIFFGetField(tiff, TIFFTAG_YRESOLUTION, &down) && down != across) return 0;
    TIFFGetFieldDefaulted(tiff, TIFFTAG_RESOLUTIONUNIT, &unit);
    if (TIFFGetField(tiff, TIFFTAG_IMAGEDESCRIPTION, &description) && description)
        if (const double unit_um = unitOfImageJ_um(description); unit_um > 0)
            return unit_um / static_cast<double>(across);
    if (unit == RESUNIT_INCH) return um_per_inch / static_cast<double>(across);
    return unit == RESUNIT_CENTIMETER ? um_per_cm / static_cast<double>(across) : 0;
}

SampleLayout layoutOf(TIFF* tiff)
{
    SampleLayout layout;
    TIFFGetFieldDefaulted(tiff, TIFFTAG_BITSPERSAMPLE, &layout.bits);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLESPERPIXEL, &layout.samples);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_PLANARCONFIG, &layout.planar);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLEFORMAT, &layout.format);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_COMPRESSION, &layout.compression);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_ORIENTATION, &layout.orientation);
    if (!TIFFGetField(tiff, TIFFTAG_PHOTOMETRIC, &layout.photometric)) layout.photometric = PHOTOMETRIC_MINISBLACK;
    if (layout.photometric == PHOTOMETRIC_PALETTE &&
        !TIFFGetField(tiff, TIFFTAG_COLORMAP, layout.palette.data(), layout.palette.data() + 1,
                      layout.palette.data() + 2))
        layout.palette = {};
    std::uint32_t size = 0;
    void* profile = nullptr;
    layout.has_profile = TIFFGetField(tiff, TIFFTAG_ICCPROFILE, &size, &profile) == 1;
    layout.um_per_px = scaleOf(tiff);
    return layout;
}

void checkLayout(const SampleLayout& layout, std::size_t byte)
{
    const auto refuse = [byte](Text found) {
        throw Error(errors::imageUnsupported,
                    {{"byte", static_cast<std::int64_t>(byte)},
                     {"found", found},
                     {"expected", LT_TEXT("Engine",
                                          "a TIFF picture in grey or RGB of 8 or 16 bits, not compressed or by "
                                          "LZW or deflate")}});
    };
    if (layout.format == SAMPLEFORMAT_IEEEFP) refuse(LT_TEXT("Engine", "floating point samples"));
    if (layout.format != SAMPLEFORMAT_UINT) refuse(LT_TEXT("Engine", "signed or complex samples"));
    if (layout.bits != 8 && layout.bits != 16) refuse(LT_TEXT("Engine", "another number of bits than 8 or 16"));
    if (layout.photometric == PHOTOMETRIC_SEPARATED) refuse(LT_TEXT("Engine", "CMYK"));
    const bool is_grey = layout.photometric == PHOTOMETRIC_MINISBLACK || layout.photometric == PHOTOMETRIC_MINISWHITE;
    const bool is_palette = layout.photometric == PHOTOMETRIC_PALETTE && layout.bits == 8 && layout.palette[0];
    if (!is_grey && !is_palette && layout.photometric != PHOTOMETRIC_RGB)
        refuse(LT_TEXT("Engine", "a colour space that is neither grey nor RGB"));
    if (layout.samples > 4) refuse(LT_TEXT("Engine", "more than four channels"));
    if (layout.samples < layout.colours()) refuse(LT_TEXT("Engine", "RGB of fewer than three channels"));
    switch (layout.compression) {
        case COMPRESSION_NONE:
        case COMPRESSION_LZW:
        case COMPRESSION_DEFLATE:
        case COMPRESSION_ADOBE_DEFLATE:
        case COMPRESSION_PACKBITS: break;
        default: refuse(LT_TEXT("Engine", "another compression"));
    }
}

/// Adds samples of one colour, or of all, to a part of the image.
class Painter {
public:
    Painter(Image& image, const SampleLayout& layout) : image_(image), layout_(layout) {}

    /// A block of `across` × `down` pixels at (x, y), `stride_bytes` from row to row; `plane`: its colour where each
    /// has a plane of its own, else -1.
    void put(const std::uint8_t* block, std::size_t stride_bytes, int x, int y, int across, int down, int plane)
    {
        for (int row = 0; row < down && y + row < image_.height; ++row)
            for (int column = 0; column < across && x + column < image_.width; ++column) {
                const std::uint8_t* line = block + static_cast<std::size_t>(row) * stride_bytes;
                float& out = image_.grey[static_cast<std::size_t>(y + row) * static_cast<std::size_t>(image_.width) +
                                         static_cast<std::size_t>(x + column)];
                const int samples = plane < 0 ? layout_.samples : 1;
                for (int colour = 0; colour < (plane < 0 ? layout_.colours() : 1); ++colour)
                    out += static_cast<float>(brightness(line, column * samples + colour, std::max(plane, colour)));
            }
    }

private:
    double brightness(const std::uint8_t* line, int index, int colour) const
    {
        constexpr std::array<double, 3> weights{redWeight, greenWeight, blueWeight};
        double value = 0;
        if (layout_.bits == 16) {
            std::uint16_t sample = 0;  // converted to native byte order by libtiff
            std::memcpy(&sample, line + 2 * static_cast<std::size_t>(index), 2);
            value = sample / 65535.0;
        } else {
            value = line[index] / 255.0;
        }
        if (layout_.photometric == PHOTOMETRIC_PALETTE) {
            double sum = 0;
            for (std::size_t k = 0; k < 3; ++k) sum += weights[k] * layout_.palette[k][line[index]] / 65535.0;
            return sum;
        }
        if (layout_.photometric == PHOTOMETRIC_MINISWHITE) return 1 - value;
        return layout_.photometric == PHOTOMETRIC_RGB ? weights[static_cast<std::size_t>(colour)] * value : value;
    }

    Image& image_;
    const SampleLayout& layout_;
};

[[noreturn]] void refuseTiff(const Source& source, int row, int rows)
{
    const auto byte = static_cast<std::int64_t>(std::min<std::uint64_t>(source.at, source.bytes.size()));
    if (source.ended)
        throw Error(errors::imageEndsEarly,
                    {{"byte", byte}, {"row", std::int64_t{row}}, {"expected", std::int64_t{rows}}});
    std::string reason(source.failed() ? source.message.data() : "not decoded");
    for (char& letter : reason)
        if (static_cast<unsigned char>(letter) < 0x20 || static_cast<unsigned char>(letter) > 0x7E) letter = '?';
    throw Error(errors::imageDamaged, {{"byte", byte}, {"row", std::int64_t{row}}, {"reason", reason}});
}

/// The blocks of the picture, be they strips or tiles.
struct Blocks {
    bool tiled = false;
    std::uint32_t across = 0, down = 0;
    std::uint64_t row_bytes = 0, bytes = 0;
};

Blocks blocksOf(TIFF* tiff, const Image& image, std::size_t byte)
{
    Blocks blocks;
    blocks.tiled = TIFFIsTiled(tiff) != 0;
    if (blocks.tiled) {
        TIFFGetField(tiff, TIFFTAG_TILEWIDTH, &blocks.across);
        TIFFGetField(tiff, TIFFTAG_TILELENGTH, &blocks.down);
        blocks.row_bytes = TIFFTileRowSize64(tiff);
        blocks.bytes = TIFFTileSize64(tiff);
    } else {
        blocks.across = static_cast<std::uint32_t>(image.width);
        TIFFGetFieldDefaulted(tiff, TIFFTAG_ROWSPERSTRIP, &blocks.down);
        blocks.down = std::min(blocks.down, static_cast<std::uint32_t>(image.height));
        blocks.row_bytes = TIFFScanlineSize64(tiff);
        blocks.bytes = TIFFVStripSize64(tiff, blocks.down);
    }
    const double across = blocks.across, down = blocks.down;
    const double covered = std::ceil(image.width / across) * across * std::ceil(image.height / down) * down;
    if (!(across >= 1 && down >= 1) || blocks.bytes == 0 || static_cast<double>(blocks.bytes) > mostImageBytes ||
        (blocks.tiled && covered > 4 * mostImagePixels))
        throw Error(errors::imageUnsupported,
                    {{"byte", static_cast<std::int64_t>(byte)},
                     {"found", LT_TEXT("Engine", "strips or tiles far larger than the picture")},
                     {"expected", LT_TEXT("Engine", "strips or tiles of up to 400 MB")}});
    return blocks;
}

void readBlocks(TIFF* tiff, Source& source, const SampleLayout& layout, std::size_t byte, Image& image,
                const Progress& progress)
{
    const Blocks blocks = blocksOf(tiff, image, byte);
    const int planes = layout.planar == PLANARCONFIG_SEPARATE ? layout.colours() : 1;
    std::vector<std::uint8_t> buffer(blocks.bytes);
    Painter painter(image, layout);
    const int across = static_cast<int>(blocks.across), down = static_cast<int>(blocks.down);
    for (int plane = 0; plane < planes; ++plane)
        for (int y = 0; y < image.height; y += down) {
            progress.report((plane + double(y) / image.height) / planes);
            for (int x = 0; x < image.width; x += across) {
                const auto column = static_cast<std::uint32_t>(x), row = static_cast<std::uint32_t>(y);
                const auto sample = static_cast<std::uint16_t>(plane);
                const std::uint32_t index =
                    blocks.tiled ? TIFFComputeTile(tiff, column, row, 0, sample) : TIFFComputeStrip(tiff, row, sample);
                const int rows = std::min(down, image.height - y);
                const auto wanted = blocks.tiled
                                        ? static_cast<tmsize_t>(blocks.bytes)
                                        : static_cast<tmsize_t>(blocks.row_bytes * static_cast<unsigned>(rows));
                const tmsize_t got = blocks.tiled ? TIFFReadEncodedTile(tiff, index, buffer.data(), wanted)
                                                  : TIFFReadEncodedStrip(tiff, index, buffer.data(), wanted);
                if (got != wanted || source.failed()) refuseTiff(source, y, image.height);
                painter.put(buffer.data(), blocks.row_bytes, x, y, across, rows, planes > 1 ? plane : -1);
            }
        }
}

}  // namespace

Image readTiff(const std::string& name, std::string_view bytes, const Progress& progress)
{
    const TiffPages pages = walkTiff(bytes);
    checkHeader(pages.header, bytes.size(), pages.byte);
    Source source{bytes};
    const Tiff tiff = open(source);
    const int rows = static_cast<int>(pages.header.height);
    if (!tiff) refuseTiff(source, 0, rows);
    const SampleLayout layout = layoutOf(tiff.get());
    checkLayout(layout, pages.byte);
    if (source.failed()) refuseTiff(source, 0, rows);
    std::uint32_t width = 0, height = 0;
    TIFFGetField(tiff.get(), TIFFTAG_IMAGEWIDTH, &width);
    TIFFGetField(tiff.get(), TIFFTAG_IMAGELENGTH, &height);
    const ImageHeader header{width, height, layout.bits, layout.samples};
    checkHeader(header, bytes.size(), pages.byte);  // a duplicate tag may have two values
    Image image = emptyImage("tiff", header);
    readBlocks(tiff.get(), source, layout, pages.byte, image, progress);
    setScale(image, layout.um_per_px, name);
    if (layout.samples > layout.colours()) image.notes.push_back({notes::imageAlphaDropped, {{"path", name}}});
    if (layout.has_profile) image.notes.push_back({notes::imageProfileIgnored, {{"path", name}}});
    if (pages.count > 1) image.notes.push_back({notes::imagePagesIgnored, {{"path", name}, {"count", pages.count}}});
    applyOrientation(image, layout.orientation, name);
    return image;
}

}  // namespace lathelier::io
