// What every reader asks first: is this text at all, or a file of a foreign kind?
#pragma once

#include <string_view>

#include "engine/core/text.h"
#include "engine/io/encoding.h"

namespace lathelier {

/// Throws Error formatUnknown for kinds of files that a person may well drop here and that hold none of our data
/// (pictures, archives, documents…). `expected` says what would be right.
void refuseForeign(std::string_view bytes, Text expected);

/// Throws Error formatUnknown (`byte` 0, `found`, `expected`).
[[noreturn]] void throwUnknownFormat(Text found, Text expected);

/// The text of a file of numbers. Errors fileEmpty, formatUnknown (foreign or binary), malformed (encoding).
DecodedText readableText(std::string_view bytes, Encoding encoding, Text expected, const Progress& progress);

}  // namespace lathelier
