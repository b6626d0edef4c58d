// Signals over time of several channels, evenly sampled: the records of an impact test.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/io/time_record/signal_unit.h"

namespace lathelier::io {

struct TimeChannel {
    enum class Role { Unknown, Force, Motion };

    std::int64_t number = 1;            ///< column or channel of the file, from 1
    std::string heading;                ///< as written; empty: the file names none
    std::string name;                   ///< without the unit
    std::optional<SignalUnit> unit;     ///< of `values`; none: not stated
    std::string unit_text;              ///< as written
    Role role = Role::Unknown;          ///< by the unit, a name, or the kind of ordinate of a universal file
    bool is_of_full_scale = false;      ///< `values` are parts of the recorder's full scale: -1 to 1
    int node = 0;                       ///< of a universal file; 0: not stated
    int direction = 0;                  ///< 1 x, 2 y, 3 z, 0: not stated; a minus sign is applied to the values
    std::int64_t line = 0;              ///< where it stands in the file, from 1; 0: not by lines
    std::int64_t missing_line = 0;      ///< line of the first sample without a finite value; 0: all are there
    std::optional<double> rate_hz;      ///< none: neither times nor a rate are stated
    double start_s = 0;                 ///< time of the first sample
    std::vector<double> values;         ///< in `unit`; NaN where missing
    std::vector<std::size_t> at_limit;  ///< samples at the ends of the converter's range, ascending
};

/// Channels of a universal file may differ in length and rate; those of other files do not.
struct TimeRecord {
    std::string name;                   ///< name of the file without folder
    std::vector<TimeChannel> channels;  ///< in the order of the file; without that of the times
};

}  // namespace lathelier::io
