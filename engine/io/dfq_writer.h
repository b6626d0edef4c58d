// Q-DAS ASCII transfer format (.dfq): characteristics with limits and values for statistical process control.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/core/value.h"

namespace lathelier {

struct QdasCharacteristic {
    std::string number;                 ///< K2001
    std::string description;            ///< K2002
    std::string unit;                   ///< K2142, "µm"
    int decimals = 4;                   ///< K2022
    std::optional<double> nominal;      ///< K2101
    std::optional<double> lower_limit;  ///< K2110
    std::optional<double> upper_limit;  ///< K2111
    std::vector<double> values;         ///< K0001
};

struct QdasFile {
    std::string part_number;       ///< K1001
    std::string part_description;  ///< K1002
    std::string machine;           ///< K1082
    std::string measured;          ///< K0004, "dd.mm.yyyy/hh:mm:ss"; empty leaves it out
    std::vector<QdasCharacteristic> characteristics;
};

/// The file's bytes, CRLF, windows-1252 where it can say it. Values are written with a decimal point.
std::string toDfq(const QdasFile& file);

/// Reads what toDfq() writes, and its kin. Errors malformed (line), fileEmpty. For round-trip tests and imports.
QdasFile readDfq(const std::string& name, std::string_view bytes);

/// Writes beside, then renames. Error fileNotWritable.
void writeDfq(const std::string& path, const QdasFile& file);

}  // namespace lathelier
