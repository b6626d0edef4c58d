// The rim of a round hole or of a slot in a wall, by maximum likelihood from where points of the wall are and are not.
//
// Where the rays of a scanner are known, each one either hit the wall outside the rim or passed it inside; where only
// points are known (surfaces scanned from all sides), they are a Poisson process of one density outside. Between lies
// a blur of the rim, along z and across by its own width, that is estimated too. The result is the mean over the
// posterior, sampled by Metropolis' rule with random numbers by counter: a straight rim between two columns of rays is
// as likely anywhere between them, and U says so.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "engine/core/progress.h"

namespace lathelier::features {

/// A ray at the wall, about the middle of the mark. `across_mm` is r·sin(θ - θ₀): the place in the section of a hole or
/// slot whose middle plane holds the axis. On a face both are coordinates in its plane.
struct RimRay {
    double z_mm = 0, across_mm = 0;
    bool on_wall = true;
};

/// What is seen about a mark.
struct RimView {
    std::vector<RimRay> rays;            ///< of the wall, and where `has_misses` those that passed it
    bool has_misses = false;             ///< rays are known, else points only
    double from_mm = -1e9, to_mm = 1e9;  ///< the wall along z
    double radius_mm = 0;                ///< of the wall; 0: a plane
    double inner_mm = 0, outer_mm = 0;   ///< of a plane: radii of the ring that is judged, about the origin

    /// Is the wall judged there?
    bool holds(double z_mm, double across_mm) const
    {
        const double r = outer_mm > 0 ? std::hypot(z_mm, across_mm) : 0;
        return z_mm > from_mm && z_mm < to_mm && r >= inner_mm && (outer_mm <= 0 || r <= outer_mm);
    }
};

enum class RimKind : std::uint8_t { Circle, Slot };

/// The rim in the section of the mark: a circle, or a slot with round or straight ends.
struct RimShape {
    RimKind kind = RimKind::Circle;
    double low_mm = 0, high_mm = 0;             ///< across
    double start_mm = 0, end_mm = 0;            ///< along z, of the tips
    bool round_start = true, round_end = true;  ///< of a slot
    double blur_z_mm = 0.1, blur_mm = 0.1;      ///< scale of the logistic blur along z and across

    double width_mm() const { return high_mm - low_mm; }
    double middle_mm() const { return (low_mm + high_mm) / 2; }
};

/// A circle.
RimShape circleRim(double z_mm, double across_mm, double radius_mm);

/// Distance of a place from the rim, < 0 inside, and the blur there.
struct RimDistance {
    double distance_mm = 0, blur_mm = 0.1;
};
RimDistance distanceFrom(const RimShape& rim, double z_mm, double across_mm);

/// Area within the rim grown by `grown_mm`, on the developed wall.
double areaWithin_mm2(const RimShape& rim, const RimView& view, double grown_mm);

struct RimFit {
    RimShape rim;                ///< mean
    double width_sigma_mm = 0;   ///< standard uncertainty of the width or diameter
    double middle_sigma_mm = 0;  ///< across
    double start_sigma_mm = 0, end_sigma_mm = 0;
    double log_likelihood = 0;  ///< of the best rim
};

/// The rim about `first`, which must be right to about 1 mm. Throws Cancelled.
RimFit fitRim(const RimView& view, const RimShape& first, const Progress& progress = {});

/// The most likely rim.
RimShape bestRim(const RimView& view, const RimShape& first, const Progress& progress = {});

/// Logarithm of the likelihood of a rim, up to a constant of the rays about `about`: for the comparison of rims.
double logLikelihood(const RimView& view, const RimShape& about, const RimShape& rim);

}  // namespace lathelier::features
