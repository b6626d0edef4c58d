// Wave vectors of chatter marks on an unrolled cylinder, and the inverse. y = R θ along the circumference as the cut
// proceeds, z along the axis in the direction of feed. The tool at time t is at θ = 2π n t, z = f n t; a vibration of
// f_c makes f_c / n = m + ν waves in a revolution, m whole, ν in (-½, ½]. Neighbouring tracks are f apart, so that the
// feed marks have the wave vector K_f = (-1/(πD), 1/f) and the chatter K_c = (m/(πD), ν/f), and every K_c + j K_f is an
// alias of it, as the surface is sampled once per feed:
//     f_c = n (πD k_y + f k_z)   for every j.
// ε = 2π (1 + ν) for ν < 0 is the phase of the regeneration: regenerative chatter has ε between π and 2π (J. Tlusty,
// "Manufacturing Processes and Equipment", ch. 9), about 3π/2 at the bottom of a lobe; ν about 0 or above is usual for
// a forced vibration (a whole number of waves in a revolution).
#pragma once

#include <optional>
#include <vector>

#include "engine/surface/grid.h"

namespace lathelier::surface {

/// Direction of cut along a track, in a picture rotated so that the feed points right.
enum class CutDirection { Unknown, Down, Up };

/// tan(helix) = f / (πD), in degrees.
double helixAngle_deg(double feed_mm_rev, double diameter_mm);

/// Waves of a vibration in a revolution: whole number and fraction.
struct Waves {
    int m = 0;
    double nu = 0;  ///< fraction in (-½, ½]
};
Waves wavesPerRevolution(double frequency_hz, double speed_rpm);

/// A measured wave vector, read as K_c + j K_f.
struct Reading {
    double nu = 0;                ///< in (-½, ½]
    std::optional<double> waves;  ///< measured m, not rounded; none: diameter in pixels unknown
};

/// `line` and `feed`: cycles per pixel; `feed` points in the direction of feed. `cut`: Down or Up.
Reading readingOf(Vector line, Vector feed, std::optional<double> feed_mm_rev, std::optional<double> diameter_mm,
                  std::optional<double> diameter_px, CutDirection cut);

/// Unit vector of the axis in the direction of feed, from the feed marks and their helix angle.
Vector axisDirection(Vector feed, std::optional<double> feed_mm_rev, std::optional<double> diameter_mm,
                     CutDirection cut);

double phase_deg(double nu);                                                       ///< ε, 0 to 360
double inclination_deg(double nu, int m, double diameter_mm, double feed_mm_rev);  ///< of the crests to the axis

}  // namespace lathelier::surface
