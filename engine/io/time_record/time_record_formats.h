// The formats of time records, read by time_record_reader.h.
#pragma once

#include "engine/io/time_record/time_record_reader.h"

namespace lathelier::io {

/// Errors and notes without a path.
TimeRecordFile readTimeTable(const std::string& name, std::string_view bytes, const ImportOptions& options,
                             const Progress& progress);
bool isTimeTable(std::string_view head, const ImportOptions& options);

TimeRecordFile readTimeUff(std::string_view bytes, const Progress& progress);
/// True where the first function in the head is one of time.
bool isTimeUff(std::string_view head);

/// RIFF WAVE, "fmt " of format 1 (16, 24, 32 bits), 3 (32 bits), or either as extensible; chunks in any order before
/// "data". A size of 0 or -1 of the last chunk, as recorders that were stopped leave it, is the rest of the file.
/// Source: Microsoft, "Multimedia Programming Interface and Data Specifications 1.0", 1991, and WAVEFORMATEXTENSIBLE.
/// Errors malformed, truncated (`byte`). Values: parts of full scale.
TimeRecordFile readWav(std::string_view bytes, const Progress& progress);
bool isWav(std::string_view head);

}  // namespace lathelier::io
