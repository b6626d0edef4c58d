// Reading time records: tables, universal files (functions of type 1), WAV.
#pragma once

#include <string>
#include <string_view>

#include "engine/core/progress.h"
#include "engine/io/file_kind.h"
#include "engine/io/import.h"
#include "engine/io/time_record/time_record.h"

namespace lathelier::io {

struct TimeRecordFile {
    TimeRecord record;  ///< at least one channel
    FileFacts facts;    ///< format "time_csv" | "UFF" | "WAV"; details: "channels" [{number, name, unit, role, points,
                        ///< rate_hz, start_s}], "rate_hz", "duration_s"; UFF "datasets" as readFrfFacts()
    Notes notes;        ///< those of time_record_codes.h, and of tables
};

/// Reads all channels of a record. Tables: columns with units as in "force_N", "acc_m_s2", "a (g)", or a row of units;
/// a column of times must be even (errors timeUneven), else the header may state rate_hz. UFF: functions of type 1 with
/// real values; units as stated, else by a set 164 and the kind of ordinate; signs of directions are applied. WAV:
/// whole numbers of 16, 24 and 32 bits, and floating point of 32 bits; values are parts of full scale. `name` replaces
/// the path in messages. Errors: formatUnknown, malformed, truncated, uffPointsMissing, timeUneven, timeRecordNone;
/// those of tables. Throws Cancelled.
TimeRecordFile readTimeRecord(const std::string& name, std::string_view bytes, const ImportOptions& options = {},
                              const Progress& progress = {});

/// Confidence by the head of a file: WAV, a universal file whose first function is one of time, a table of a force with
/// times or a motion.
Likeness likeTimeRecord(std::string_view head, const ImportOptions& options);

/// As a kind of file.
const FileKind& timeRecordFiles();

/// The role of a channel by its unit, else by its name: "hammer", "acc".
TimeChannel::Role roleOf(const std::string& name, const std::optional<SignalUnit>& unit);

}  // namespace lathelier::io
