#include "engine/io/cloud/lzf.h"

namespace lathelier::io {

std::optional<std::string> decompressLzf(std::string_view compressed, std::size_t size)
{
    std::string out;
    std::size_t p = 0;
    const auto byte = [&](std::size_t i) {
        return static_cast<std::size_t>(static_cast<unsigned char>(compressed[i]));
    };
    while (p < compressed.size()) {
        const std::size_t control = byte(p++);
        if (control < 32) {  // a run of control + 1 literal bytes
            const std::size_t length = control + 1;
            if (compressed.size() - p < length || size - out.size() < length) return std::nullopt;
            out.append(compressed, p, length);
            p += length;
            continue;
        }
        // A copy of earlier output: 3 bits of length (7: one byte more follows), 13 bits of distance.
        std::size_t length = control >> 5;
        if (length == 7) {
            if (p == compressed.size()) return std::nullopt;
            length += byte(p++);
        }
        length += 2;
        if (p == compressed.size()) return std::nullopt;
        const std::size_t distance = ((control & 31) << 8) + byte(p++) + 1;
        if (distance > out.size() || size - out.size() < length) return std::nullopt;
        for (std::size_t i = 0; i < length; ++i) out += out[out.size() - distance];  // the copied range may overlap
    }
    if (out.size() != size) return std::nullopt;
    return out;
}

}  // namespace lathelier::io
