// The directories of a TIFF file (Adobe, TIFF revision 6.0; BigTIFF), walked before a library sees the file.
#pragma once

#include <cstdint>
#include <string_view>

#include "engine/io/image/image_canvas.h"

namespace lathelier::io {

/// What the first directory states, as far as limits need it, and how many there are.
struct TiffPages {
    ImageHeader header;      ///< of the first picture; bits and channels of its first sample
    std::int64_t count = 0;  ///< pictures in the file, at most mostTiffPages
    std::size_t byte = 0;    ///< of the first directory
};

inline constexpr std::int64_t mostTiffPages = 1000;  ///< further ones are not counted
inline constexpr std::uint64_t mostTiffTags = 1000;  ///< in one directory

/// Errors imageEndsEarly, malformed (`byte`): a directory beyond the file, more than mostTiffTags entries, no size.
TiffPages walkTiff(std::string_view bytes);

}  // namespace lathelier::io
