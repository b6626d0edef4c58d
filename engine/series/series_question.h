// What is asked of a series of evaluated parts: which characteristic, of which archive, over which parts.
#pragma once

#include <string>
#include <vector>

#include "engine/core/fields.h"

namespace lathelier::series {

inline constexpr const char* archiveRole = "archive";
inline constexpr const char* databaseKey = "database";
inline constexpr const char* taskKey = "task";
inline constexpr const char* characteristicKey = "characteristic";
inline constexpr const char* partKey = "part";

struct SeriesQuestion {
    std::string database;        ///< as libpq names it; empty: the archive is a file
    std::string task;            ///< key of the task; empty: of the latest evaluation that has numbers
    std::string characteristic;  ///< key; empty: its answer, else its first characteristic
    std::string recipe;          ///< SHA-256 of the recipe; empty: any
    std::string from;            ///< first date; empty: any
    std::string to;              ///< last date, included; empty: any
    int most = 1000;             ///< the latest so many
    std::string part;            ///< UUID of the part that is shown in detail; empty: the latest
};

/// `part` is kept by a window.
const std::vector<Field<SeriesQuestion>>& fieldsOf(const SeriesQuestion*);

}  // namespace lathelier::series
