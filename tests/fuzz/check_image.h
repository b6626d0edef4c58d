// What every fuzzer of pictures checks.
#pragma once

#include "engine/io/image/image.h"
#include "engine/io/image/image_codes.h"
#include "tests/fuzz/check_reader.h"

namespace lathelier::fuzz {

/// Pictures of more pixels are sound, and slow to make many times a second: they are left out.
inline constexpr std::size_t longestFile = 1 << 16;

template <class Read>
void checkImage(const std::uint8_t* data, std::size_t size, Read read)
{
    if (size < 16 || size > longestFile) return;
    try {
        const io::Image image = read("fuzz", {reinterpret_cast<const char*>(data), size}, Progress{});
        require(image.width >= 1 && image.height >= 1);
        require(image.grey.size() == static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
        for (std::size_t i = 0; i < image.grey.size(); i += 97) require(image.grey[i] >= 0 && image.grey[i] <= 1.0001F);
        require(!toJson(io::imageFacts("fuzz", image)).dump().empty());
    } catch (const Error& error) {
        require(!toJson(error).dump().empty());
        require(find(error.values(), "byte") != nullptr);
    }
}

}  // namespace lathelier::fuzz
