// What the head of a file says of a JSON text, without parsing it: enough to tell kinds of file apart.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lathelier::io {

/// The keys of the object that a JSON text is, in their order, as far as `head` reaches; empty when it is no object.
/// Any encoding. Escapes in keys stay as they are.
std::vector<std::string> keysOfHead(std::string_view head);

/// Is the key one of them?
bool hasKey(const std::vector<std::string>& keys, std::string_view key);

}  // namespace lathelier::io
