// What a scan without rows loses beside edges.
#pragma once

#include "engine/features/model/model.h"

namespace lathelier::features {

/// Distance from the shoulders of a model within which the walls beside them have no points: the median over both sides
/// of all; 0.1 mm where no shoulder shows it. Surface scanners see no point near edges, and the ends of walls whose
/// faces they do not see lie further out by as much.
double lossAtEdges_mm(const MeridianCloud& cloud, const Model& model);

}  // namespace lathelier::features
