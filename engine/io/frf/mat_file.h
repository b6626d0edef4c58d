// MAT files of level 5 (MATLAB 5 to 7, not 7.3): variables, their kinds and their numbers. Source: The MathWorks,
// MAT-File Format, chapter 1 (level 5). A minimal reader for frequency responses: libmatio 1.5.23 reads from paths only
// and does not return from some damaged files of 2.5 KB.
#pragma once

#include <complex>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/progress.h"

namespace lathelier::io {

/// A variable.
struct MatVariable {
    std::string name;
    std::int64_t rows = 0;     ///< first dimension
    std::int64_t columns = 0;  ///< product of the other dimensions
    std::string class_name;  ///< "double", "single", "int8"…, "char", "cell", "struct", "sparse", "object", "unknown"
    bool is_complex = false;  ///< true: imaginary parts exist
    bool is_number = false;   ///< a full matrix of numbers, which readMatValues() takes
    std::int64_t byte = 0;    ///< where its element begins in the file

    std::int64_t count() const { return rows * columns; }  ///< of its numbers; both are limited to 2^31
};

/// True when `head` is that of a MAT file of level 5, or of a MAT file 7.3, which readMatVariables() rejects by name.
bool isMat(std::string_view head);

/// All variables. Of a compressed one only the head is inflated. Errors formatUnknown, malformed, truncated, all with
/// `byte`.
std::vector<MatVariable> readMatVariables(std::string_view bytes, const Progress& progress = {});

/// The numbers of a variable, column by column. Memory grows with the data, up to 256 MiB per variable. Errors
/// malformed, truncated (`byte`).
std::vector<std::complex<double>> readMatValues(std::string_view bytes, const MatVariable& variable);

}  // namespace lathelier::io
