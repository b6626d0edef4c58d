// Kind of each small piece of the meridian by Schwarz's criterion: cylinder, cone or arc with its ties.
#pragma once

#include "engine/core/progress.h"
#include "engine/features/model/model.h"
#include "engine/features/walls/segmentation.h"

namespace lathelier::features {

/// Does the slope of the line differ from 0 by more than chance explains?
bool isSignificantSlope(const Piece& piece);

/// Elements of a run from the pieces of its chain.
std::vector<Element> elementsOf(const std::vector<Piece>& pieces, std::span<const Wall> walls, double form_mm);

/// An arc over the chord from (z0, r0) to (z1, r1), without ties.
Element arcOverChord(double z0, double r0, double z1, double r1, double radius_mm, bool convex);

/// Ties that an arc in place of element k may have at one of its ends.
std::vector<Tie> possibleTies(const Model& model, const Run& run, std::size_t k, bool start);

/// For every arc and every cone shorter than 4 mm: the best of cylinder, cone, arcs with all ties that are possible;
/// misfit plus 2.5 ln n for each parameter. One sweep over all runs. Returns the number of changed elements.
int selectKinds(Model& model, const Progress& progress = {});

/// Tries a fillet, or at planes a chamfer or round too, at every sharp corner. Returns the number inserted.
int tryCorners(Model& model, const Progress& progress = {});

/// Drops elements shorter than the blur and merges lines that bend by less than 3.4°, while the misfit grows
/// by no more than their price. Returns the number removed.
int simplify(Model& model, const Progress& progress = {});

}  // namespace lathelier::features
