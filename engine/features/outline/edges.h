// Where planes across the axis are: shoulders by the likelihood of hits and misses of single rays, faces by the points
// on them, ends by the last hits.
#pragma once

#include <optional>
#include <vector>

#include "engine/features/model/model.h"
#include "engine/registration/revolution/scanner_axis.h"
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

/// A face between two radii, when its point density is at least a third of that of the walls.
std::optional<PlanePlace> seenFace(const MeridianCloud& cloud, double z_mm, double inner_mm, double outer_mm,
                                   double sigma_mm, double walls_per_mm2);

/// End of the hits on a wall: a Poisson process of constant density that ends in a ramp of width `spot_mm`.
struct EndPlace {
    PlanePlace place;
    double tilt_share = 0;  ///< of the tilt of the scanner's rows that the end follows: 0 the part's, 1 the data's
    double tilt_share_sigma = 1e9;  ///< its standard uncertainty; large where there is no tilt
};
std::optional<EndPlace> endOf(const MeridianCloud& cloud, const Model& model, const Run& run, bool start,
                              const std::optional<registration::ScannerAxis>& scanner);

}  // namespace lathelier::features
