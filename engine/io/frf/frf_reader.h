// Reading frequency responses: universal files (UFF), tables, MAT files.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/core/progress.h"
#include "engine/io/file_kind.h"
#include "engine/io/frf/frf_unit.h"
#include "engine/io/frf/measured_frf.h"
#include "engine/io/import.h"

namespace lathelier::io {

enum class FrfUnitChoice { Auto, MmPerN, MPerN, MmPerSN, MPerSN, MmPerS2N, MPerS2N };

/// What a file of frequency responses may leave open, besides ImportOptions.
struct FrfOptions {
    FrfUnitChoice frf_unit = FrfUnitChoice::Auto;  ///< of values whose unit the file does not state
    std::string variables;                         ///< MAT: "f=NAME,H=NAME"; empty: found by their names
};

const std::vector<Field<FrfOptions>>& fieldsOf(const FrfOptions*);

/// The unit of a choice; nothing for Auto.
std::optional<FrfUnit> frfUnit(FrfUnitChoice choice);

/// "mm/N", "m/s2/N"; "auto".
std::string frfUnitKey(FrfUnitChoice choice);

struct FrfFile {
    std::vector<MeasuredFrf> frfs;  ///< at least one
    FileFacts facts;                ///< format "UFF" | "frf_csv" | "MAT"; listed at readFrfFacts()
    Notes notes;                    ///< those of frf_codes.h, and of tables
};

/// Reads all frequency responses of a file.
/// UFF: functions of type 4 with complex values; by its unit, else by its kind of ordinate (8, 11, 12) each is a
/// receptance, mobility or accelerance; a unit that is stated rules, then a set 164, then the given one. Signs of
/// directions are applied. Coherence (function 6) of the same pair of places and the same lines is attached. Functions
/// of anything else are passed over with a note.
/// CSV: columns frequency_hz with real_… and imag_…, or magnitude_… and phase_deg; units as in "real_mm_N",
/// "real (m/s^2/N)" or a row of units; coherence may be there.
/// MAT, level 5: a real vector f, freq, frequency or *_hz and one complex array of the same length.
/// Lines without finite values are left out with a note. Errors: formatUnknown, malformed, truncated, uffPointsMissing,
/// frfUnitMissing, frfNone, frfNotAscending, frfVariablesUnknown, columnsUnknown, columnsAmbiguous; those of tables.
FrfFile readFrf(const std::string& path, const ImportOptions& options = {}, const FrfOptions& frf = {},
                const Progress& progress = {});

/// The same from memory; `name` stands for the path in messages.
FrfFile readFrf(const std::string& name, std::string_view bytes, const ImportOptions& options, const FrfOptions& frf,
                const Progress& progress = {});

/// What is in the file, whether or not it can be used as a frequency response. details: UFF "datasets" [{type, line,
/// function, ordinate, unit, denominator_unit, data_type, points, x_first, x_last, y_first, y_last, response_node…}],
/// "nodes"; MAT "variables" [{name, rows, columns, class, complex}]; CSV "points", "quantity", "column_names".
/// Errors as readFrf(), but a UFF or MAT file without a frequency response or its unit is described all the same.
FileFacts readFrfFacts(const std::string& name, std::string_view bytes, const ImportOptions& options,
                       const FrfOptions& frf, Notes& notes, const Progress& progress = {});

/// How much the head of a file speaks for this kind: a universal or MAT file, or a table whose headings are those of a
/// frequency response, is certain; for another one only its name may speak.
Likeness likeFrf(const std::string& path, std::string_view head, const ImportOptions& options);

}  // namespace lathelier::io
