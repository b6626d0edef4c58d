// Writing frequency responses: universal files and tables. Numbers have a decimal point in every locale.
#pragma once

#include <span>
#include <string>

#include "engine/io/frf/measured_frf.h"

namespace lathelier::io {

/// A universal file as text: for each response a set 58 of function 4, abscissa 18 in Hz, ordinate 8, 11 or 12 in mm,
/// mm/s or mm/s^2 by its quantity, denominator 13 in N, complex double; even where the frequencies are x0 + i·dx to
/// 1e-6 of a step, else uneven. The columns hold ten digits of a frequency and thirteen of a value. Coherence follows
/// as a set of function 6 of the same pair.
std::string toUff(std::span<const MeasuredFrf> responses);

/// Columns frequency_hz, real_mm_N, imag_mm_N (…_mm_s_N, …_mm_s2_N by the quantity), and coherence if known; full
/// precision.
std::string toFrfCsv(const Frf& frf);

/// Writes the same to `path` atomically. Error fileNotWritable.
void writeUff(const std::string& path, std::span<const MeasuredFrf> responses);
void writeFrfCsv(const std::string& path, const Frf& frf);

}  // namespace lathelier::io
