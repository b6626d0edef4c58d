// Where a stretch that is not round begins and ends along the axis.
//
// Of the points within a stretch nearly all lie on its shape, of those beyond fewer: the end is the change of that
// share, by maximum likelihood. A chamfer cuts crests and corners first: the line through them tells where it begins.
// Gaps of teeth and faces of a prism that go on in it belong to the mark, up to where it leaves nothing of them.
#pragma once

#include "engine/features/stretches/not_round.h"

namespace lathelier::features {

/// Places `from_mm`, `to_mm` and the ends of the mark. Before, from and to are those of sections.
void placeStretchEnds(const MeridianCloud& cloud, double sigma_mm, NotRoundStretch& stretch);

/// Does the shape lie so far below the round that stands for it that noise does not hide it? False on flanks.
bool isBelowRound(const SectionShape& shape, double radius_mm, double sigma_mm);

}  // namespace lathelier::features
