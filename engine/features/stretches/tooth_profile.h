// The radius folded over the pitch of teeth, about the circle or along a helix.
#pragma once

#include <optional>

#include "engine/features/stretches/section_shape.h"

namespace lathelier::features {

/// Share of the variance of the radius that a profile folded over the pitch of a shape explains.
double explainedBy(const StretchPoints& points, const SectionShape& shape);

/// Median and scatter of the radius over one pitch.
struct PitchProfile {
    std::vector<double> radius_mm, scatter_mm;

    std::size_t size() const { return radius_mm.size(); }
    std::size_t binOf(const SectionShape& shape, double turn, double z_mm) const;
};

/// None where a part of the pitch is not seen.
std::optional<PitchProfile> pitchProfile(const StretchPoints& points, const SectionShape& shape);

/// Levels of a profile, from the medians of its bins.
struct ToothLevels {
    double root_mm = 0, crest_mm = 0;

    double depth_mm() const { return crest_mm - root_mm; }
    double middle_mm() const { return (crest_mm + root_mm) / 2; }
};

ToothLevels levelsOf(const PitchProfile& profile);

bool isOneTooth(const PitchProfile& profile, const ToothLevels& levels);  ///< and not several a pitch

/// Middle of the tooth within a pitch, 0…1.
double toothMiddle(const PitchProfile& profile, const ToothLevels& levels);

/// Radii over a pitch, NaN on flanks: where the points of a bin scatter, or its neighbours differ.
std::vector<double> steadyRadii(const PitchProfile& profile, double sigma_mm);

}  // namespace lathelier::features
