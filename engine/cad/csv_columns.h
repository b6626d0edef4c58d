// The columns of a shaft's full table: written and read by one list.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/core/shaft.h"

namespace lathelier::cad {

struct CsvColumn {
    const char* name;  ///< as people read it
    std::optional<double> (*get)(const ShaftSegment& row);
    void (*set)(ShaftSegment& row, double value);
    bool required;  ///< a table without it is refused
};

/// Numbers of a row; a bore's rows use the first ones through a ShaftSegment.
const std::vector<CsvColumn>& csvColumns();

}  // namespace lathelier::cad
