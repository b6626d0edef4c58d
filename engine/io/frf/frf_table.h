// Frequency responses in text tables.
#pragma once

#include <string_view>

#include "engine/io/frf/frf_reader.h"

namespace lathelier::io {

/// A table from memory. Columns by the first word of their headings: frequency (f, freq), and real (re) with imag (im),
/// or else magnitude (mag, abs, amplitude) with phase (angle); coherence (coh) where there is one. Errors as readFrf().
FrfFile readFrfTable(const std::string& name, std::string_view bytes, const ImportOptions& options,
                     const FrfOptions& frf, const Progress& progress);

/// True for a table whose headings are those of a frequency response.
bool isFrfTable(std::string_view head, const ImportOptions& options = {});

}  // namespace lathelier::io
