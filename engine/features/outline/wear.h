// Worn seats: pieces within the form tolerance of one element become one row.
#pragma once

#include <vector>

#include "engine/features/model/model.h"
#include "engine/features/recognition.h"
#include "engine/features/walls/segmentation.h"

namespace lathelier::features {

/// A part of a worn seat: its piece before merging and the merged one.
struct Wear {
    double from_mm = 0, to_mm = 0;  ///< along the axis
    Piece was, now;                 ///< over that stretch

    double at_mm(double z_mm) const;  ///< how much the wall lies outside its row
};

/// Subtracts the wear from the wall.
void subtractWear(const std::vector<Wear>& worn, Wall& wall);

/// Pieces of a worn seat as one: neighbours that a cylinder or a cone describes within the form tolerance, without
/// bends and steps of the part between them. A step within the tolerance is one of the part between pieces whose slopes
/// are not significant. Removed junctions are appended to `merged`, the form deviation of the seat to `worn`.
void mergeWear(std::vector<Piece>& pieces, const std::vector<Wall>& walls, double form_mm,
               std::vector<MergedJunction>& merged, std::vector<Wear>& worn);

/// The same for the elements of a fitted model; returns the removed junctions. The wear is subtracted from its walls.
std::vector<MergedJunction> mergeWithinForm(Model& model, double form_mm);

}  // namespace lathelier::features
