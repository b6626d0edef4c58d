// Reading probe records: CSV tables and the recorder program L-Graph.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "engine/core/progress.h"
#include "engine/io/import.h"
#include "engine/io/input_files.h"
#include "engine/io/probe/probe_record.h"

namespace lathelier::io {

/// Properties not stated by an L-Graph pair.
struct RecorderOptions {
    std::optional<double> full_scale_code;  ///< converter code of `full_scale_V` at gain 1; default by device
    std::optional<double> full_scale_V;     ///< full scale at gain 1; default by device
};

const std::vector<Field<RecorderOptions>>& fieldsOf(const RecorderOptions*);

struct ProbeFile {
    std::variant<ProbeRecord, AveragedRecord> record;  ///< raw recording or averages
    FileFacts facts;  ///< format "probe_csv_raw" | "probe_csv_averaged" | "lgraph_1" | "lgraph_2008" | "lgraph_2";
                      ///< details: "channels", "frames", "rate_kHz", "duration_s", "channel_skew_us", "device"…;
                      ///< averaged: "sections", "angles"
    Notes notes;
};

/// The files of a record.
struct RecordFiles {
    enum class Kind { Table, LGraph };
    Kind kind = Kind::Table;  ///< text table or L-Graph pair
    std::string par;          ///< .par of an L-Graph; empty when missing
    std::string dat;          ///< .dat of an L-Graph; empty when missing
};

/// Finds the partner of `path`, whose content is `bytes`: the same name with .par or .dat in any case.
RecordFiles findRecordFiles(const std::string& path, std::string_view bytes);

/// The files beside `path` that could be its partner, by name alone: NAME.dat for NAME.par and the reverse, in any
/// case.
std::vector<std::string> recordPartners(const std::string& path);

/// Error partnerMissing (`path` of the file that is there, `partner`) when one of an L-Graph pair is not there.
void requirePartner(const RecordFiles& files);

/// True for a table whose headings are those of a probe record.
bool isProbeTable(std::string_view bytes, const ImportOptions& options = {});

/// Reads a record. CSV, raw: `t_s, marker_V (or angle_deg), X3_um, …`; averaged: `section, z_mm, i, angle_deg, X3_um…`;
/// key=value remarks are kept. L-Graph: NAME.dat or NAME.par, either of the pair may be given. L-Graph files are
/// checked for consistency (signature, counts, size of .dat, total time, rates, channel flags); contradictions give the
/// Error recordContradicts with `check`, `found`, `expected`, or a note where one source is known to be unreliable (the
/// converter rate of L-Graph II). Errors: those of readScan(); partnerMissing (a .dat without .par or the reverse),
/// recordContradicts, truncated.
ProbeFile readProbeRecord(const std::string& path, const ImportOptions& options = {},
                          const RecorderOptions& recorder = {}, const Progress& progress = {});

/// The same of a file that `inputs` has opened, with its content `bytes`; the partner is opened there as well. Parsed
/// parts of a large table are released: `bytes` must not be read again.
ProbeFile readProbeRecord(const std::string& path, std::string_view bytes, InputFiles& inputs,
                          const ImportOptions& options, const RecorderOptions& recorder, const Progress& progress);

}  // namespace lathelier::io
