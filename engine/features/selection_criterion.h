// What decides between models of a stretch of the meridian: misfit and the price of the free parameters.
#pragma once

#include "engine/features/model_fit.h"

namespace lathelier::features {

/// What a new element or an undercut must gain beyond its price.
inline constexpr double leastGain = 8;

/// 2.5 ln n for each parameter, n walls of the model (Schwarz 1978, with a wider margin).
double price(const Model& model, std::size_t parameters);

/// The elements that are free while element k is judged, and the stretch that is looked at.
struct Scope {
    Window window;
    double from_mm = 0, to_mm = 0;
};
/// Neighbours of elements first to last are free where they are shorter than 5 mm.
Scope scopeOf(const Run& run, std::size_t r, std::size_t first, std::size_t last);

/// The model judged over the scope, after a fit there: misfit and price of the free parameters. An arc that touches a
/// plane may run on behind the plane unseen, as that of an undercut face does: the tie saves less than other
/// parameters.
double criterion(Model& model, const Scope& scope, int iterations);

/// Is the radius beyond the plane larger? At the ends of the part it is not.
bool isFoot(const Model& model, std::size_t run, bool start);

}  // namespace lathelier::features
