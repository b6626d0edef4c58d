// Criterion for the selection between models of a stretch of the meridian: misfit plus a penalty for the free
// parameters (Schwarz).
#pragma once

#include "engine/features/model/model_fit.h"

namespace lathelier::features {

/// 2.5 ln n for each parameter, n walls of the model (Schwarz 1978, with a wider margin).
double price(const Model& model, std::size_t parameters);

/// The elements that are free while element k is tested, and the stretch over which the misfit is summed.
struct Scope {
    Window window;
    double from_mm = 0, to_mm = 0;
};
/// Neighbours of elements first to last are free where they are shorter than 5 mm.
Scope scopeOf(const Run& run, std::size_t r, std::size_t first, std::size_t last);

/// The model judged over the scope, after a fit there: misfit and price of the free parameters. An arc tied to a plane
/// may continue behind it unseen, as that of an undercut face does: this tie counts as less than a full parameter.
double criterion(Model& model, const Scope& scope, int iterations);

/// Is the radius beyond the plane larger? At the ends of the part it is not.
bool isFoot(const Model& model, std::size_t run, bool start);

}  // namespace lathelier::features
