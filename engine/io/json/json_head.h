// Keys of a JSON text from the head of a file, without parsing, to distinguish kinds of file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lathelier::io {

/// The keys of the top-level object in order, as far as `head` reaches; empty when it is not an object. Any encoding.
/// Escapes in keys stay as they are.
std::vector<std::string> keysOfHead(std::string_view head);

/// Whether the key is one of them.
bool hasKey(const std::vector<std::string>& keys, std::string_view key);

}  // namespace lathelier::io
