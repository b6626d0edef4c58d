// First check of every reader: text, or a file of a foreign kind.
#pragma once

#include <cstddef>
#include <string_view>

#include "engine/core/text.h"
#include "engine/io/text/encoding.h"

namespace lathelier::io {

/// Number of bytes at the start of a text used for the decision.
inline constexpr std::size_t textHeadBytes = 65536;

/// Throws Error formatUnknown for common kinds of files without usable data (pictures, archives, documents…).
/// `expected` names the expected kind.
void refuseForeign(std::string_view bytes, Text expected);

/// Throws Error formatUnknown when the extension of a file denotes a foreign kind ("part.step", "fit.py"). Where a
/// table of numbers is read, `isTable`, an extension of a mesh or scan is foreign too.
void refuseForeignName(std::string_view name, bool isTable, Text expected);

/// Throws Error formatUnknown (`line`, `column`) for the source text of a program and for JSON: their numbers are not
/// rows of measured values.
void refuseProgram(std::string_view text, Text expected);

/// True for Q-DAS: the first line is a K-field.
bool looksLikeQdas(std::string_view text);

/// Throws Error formatUnknown (`byte` 0, `found`, `expected`).
[[noreturn]] void throwUnknownFormat(Text found, Text expected);

/// The text of a file of numbers. Errors fileEmpty, formatUnknown (foreign, binary, or with more padding than a disk
/// cluster), malformed (encoding).
DecodedText readableText(std::string_view bytes, Encoding encoding, Text expected, const Progress& progress);

/// The same for a table: another kind by name or content is rejected (formatUnknown): a mesh, a Q-DAS file, the source
/// text of a program. An empty name is not checked.
DecodedText readableTable(std::string_view name, std::string_view bytes, Encoding encoding, Text expected,
                          const Progress& progress);

}  // namespace lathelier::io
