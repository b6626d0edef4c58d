// The unrolled map of a comparison on few cells: small enough to be kept with every result of a series, so that thirty
// of them stand beside each other as pictures.
#pragma once

#include <vector>

#include "engine/core/quantities.h"
#include "engine/registration/compare.h"

namespace lathelier::registration {

inline constexpr int coarseRows = 24;     ///< at most, along the axis
inline constexpr int coarseColumns = 36;  ///< at most, over 360°

/// Means of cells of the unrolled map; row-major, z slow; NaN where no cell has points. Rounded to 0.1 µm.
struct CoarseMap {
    double z_start_mm = 0;  ///< lower edge of the first row
    double z_step_mm = 1;   ///< height of a row; the last one may be lower
    int z_count = 0;
    int angle_count = 0;  ///< over 360°, cell centres at (j + ½)·360/angle_count
    std::vector<double> mean_mm;
};

const std::vector<QuantityOf<CoarseMap>>& quantitiesOf(const CoarseMap*);

CoarseMap coarseOf(const UnrolledMap& map);

}  // namespace lathelier::registration
