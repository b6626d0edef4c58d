// How often a text holds another.
#pragma once

#include <cstddef>
#include <string>

namespace lathelier {

inline std::size_t occurrences(const std::string& text, const std::string& what)
{
    std::size_t result = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++result;
    return result;
}

}  // namespace lathelier
