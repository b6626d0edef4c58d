// Columns of the full table of a shaft, used for writing and reading.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/shaft/shaft.h"

namespace lathelier::cad {

struct CsvColumn {
    const char* name;  ///< column heading
    std::optional<double> (*get)(const ShaftSegment& row);
    void (*set)(ShaftSegment& row, double value);
    bool required;  ///< tables without it are refused
};

/// Numbers of a row; a bore's rows use the first ones through a ShaftSegment.
const std::vector<CsvColumn>& csvColumns();

}  // namespace lathelier::cad
