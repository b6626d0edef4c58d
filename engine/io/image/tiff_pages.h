// The directories of a TIFF file (Adobe, TIFF revision 6.0; BigTIFF), scanned before a library is called.
#pragma once

#include <cstdint>
#include <string_view>

#include "engine/io/image/image_canvas.h"

namespace lathelier::io {

/// Properties of the first directory required by the limits, and the number of directories.
struct TiffPages {
    ImageHeader header;      ///< of the first picture; bits and channels of its first sample
    std::int64_t count = 0;  ///< images in the file, at most mostTiffPages
    std::size_t byte = 0;    ///< offset of the first directory
};

inline constexpr std::int64_t mostTiffPages = 1000;  ///< further ones are not counted
inline constexpr std::uint64_t mostTiffTags = 1000;  ///< largest number of entries in one directory

/// Errors imageEndsEarly, malformed (`byte`): a directory beyond the file, more than mostTiffTags entries, no size.
TiffPages walkTiff(std::string_view bytes);

}  // namespace lathelier::io
