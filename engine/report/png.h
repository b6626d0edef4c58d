// Pictures with a palette as PNG (W3C PNG Specification, 3rd edition), and any bytes as base64 (RFC 4648).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/report/colours.h"

namespace lathelier::report {

struct IndexedImage {
    int width = 0;                     ///< in pixels
    int height = 0;                    ///< in pixels
    std::vector<std::uint8_t> pixels;  ///< row-major from the top, indices into palette
    std::vector<Rgb> palette;          ///< 1 to 256 colours
    int transparent = -1;              ///< the index that lets the ground show through; -1: none
};

std::string encodePng(const IndexedImage& image);

std::string base64(std::string_view bytes);

}  // namespace lathelier::report
