// Question of the task compare: the parameters of the comparison, and the units of the two files.
#pragma once

#include <vector>

#include "engine/io/import.h"
#include "engine/registration/compare.h"

namespace lathelier::cad {

inline constexpr const char* zonesKey = "zones";  ///< table, and option of the file in its place
inline constexpr const char* referenceUnitKey =
    "reference_unit";                                    ///< of the command line: a window has a unit for each
inline constexpr const char* copyUnitKey = "copy_unit";  ///< likewise

struct CompareQuestion {
    registration::CompareParameters compare;
    io::LengthUnit reference_unit = io::LengthUnit::Auto;  ///< of the reference; Auto: as its reading options say
    io::LengthUnit copy_unit = io::LengthUnit::Auto;       ///< of the copies; Auto: as their reading options say
};

const std::vector<Field<CompareQuestion>>& fieldsOf(const CompareQuestion*);

}  // namespace lathelier::cad
