// All sections of a record as one surface.
#pragma once

#include <memory>
#include <optional>

#include "engine/core/scan.h"
#include "engine/trajectory/trajectory.h"

namespace lathelier::trajectory {

/// The images of all sections as one closed surface around the axis, with magnified deviations, relative to the mean
/// LSC radius of all sections about the part's axis, the least-squares line through the centres of its sections, or
/// (with `form_only`) each section's own LSC circle. Without z, the part's axis is the mean centre.
struct StackedSections {
    std::shared_ptr<const Scan> scan;
    std::shared_ptr<const std::vector<float>> deviation_um;  ///< one for each vertex
    std::size_t angles = 0;                                  ///< vertices of a section
    double magnification = 1;
    double limit_um = 1;   ///< a readable limit of the colours
    double length_mm = 1;  ///< drawn length

    std::size_t sectionOf(std::size_t vertex) const { return vertex / angles; }
    double angle_deg(std::size_t vertex) const
    {
        return 360.0 * static_cast<double>(vertex % angles) / static_cast<double>(angles);
    }
    std::size_t vertexAt(std::size_t section, double angle_deg) const;
};

/// Null scan when there are fewer than two sections. Sections without z stand a diameter / 10 apart. `magnification`:
/// magnification of the deviations; default: 1000, or less if limited by the radius.
StackedSections stackedSections(const trajectory::TrajectoryResult& result, bool form_only,
                                std::optional<double> magnification = {});

}  // namespace lathelier::trajectory
