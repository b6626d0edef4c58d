// Where planes across the axis are: shoulders by the likelihood of hits and misses of single rays, faces by the points
// on them, ends by the last hits.
#pragma once

#include <optional>
#include <vector>

#include "engine/features/model/model.h"
#include "engine/registration/revolution/shoulder_rays.h"

namespace lathelier::features {

/// A plane that was located.
struct PlanePlace {
    double z_mm = 0;      ///< along the axis
    double sigma_mm = 0;  ///< standard uncertainty
    double spot_mm = 0;   ///< width over which hits become misses; 0: not known
};

/// The place of an edge from its rays. P(hit | h) = clamp((h - z_e)/s + ½, 0.003, 0.997) is maximised over z_e and s.
/// Uncertainty: √(s/(6·density) + gap²/12 + (1 µm)²), gap the distance of the heights beside the edge. nullopt with
/// fewer than 10 hits or misses. Heights are those of the edge (z times its sign).
std::optional<PlanePlace> placeOf(const registration::EdgeRays& rays);

/// A face between two radii, when its point density is at least `least_per_mm2`.
std::optional<PlanePlace> seenFace(const MeridianCloud& cloud, double z_mm, double inner_mm, double outer_mm,
                                   double sigma_mm, double least_per_mm2);

/// An end of the hits.
struct EndPlace {
    PlanePlace place;               ///< of the part's end, if it is one
    double log_ratio = 0;           ///< ln of the evidence for the part's end to that for the end of the data; 0: none
    double from_mm = 0, to_mm = 0;  ///< interval in which the part's end lies, if it is one
};

/// The end of the hits on the wall of a run, where no rows tell it (end_rows.h): a Poisson process of constant density
/// that ends in a ramp of width `spot_mm`. Points within `loss_mm` of the edge may be missing: both ends lose alike, so
/// that U of the length holds the loss of both.
std::optional<EndPlace> endOf(const MeridianCloud& cloud, const Model& model, const Run& run, bool start,
                              double loss_mm);

}  // namespace lathelier::features
