// From the functions of a universal file to frequency responses.
#pragma once

#include "engine/io/frf/frf_reader.h"
#include "engine/io/frf/uff.h"

namespace lathelier::io {

/// All frequency responses of the file, in its order. Notes of frf_codes.h. Errors frfUnitMissing, frfNone,
/// frfNotAscending (`line`).
std::vector<MeasuredFrf> uffFrfs(const UffFile& file, const FrfOptions& options, Notes& notes);

/// "receptance", "mobility", "accelerance" by unit, else by kind of ordinate; "other" for functions of another kind.
std::string uffOrdinate(const UffFunction& function);

/// A row of `datasets` for inspect.
Row uffFacts(const UffSet& set);

}  // namespace lathelier::io
