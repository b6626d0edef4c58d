// Pictures with known truth for the tests of the room.
#pragma once

#include "engine/surface/surface.h"
#include "engine/surface/synthetic.h"

namespace lathelier::surface::test {

/// A field of 4.3 × 3.2 mm as under a microscope.
inline SyntheticParameters smallField(int seed)
{
    SyntheticParameters p;
    p.seed = seed;
    p.feed_direction_deg = 3.2;
    p.irregular = 0.05;
    return p;
}

/// The whole width of the part.
inline SyntheticParameters overview(int seed)
{
    SyntheticParameters p;
    p.seed = seed;
    p.feed_mm_rev = 0.2;
    p.nose_radius_mm = 0.8;
    p.mm_per_px = 0.03;
    p.width = 640;
    p.height = 880;
    p.cylinder = true;
    p.irregular = 0.05;
    return p;
}

/// Prior knowledge of such a picture, including directions.
inline SurfaceParameters known(const SyntheticParameters& truth)
{
    SurfaceParameters p;
    p.feed_mm_rev = truth.feed_mm_rev;
    p.diameter_mm = truth.diameter_mm;
    p.speed_rpm = {{truth.speed_rpm}};
    p.mm_per_px = truth.mm_per_px;
    p.feed_direction_deg = truth.feed_direction_deg;
    p.cut_direction = truth.cut;
    return p;
}

inline ImageMarks marksOf(const io::Image& image, const SurfaceParameters& parameters)
{
    return findSurfaceMarks({{"picture", image}}, parameters).images.front();
}

inline double theoreticalDepth_um(const SyntheticParameters& p)
{
    return 1000 * p.feed_mm_rev * p.feed_mm_rev / (8 * p.nose_radius_mm);
}

}  // namespace lathelier::surface::test
