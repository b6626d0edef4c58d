// Named values for errors, notes, parameters and reports; sentences are made from them later (texts.h).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "engine/core/text.h"

namespace lathelier {

/// A closed range, in the unit of the name it is stored under.
struct Interval {
    double from = 0;  ///< lower end, included
    double to = 0;    ///< upper end, included; below `from` only where angles run through 0
    friend bool operator==(const Interval&, const Interval&) = default;
};

struct Row;

/// The rows of a table, each with the same names: the segments of a shaft, the rods of a measurement.
struct Rows {
    std::vector<Row> rows;
    friend bool operator==(const Rows& a, const Rows& b);
};

/// One value. monostate is "not given" (JSON null); Text is a translatable phrase (JSON: its English).
using Value = std::variant<std::monostate, bool, std::int64_t, double, std::string, std::vector<Interval>, Text,
                           std::vector<double>, std::vector<std::int64_t>, Rows>;

/// Values by name, in the order they were added. Names carry their unit ("extent_mm").
using Values = std::vector<std::pair<std::string, Value>>;

struct Row {
    Values cells;  ///< of the row, by the name of their column
    friend bool operator==(const Row&, const Row&) = default;
};

inline bool operator==(const Rows& a, const Rows& b)
{
    return a.rows == b.rows;
}

/// The value stored under `name`, or nullptr.
const Value* find(const Values& values, std::string_view name);

/// Stores `value` under `name`, replacing an earlier one.
void set(Values& values, std::string_view name, Value value);

}  // namespace lathelier
