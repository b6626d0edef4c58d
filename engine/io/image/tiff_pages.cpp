#include "engine/io/image/tiff_pages.h"

#include <algorithm>

#include "engine/io/image/image_codes.h"
#include "engine/io/io_codes.h"

namespace lathelier::io {
namespace {

/// Reads numbers in the byte order of the file. Throws imageEndsEarly beyond its end.
struct Numbers {
    std::string_view bytes;
    bool little = true;

    std::uint64_t at(std::uint64_t byte, std::uint64_t count) const
    {
        if (byte > bytes.size() || bytes.size() - byte < count)
            throw Error(
                errors::imageEndsEarly,
                {{"byte", static_cast<std::int64_t>(bytes.size())}, {"row", std::int64_t{0}}, {"expected", Value()}});
        std::uint64_t result = 0;
        for (std::uint64_t i = 0; i < count; ++i)
            result = result << 8 | static_cast<std::uint8_t>(bytes[byte + (little ? count - 1 - i : i)]);
        return result;
    }
};

/// Sizes of the two kinds of file.
struct TiffWidths {
    std::uint64_t count_bytes, entry_bytes, offset_bytes;
};
constexpr TiffWidths classicWidths{2, 12, 4};
constexpr TiffWidths bigWidths{8, 20, 8};

/// The first value of an entry: a short, a long or a long of 8 bytes; several shorts may be stored elsewhere.
std::uint64_t valueOf(const Numbers& numbers, const TiffWidths& layout, std::uint64_t entry)
{
    const std::uint64_t type = numbers.at(entry + 2, 2);
    const std::uint64_t size = type == 1 ? 1 : type == 3 ? 2 : type == 16 ? 8 : 4;
    const std::uint64_t count = numbers.at(entry + 4, layout.offset_bytes);
    const std::uint64_t place = entry + 4 + layout.offset_bytes;
    const bool elsewhere = count > layout.offset_bytes / size;
    return numbers.at(elsewhere ? numbers.at(place, layout.offset_bytes) : place, size);
}

std::uint64_t tagsAt(const Numbers& numbers, const TiffWidths& layout, std::uint64_t directory)
{
    const std::uint64_t tags = numbers.at(directory, layout.count_bytes);
    if (tags == 0 || tags > mostTiffTags)
        throw Error(errors::malformed, {{"byte", static_cast<std::int64_t>(directory)},
                                        {"found", static_cast<std::int64_t>(std::min<std::uint64_t>(tags, INT64_MAX))},
                                        {"expected", LT_TEXT("Engine", "a TIFF directory of 1 to 1000 entries")}});
    return tags;
}

void readSizes(const Numbers& numbers, const TiffWidths& layout, std::uint64_t directory, std::uint64_t tags,
               TiffPages& pages)
{
    constexpr std::uint64_t largest = std::uint64_t{1} << 40;  // beyond every limit, far from overflow
    pages.header.bits = 1;
    for (std::uint64_t i = 0; i < tags; ++i) {
        const std::uint64_t entry = directory + layout.count_bytes + i * layout.entry_bytes;
        switch (numbers.at(entry, 2)) {
            case 256:
                pages.header.width = static_cast<std::int64_t>(std::min(valueOf(numbers, layout, entry), largest));
                break;
            case 257:
                pages.header.height = static_cast<std::int64_t>(std::min(valueOf(numbers, layout, entry), largest));
                break;
            case 258:
                pages.header.bits = static_cast<int>(std::min<std::uint64_t>(valueOf(numbers, layout, entry), 64));
                break;
            case 277:
                pages.header.channels =
                    static_cast<int>(std::clamp<std::uint64_t>(valueOf(numbers, layout, entry), 1, 65535));
                break;
            default: break;
        }
    }
}

}  // namespace

TiffPages walkTiff(std::string_view bytes)
{
    const Numbers numbers{bytes, bytes.starts_with("II")};
    const bool is_big = numbers.at(2, 2) == 43;
    const TiffWidths& layout = is_big ? bigWidths : classicWidths;
    TiffPages pages;
    std::uint64_t directory = numbers.at(is_big ? 8 : 4, layout.offset_bytes);
    pages.byte = directory;
    while (directory != 0 && pages.count < mostTiffPages) {
        const std::uint64_t tags = tagsAt(numbers, layout, directory);
        if (pages.count == 0) readSizes(numbers, layout, directory, tags, pages);
        ++pages.count;
        directory = numbers.at(directory + layout.count_bytes + tags * layout.entry_bytes, layout.offset_bytes);
    }
    if (pages.count == 0)
        throw Error(errors::malformed, {{"byte", std::int64_t{4}},
                                        {"found", std::int64_t{0}},
                                        {"expected", LT_TEXT("Engine", "a TIFF directory")}});
    return pages;
}

}  // namespace lathelier::io
