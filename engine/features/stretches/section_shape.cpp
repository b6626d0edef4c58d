#include "engine/features/stretches/section_shape.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/core/units.h"
#include "engine/features/stretches/stretch_limits.h"

namespace lathelier::features {

Eigen::Vector2d StretchPoints::across_mm(std::size_t i) const
{
    return r_mm[i] * Eigen::Vector2d(std::cos(turn_rad * turn[i]), std::sin(turn_rad * turn[i]));
}

double StretchPoints::onShape_mm() const
{
    return stretchProof.on_sigmas * sigma_mm + stretchProof.on_mm;
}

double StretchPoints::largestRms_mm() const
{
    return stretchProof.rms_sigmas * sigma_mm + stretchProof.rms_mm;
}

double SectionShape::pitchPhase(double turn, double z_mm) const
{
    const double place = static_cast<double>(count) * (turn - phase_turn) - waves_per_mm * z_mm;
    return place - std::floor(place);
}

double SectionShape::faceAngle(double turn) const
{
    const double phase = pitchPhase(turn, 0);
    return turn_rad / static_cast<double>(count) * (phase < 0.5 ? phase : phase - 1);
}

double SectionShape::radiusAt_mm(double turn, double z_mm) const
{
    if (kind == MarkKind::Eccentric) {
        const Eigen::Vector2d ray(std::cos(turn_rad * turn), std::sin(turn_rad * turn));
        const double along = centre_mm.dot(ray), square = level_mm * level_mm - centre_mm.squaredNorm() + along * along;
        return square >= 0 ? along + std::sqrt(square) : std::numeric_limits<double>::quiet_NaN();
    }
    if (pitch_mm.empty()) return std::min(level_mm, face_mm / std::cos(faceAngle(turn)));
    const auto bin = static_cast<std::size_t>(pitchPhase(turn, z_mm) * static_cast<double>(pitch_mm.size()));
    return pitch_mm[std::min(bin, pitch_mm.size() - 1)];
}

double markAngle_deg(double turn)
{
    return 360 * (turn - std::floor(turn));
}

}  // namespace lathelier::features
