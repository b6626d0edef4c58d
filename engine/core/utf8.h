// The characters of UTF-8.
#pragma once

#include <cstddef>
#include <string_view>

namespace lathelier {

struct Utf8Character {
    char32_t code = 0;
    std::size_t length = 0;  ///< bytes; 0: no UTF-8
};

/// The character at byte `at`, which lies within `text`. Overlong forms, surrogates and what lies beyond U+10FFFF are
/// none.
Utf8Character utf8At(std::string_view text, std::size_t at);

}  // namespace lathelier
