#include "engine/io/image/image_canvas.h"

#include <algorithm>
#include <utility>

#include "engine/io/image/image_codes.h"

namespace lathelier::io {
namespace {

Values sizeValues(const ImageHeader& header, std::size_t byte)
{
    return {{"byte", static_cast<std::int64_t>(byte)}, {"width", header.width}, {"height", header.height}};
}

[[noreturn]] void refuseSize(const ImageHeader& header, std::size_t byte, double found, const char* unit,
                             double maximum)
{
    Values values = sizeValues(header, byte);
    set(values, "found", found);
    set(values, "unit", std::string(unit));
    set(values, "maximum", maximum);
    throw Error(errors::imageTooLarge, values);
}

}  // namespace

void checkHeader(const ImageHeader& header, std::size_t file_bytes, std::size_t byte)
{
    if (header.width < 1 || header.height < 1) throw Error(errors::imageEmpty, sizeValues(header, byte));
    const std::int64_t side = std::max(header.width, header.height);
    if (side > mostImageSide_px) refuseSize(header, byte, static_cast<double>(side), "px", double{mostImageSide_px});
    const double pixels = static_cast<double>(header.width) * static_cast<double>(header.height);
    if (pixels > mostImagePixels) refuseSize(header, byte, pixels * 1e-6, "Mpx", mostImagePixels * 1e-6);
    const double decoded = pixels * header.channels * (header.bits > 8 ? 2 : 1);
    if (decoded > mostImageBytes) refuseSize(header, byte, decoded * 1e-6, "MB", mostImageBytes * 1e-6);
    const double packed = pixels * header.channels * header.bits / 8;  // samples below 8 bits are packed
    if (static_cast<double>(file_bytes) * mostImageCompression < packed) {
        Values values = sizeValues(header, byte);
        set(values, "found_bytes", static_cast<std::int64_t>(file_bytes));
        set(values, "expected_bytes", static_cast<std::int64_t>(packed / mostImageCompression));
        throw Error(errors::imageImplausible, values);
    }
}

Image emptyImage(std::string_view format, const ImageHeader& header)
{
    Image image;
    image.format = format;
    image.width = static_cast<int>(header.width);
    image.height = static_cast<int>(header.height);
    image.bits = header.bits;
    image.channels = header.channels;
    image.grey.resize(static_cast<std::size_t>(header.width) * static_cast<std::size_t>(header.height));
    return image;
}

void putRow(Image& image, int row, const std::uint8_t* samples, int channels, bool wide)
{
    const auto width = static_cast<std::size_t>(image.width);
    float* out = image.grey.data() + static_cast<std::size_t>(row) * width;
    const auto stride = static_cast<std::size_t>(channels);
    const auto sample = [samples, wide](std::size_t i) {
        return wide ? samples[2 * i] * 256 + samples[2 * i + 1] : static_cast<int>(samples[i]);
    };
    const double scale = wide ? 1.0 / 65535 : 1.0 / 255;
    for (std::size_t x = 0; x < width; ++x) {
        const std::size_t first = x * stride;
        const double value =
            channels >= 3 ? redWeight * sample(first) + greenWeight * sample(first + 1) + blueWeight * sample(first + 2)
                          : double(sample(first));
        out[x] = static_cast<float>(value * scale);
    }
}

void setScale(Image& image, double um_per_px, const std::string& name)
{
    constexpr double finestPrint_um = 40;  // 635 dpi
    if (!(um_per_px >= 1e-3 && um_per_px <= 1e6)) return;
    image.um_per_px = um_per_px;
    if (um_per_px < finestPrint_um)
        image.notes.push_back({notes::imageScaleStated, {{"path", name}, {"um_per_px", um_per_px}}});
}

void applyOrientation(Image& image, int orientation, const std::string& name)
{
    if (orientation < 2 || orientation > 8) return;
    const int width = image.width, height = image.height;
    const bool swapped = orientation >= 5;
    std::vector<float> turned(image.grey.size());
    const int new_width = swapped ? height : width, new_height = swapped ? width : height;
    for (int y = 0; y < new_height; ++y)
        for (int x = 0; x < new_width; ++x) {
            // position in the file of pixel (x, y) of the upright image
            int from_x = swapped ? y : x, from_y = swapped ? x : y;
            if (orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8)
                from_x = width - 1 - from_x;
            if (orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7)
                from_y = height - 1 - from_y;
            turned[static_cast<std::size_t>(y) * static_cast<std::size_t>(new_width) + static_cast<std::size_t>(x)] =
                image.at(from_x, from_y);
        }
    image.grey = std::move(turned);
    image.width = new_width;
    image.height = new_height;
    image.orientation = orientation;
    image.notes.push_back({notes::imageTurned, {{"path", name}, {"orientation", std::int64_t{orientation}}}});
}

int exifOrientation(std::string_view block)
{
    if (block.size() < 8) return 1;
    const bool little = block.substr(0, 2) == "II";
    const auto number = [&](std::size_t at, std::size_t count) {
        std::size_t result = 0;
        for (std::size_t i = 0; i < count; ++i)
            result = result << 8 | static_cast<std::uint8_t>(block[little ? at + count - 1 - i : at + i]);
        return result;
    };
    const std::size_t directory = number(4, 4);
    if (directory < 8 || directory > block.size() - 2) return 1;
    const std::size_t entries = number(directory, 2);
    constexpr std::size_t orientationTag = 0x0112, entrySize = 12;
    for (std::size_t i = 0; i < entries; ++i) {
        const std::size_t entry = directory + 2 + i * entrySize;
        if (entry + entrySize > block.size()) return 1;
        if (number(entry, 2) != orientationTag) continue;
        const std::size_t value = number(entry + 8, 2);
        return value >= 1 && value <= 8 ? static_cast<int>(value) : 1;
    }
    return 1;
}

}  // namespace lathelier::io
