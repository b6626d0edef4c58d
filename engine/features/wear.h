// Worn seats: what lies within the form tolerance of one element is one row.
#pragma once

#include <numbers>
#include <vector>

#include "engine/features/model.h"
#include "engine/features/recognition.h"
#include "engine/features/segmentation.h"

namespace lathelier::features {

/// A junction between neighbours that bend by less than this may be wear.
inline constexpr double kWearBend = 3.4 * std::numbers::pi / 180;

/// What a part of a worn seat was before it became one with its neighbours, and what it is now.
struct Wear {
    double from_mm = 0, to_mm = 0;  ///< along the axis
    Piece was, now;                 ///< over that stretch

    double at_mm(double z_mm) const;  ///< how much the wall lies outside its row
};

/// Takes the wear off the wall.
void takeOff(const std::vector<Wear>& worn, Wall& wall);

/// Pieces of a worn seat as one: neighbours that a cylinder or a cone describes within the form tolerance, without
/// bends and genuine steps between them. A step within the tolerance is genuine between pieces that are level as far as
/// their walls tell. What was taken away is added to `merged`, the shape that the row does not have to `worn`.
void mergeWear(std::vector<Piece>& pieces, const std::vector<Wall>& walls, double form_mm,
               std::vector<MergedJunction>& merged, std::vector<Wear>& worn);

/// The same with the elements of a settled model: what was taken away. Its walls lose their wear.
std::vector<MergedJunction> mergeWithinForm(Model& model, double form_mm);

}  // namespace lathelier::features
