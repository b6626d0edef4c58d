// Changes by hand to the structure that a recognition found: rows deleted, merged, split, of another
// kind.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace lathelier::features {

struct RowChange {
    enum class What : std::uint8_t { Delete, Merge, Split, Cylinder, Cone, Round, Fillet };
    What what = What::Delete;  ///< Merge: with the next row; Cylinder…: the row's kind, Round convex, Fillet hollow
    std::int64_t row = 0;      ///< of the rows that the changes before it left, from 1
    double z_mm = 0;           ///< Split: from the free end
    friend bool operator==(const RowChange&, const RowChange&) = default;
};

/// "delete:3,merge:4,split:2@35.2,cone:5": as the parameters of a project keep them. Entries that are not understood,
/// and those after the first 1000, are left out.
std::vector<RowChange> rowChanges(std::string_view text);
std::string textOf(const std::vector<RowChange>& changes);

}  // namespace lathelier::features
