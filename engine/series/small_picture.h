// The deviation picture of one archived comparison: its map on few cells, as the result keeps it (registration's
// coarse_map.h), so that it can be drawn without the scans.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/core/conformity.h"
#include "engine/core/json.h"
#include "engine/report/chart.h"

namespace lathelier::series {

struct SmallPicture {
    std::string uuid;  ///< of the evaluation
    std::string file;  ///< name of the scan
    std::optional<Verdict> verdict;
    report::ColourMap map;  ///< z across, angle upwards, mm
};

/// None: the result has no map (no comparison, no body of revolution, of an older version), or it is malformed.
std::optional<report::ColourMap> mapOf(const Json& result);

/// One scale for all: the smallest readable limit within which nine of ten cells lie: the ends of a part do not choose
/// it.
void scaleAlike(std::vector<SmallPicture>& pictures);

}  // namespace lathelier::series
