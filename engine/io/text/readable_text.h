// What every reader asks first: is this text at all, or a file of a foreign kind?
#pragma once

#include <cstddef>
#include <string_view>

#include "engine/core/text.h"
#include "engine/io/text/encoding.h"

namespace lathelier::io {

/// The beginning of a text that tells what it is.
inline constexpr std::size_t textHeadBytes = 65536;

/// Throws Error formatUnknown for kinds of files that a person may well drop here and that hold none of our data
/// (pictures, archives, documents…). `expected` says what would be right.
void refuseForeign(std::string_view bytes, Text expected);

/// Throws Error formatUnknown when the name of a file says that it is of a foreign kind ("part.step", "fit.py"). Where
/// a table of numbers is read, `isTable`, a name that promises a mesh or a scan is foreign too.
void refuseForeignName(std::string_view name, bool isTable, Text expected);

/// Throws Error formatUnknown (`line`, `column`) for the source text of a program and for JSON: their numbers are no
/// rows of measured values.
void refuseProgram(std::string_view text, Text expected);

/// True for Q-DAS: the first line is a K-field.
bool looksLikeQdas(std::string_view text);

/// Throws Error formatUnknown (`byte` 0, `found`, `expected`).
[[noreturn]] void throwUnknownFormat(Text found, Text expected);

/// The text of a file of numbers. Errors fileEmpty, formatUnknown (foreign, binary, or with more than a disk's cluster
/// of filling behind it), malformed (encoding).
DecodedText readableText(std::string_view bytes, Encoding encoding, Text expected, const Progress& progress);

/// The same for a table: what its name or its content says to be something else is refused (formatUnknown): a mesh, a
/// Q-DAS file, the source text of a program. An empty name says nothing.
DecodedText readableTable(std::string_view name, std::string_view bytes, Encoding encoding, Text expected,
                          const Progress& progress);

}  // namespace lathelier::io
