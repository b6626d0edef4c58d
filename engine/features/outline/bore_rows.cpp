#include "engine/features/outline/bore_rows.h"

#include <algorithm>
#include <cmath>

namespace lathelier::features {
namespace {

/// Moves an end of a row along a line; the diameter of a cone follows. An arc keeps its circle: only its end moves.
void moveEnd(RecognizedRow& row, bool start, double z_mm)
{
    double& end = start ? row.z_start_mm : row.z_end_mm;
    double& diameter = start ? row.start_diameter_mm : row.end_diameter_mm;
    const double length = row.z_end_mm - row.z_start_mm;
    if (row.kind == RowKind::Cone && length > 0)
        diameter += (row.end_diameter_mm - row.start_diameter_mm) / length * (z_mm - end);
    end = z_mm;
}

}  // namespace

std::vector<RecognizedRow> rowsWithinPart(std::vector<RecognizedRow> rows, double length_mm)
{
    for (RecognizedRow& row : rows) {
        if (row.z_start_mm < 0 && row.z_end_mm > 0) moveEnd(row, true, 0);
        if (row.z_end_mm > length_mm && row.z_start_mm < length_mm) moveEnd(row, false, length_mm);
    }
    std::erase_if(rows, [&](const RecognizedRow& row) {
        return !(row.z_start_mm >= 0 && row.z_start_mm < row.z_end_mm && row.z_end_mm <= length_mm);
    });
    return rows;
}

}  // namespace lathelier::features
