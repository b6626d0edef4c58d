// Visible text as data: an English literal marked for translation, never a composed sentence.
#pragma once

#include <string_view>

/// Marks an English literal for translation. lupdate reads it as QT_TRANSLATE_NOOP (see translations/CMakeLists.txt).
// clang-format off
#define LT_TEXT(context, english) ::lathelier::Text{english}
// clang-format on

namespace lathelier {

/// An English literal with static lifetime. Empty when default constructed.
struct Text {
    const char* english = "";

    bool empty() const { return *english == '\0'; }
    friend bool operator==(const Text& a, const Text& b) { return std::string_view(a.english) == b.english; }
};

}  // namespace lathelier
