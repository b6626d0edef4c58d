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

/// Reading options of frequency responses, besides ImportOptions.
struct FrfOptions {
    FrfUnitChoice frf_unit = FrfUnitChoice::Auto;  ///< unit of values without a stated one
    std::string variables;                         ///< MAT: "f=NAME,H=NAME"; empty: found by their names
};

const std::vector<Field<FrfOptions>>& fieldsOf(const FrfOptions*);

/// The unit of a choice; nothing for Auto.
std::optional<FrfUnit> frfUnit(FrfUnitChoice choice);

/// "mm/N", "m/s2/N"; "auto".
std::string frfUnitKey(FrfUnitChoice choice);

struct FrfFile {
    std::vector<MeasuredFrf> frfs;  ///< responses, at least one
    FileFacts facts;                ///< format "UFF" | "frf_csv" | "MAT"; listed at readFrfFacts()
    Notes notes;                    ///< those of frf_codes.h, and of tables
};

/// Reads all frequency responses of a file. UFF: functions of type 4 with complex values; by its unit, else by its kind
/// of ordinate (8, 11, 12) each is a receptance, mobility or accelerance; a stated unit has precedence, then a set 164,
/// then the given one. Signs of directions are applied. Coherence (function 6) of the same pair of places and the same
/// lines is attached, and the noise of each line (frf_noise.h). Other functions are skipped with a note. CSV: columns
/// frequency_hz with real_… and imag_…, or magnitude_… and phase_deg; units as in "real_mm_N", "real (m/s^2/N)" or a
/// row of units; optionally coherence. MAT, level 5: a real vector f, freq, frequency or *_hz and one complex array of
/// the same length. Lines without finite values are skipped with a note. Errors: formatUnknown, malformed, truncated,
/// uffPointsMissing, frfUnitMissing, frfNone, frfNotAscending, frfVariablesUnknown, columnsUnknown, columnsAmbiguous;
/// those of tables.
FrfFile readFrf(const std::string& path, const ImportOptions& options = {}, const FrfOptions& frf = {},
                const Progress& progress = {});

/// The same from memory; `name` replaces the path in messages.
FrfFile readFrf(const std::string& name, std::string_view bytes, const ImportOptions& options, const FrfOptions& frf,
                const Progress& progress = {});

/// Content of the file, whether or not it is usable as a frequency response. details: UFF "datasets" [{type, line,
/// function, ordinate, unit, denominator_unit, data_type, points, x_first, x_last, y_first, y_last, response_node…}],
/// "nodes"; MAT "variables" [{name, rows, columns, class, complex}]; CSV "points", "quantity", "column_names". Errors
/// as readFrf(), but a UFF or MAT file without a frequency response or its unit is described as well.
FileFacts readFrfFacts(const std::string& name, std::string_view bytes, const ImportOptions& options,
                       const FrfOptions& frf, Notes& notes, const Progress& progress = {});

/// Confidence by the head of a file: a universal or MAT file, or a table with the headings of a frequency response, is
/// certain; otherwise only the name counts.
Likeness likeFrf(const std::string& path, std::string_view head, const ImportOptions& options);

}  // namespace lathelier::io
