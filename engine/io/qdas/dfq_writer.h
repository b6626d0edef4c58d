// Q-DAS ASCII transfer format (.dfq): characteristics with limits and values for statistical process control.
// Source: Q-DAS ASCII transfer format and the key fields that AQDEF asks of a measuring system (K0100, K1001, K1082,
// K2001, K2002, K2022, K2101, K2110, K2111, K2120, K2121, K2142, and K0001, K0002, K0004 for every value).
#pragma once

#include <ctime>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/value.h"
#include "engine/io/import.h"

namespace lathelier::io {

struct QdasCharacteristic {
    std::string number;                 ///< K2001
    std::string description;            ///< K2002; 80 characters of it are written
    std::string unit;                   ///< K2142, "µm"
    int decimals = 4;                   ///< K2022
    std::optional<double> nominal;      ///< K2101
    std::optional<double> lower_limit;  ///< K2110; K2120 is 0 without it, else 1, or 2 when it is natural
    std::optional<double> upper_limit;  ///< K2111; K2121 alike
    std::vector<double> values;         ///< K0001; NaN: invalid (K0002)
    std::vector<std::string> measured;  ///< K0004 of each value, "dd.mm.yyyy/hh:mm:ss"; missing ones are left out
    bool lower_is_natural = false;      ///< no value can lie below, as none of a form deviation lies below 0
    bool upper_is_natural = false;      ///< no value can lie above
};

struct QdasFile {
    std::string part_number;                          ///< K1001
    std::string part_description;                     ///< K1002
    std::string machine;                              ///< K1082
    std::vector<QdasCharacteristic> characteristics;  ///< in the order of the file
    std::int64_t parts = 1;                           ///< read: K1001/1, K1001/2…
};

/// The file's bytes, CRLF, all in one encoding: windows-1252 where that can say it, else UTF-8 with its mark. Values
/// are written with a decimal point.
std::string toDfq(const QdasFile& file);

/// A time as K0004 has it, in the local time zone: "21.04.2015/12:00:00".
std::string qdasTime(std::time_t time);

/// Reads what toDfq() writes, and its kin: K-fields for values, or the short lines of values (characteristics parted by
/// 0x0F, what belongs to a value by 0x14). Errors malformed (line), fileEmpty, formatUnknown.
QdasFile readDfq(const std::string& name, std::string_view bytes);

/// What `inspect` says of such a file: format "qdas", details "parts", "characteristics", "values", "part_number"…
/// Errors of readDfq().
FileFacts readDfqFacts(const std::string& name, std::string_view bytes);

/// True when a file is Q-DAS by its first field (its name may promise it, and not keep it).
bool isDfq(std::string_view bytes);

/// Writes beside, then renames. Error fileNotWritable.
void writeDfq(const std::string& path, const QdasFile& file);

}  // namespace lathelier::io
