#include "engine/surface/chatter_geometry.h"

#include <cmath>
#include <numbers>

namespace lathelier::surface {
namespace {

using std::numbers::pi;

}  // namespace

double helixAngle_deg(double feed_mm_rev, double diameter_mm)
{
    return std::atan(feed_mm_rev / (pi * diameter_mm)) * 180 / pi;
}

Waves wavesPerRevolution(double frequency_hz, double speed_rpm)
{
    const double waves = frequency_hz / (speed_rpm / 60);
    const double m = std::ceil(waves - 0.5);  // ν = ½ is assigned to the smaller m
    return {static_cast<int>(m), waves - m};
}

Vector axisDirection(Vector feed, std::optional<double> feed_mm_rev, std::optional<double> diameter_mm,
                     CutDirection cut)
{
    const Vector along = (1 / length(feed)) * feed;
    if (!feed_mm_rev || !diameter_mm) return along;
    return turned(along, (cut == CutDirection::Up ? -1 : 1) * helixAngle_deg(*feed_mm_rev, *diameter_mm));
}

Reading readingOf(Vector line, Vector feed, std::optional<double> feed_mm_rev, std::optional<double> diameter_mm,
                  std::optional<double> diameter_px, CutDirection cut)
{
    const Vector z = axisDirection(feed, feed_mm_rev, diameter_mm, cut);
    const Vector y = turned(z, cut == CutDirection::Up ? -90 : 90);
    const double feeds = dot(line, z) / dot(feed, z);  // f k_z: ν + j
    Reading reading;
    const double order = std::ceil(feeds - 0.5);
    reading.nu = feeds - order;
    if (!diameter_px) return reading;
    const double around = pi * *diameter_px * dot(line, y);  // m - j
    reading.waves = around + order;
    if (around + feeds >= 0) return reading;
    reading.nu = reading.nu == 0.5 ? 0.5 : -reading.nu;  // k and -k describe the same wave
    reading.waves = -*reading.waves - (reading.nu == 0.5 ? 1 : 0);
    return reading;
}

double phase_deg(double nu)
{
    return 360 * (nu < 0 ? 1 + nu : nu);
}

double inclination_deg(double nu, int m, double diameter_mm, double feed_mm_rev)
{
    return std::atan(nu * pi * diameter_mm / (feed_mm_rev * m)) * 180 / pi;
}

}  // namespace lathelier::surface
