// Writes the Q-DAS ASCII transfer format.
#pragma once

#include <ctime>
#include <string>

#include "engine/io/qdas/dfq.h"

namespace lathelier::io {

/// The file's bytes, CRLF, all in one encoding: windows-1252 where possible, else UTF-8 with byte order mark. Values
/// are written with a decimal point.
std::string toDfq(const QdasFile& file);

/// A time as K0004 has it, in the local time zone: "21.04.2015/12:00:00".
std::string qdasTime(std::time_t time);

/// Writes a temporary file, then renames it. Error fileNotWritable.
void writeDfq(const std::string& path, const QdasFile& file);

}  // namespace lathelier::io
