// Pictures as bytes of files, for tests: written by the libraries themselves.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace lathelier::test {

/// A ramp: value(x, y) = (7 x + 3 y) mod 2^bits.
struct Ramp {
    int width = 160, height = 140, bits = 8;
    int value(int x, int y) const { return (7 * x + 3 * y) % (1 << bits); }
};

std::string jpegFile(const Ramp& ramp);

struct TiffKind {
    bool lzw = true;        ///< else plain
    bool tiled = false;     ///< tiles of 64 × 64
    bool is_float = false;  ///< floating point samples, which are refused
    int colours = 1;        ///< 1, 3, or 4 (CMYK)
    int pages = 1;
};
std::string tiffFile(const Ramp& ramp, const TiffKind& kind);

}  // namespace lathelier::test
