// Worn seats: what lies within the form tolerance of one element is one row.
#pragma once

#include <vector>

#include "engine/features/model.h"
#include "engine/features/recognition.h"
#include "engine/features/segmentation.h"

namespace lathelier::features {

/// A junction between neighbours that bend by less than this may be wear.
inline constexpr double kWearBend = 3.4 * 3.14159265358979323846 / 180;

/// Pieces of a worn seat as one: neighbours that a cylinder or a cone describes within the form tolerance, without
/// bends and genuine steps between them. A step within the tolerance is genuine between pieces that are level as far as
/// their walls tell. What was taken away is added to `merged`.
void mergeWear(std::vector<Piece>& pieces, const std::vector<Wall>& walls, double form_mm,
               std::vector<MergedJunction>& merged);

/// The same with the elements of a settled model: what was taken away.
std::vector<MergedJunction> mergeWithinForm(Model& model, double form_mm);

}  // namespace lathelier::features
