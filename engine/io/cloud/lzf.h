// LZF decompression (Marc Lehmann's LibLZF format), as PCD files use it.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace lathelier::io {

/// The uncompressed bytes; none when the data are damaged or not exactly `size` bytes. Memory grows with the output,
/// not with `size`.
std::optional<std::string> decompressLzf(std::string_view compressed, std::size_t size);

}  // namespace lathelier::io
