// Frequency responses in text tables.
#pragma once

#include <string_view>

#include "engine/io/frf/frf_reader.h"

namespace lathelier::io {

/// A table from memory. Columns by the first word of their headings: frequency (f, freq; omega, w), and real (re) with
/// imag (im), or else magnitude (mag, abs, amplitude; in dB with its reference) with phase (angle), or complex numbers;
/// coherence (coh) where there is one; without headings as FrfOptions::frf_columns states. CutPro: three columns, named
/// behind the numbers of the first row. Errors as readFrf().
FrfFile readFrfTable(const std::string& name, std::string_view bytes, const ImportOptions& options,
                     const FrfOptions& frf, const Progress& progress);

/// True for a table whose headings or complex numbers are those of a frequency response, or whose columns are stated.
bool isFrfTable(std::string_view head, const ImportOptions& options = {}, const FrfOptions& frf = {});

}  // namespace lathelier::io
