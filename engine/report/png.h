// Pictures with a palette or in grey as PNG (W3C PNG Specification, 3rd edition), and any bytes as base64 (RFC 4648).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/report/colours.h"

namespace lathelier::report {

struct IndexedImage {
    int width = 0;                     ///< in px
    int height = 0;                    ///< in px
    std::vector<std::uint8_t> pixels;  ///< row-major from the top, indices into palette
    std::vector<Rgb> palette;          ///< 1 to 256 colours
    int transparent = -1;              ///< index of the transparent colour; -1: none
};

std::string encodePng(const IndexedImage& image);

/// Greyscale image.
struct GreyImage {
    int width = 0;                       ///< in px
    int height = 0;                      ///< in px
    int bits = 8;                        ///< of a sample: 8 or 16
    std::vector<std::uint16_t> samples;  ///< row-major from the top, 0 black to 2^bits - 1
    std::string comment;                 ///< Latin-1, in the file; empty: none
};

std::string encodePng(const GreyImage& image);

std::string base64(std::string_view bytes);

}  // namespace lathelier::report
