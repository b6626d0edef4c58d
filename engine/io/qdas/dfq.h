// Q-DAS ASCII transfer format (.dfq): characteristics with limits and values for statistical process control.
// Source: Q-DAS ASCII transfer format and the key fields that AQDEF asks of a measuring system (K0100, K1001, K1082,
// K2001, K2002, K2022, K2101, K2110, K2111, K2120, K2121, K2142, and K0001, K0002, K0004 for every value).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace lathelier::io {

struct QdasCharacteristic {
    std::string number;                 ///< characteristic number (K2001)
    std::string description;            ///< K2002; 80 characters of it are written
    std::string unit;                   ///< unit (K2142), "µm"
    int decimals = 4;                   ///< decimals (K2022)
    std::optional<double> nominal;      ///< nominal value (K2101)
    std::optional<double> lower_limit;  ///< K2110; K2120 is 0 without it, else 1, or 2 when it is natural
    std::optional<double> upper_limit;  ///< K2111; K2121 accordingly
    std::vector<double> values;         ///< K0001; NaN: invalid (K0002)
    std::vector<std::string> measured;  ///< K0004 of each value, "dd.mm.yyyy/hh:mm:ss"; missing ones are left out
    bool lower_is_natural = false;      ///< no value can lie below, as none of a form deviation lies below 0
    bool upper_is_natural = false;      ///< no value can lie above
};

struct QdasFile {
    std::string part_number;                          ///< part number (K1001)
    std::string part_description;                     ///< part description (K1002)
    std::string machine;                              ///< machine (K1082)
    std::vector<QdasCharacteristic> characteristics;  ///< in the order of the file
    std::int64_t parts = 1;                           ///< number of parts read: K1001/1, K1001/2…
};

}  // namespace lathelier::io
