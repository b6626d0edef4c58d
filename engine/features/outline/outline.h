// One outline of the part, the outside or a bore: from its walls to a fitted model.
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "engine/core/progress.h"
#include "engine/features/model/model_fit.h"
#include "engine/features/outline/edges.h"
#include "engine/features/recognition.h"
#include "engine/registration/revolution/revolution_axis.h"
#include "engine/registration/revolution/scanner_axis.h"

namespace lathelier::features {

/// A stretch along the axis whose points were left out of the data.
struct Cut {
    double z_start_mm = 0, z_end_mm = 0;  ///< in the frame of the fit
    double reach_mm = 0;                  ///< data that end this near to either limit end because of it

    bool isAtLimit(double z_mm) const
    {
        return std::abs(z_mm - z_start_mm) < reach_mm || std::abs(z_mm - z_end_mm) < reach_mm;
    }
    bool contains(double z_mm) const { return z_mm > z_start_mm && z_mm < z_end_mm; }
    /// Is all of it between two walls, but for their bins?
    bool liesBetween(double before_mm, double behind_mm, double bin_mm) const
    {
        return z_start_mm > before_mm - bin_mm && z_end_mm < behind_mm + bin_mm;
    }
};

/// Input of fitOutline().
struct OutlineInput {
    const std::vector<Eigen::Vector3d>& points_mm;  ///< in the frame of the scan
    const registration::RevolutionFit& fit;         ///< in whose frame all the rest is
    const MeridianCloud& cloud;                     ///< of the same points
    const Walls& coarse;                            ///< for the cutting
    const Walls& fine;                              ///< for the fit
    std::optional<registration::ScannerAxis> scanner;
    double form_mm = 0.02;
    bool bore = false;                  ///< outline of a bore, else of the outside
    std::vector<Plane> part_ends = {};  ///< of the outside: a bore that comes near one ends there
    std::vector<Cut> cuts = {};         ///< no edge of the part is where one begins or ends
};

/// A stretch that is too rough for its elements: one cylinder over its crests.
struct RoughZone {
    double z_start_mm = 0, z_end_mm = 0;  ///< from the free end
    double eccentric_mm = 0;              ///< eccentricity of a round that explains the scatter; 0: none does
};

struct Outline {
    Model model;                         ///< fitted
    JointFit fit;                        ///< of all parameters
    std::vector<Gap> gaps;               ///< in the frame of the fit
    std::vector<RoughZone> rough;        ///< threads and knurls
    std::vector<MergedJunction> merged;  ///< within the form tolerance
    std::optional<EndPlace> ends[2];     ///< at the first and the last plane; nullopt: not estimated
    bool face_seen[2] = {false, false};
    std::optional<double> balls[2];       ///< ends closed by their ball: diameter about the axis that is not seen
    bool end_stated[2] = {false, false};  ///< the end lies where a person stated it
    std::vector<double> unsure_edges_mm;  ///< shoulders that hits and misses of rays do not place
    std::vector<Cut> cuts;                ///< as OutlineInput::cuts
    bool surface_scan = false;            ///< most faces are seen: not the rays of a rotary scanner
};

/// Fits the outline; nothing when there is no chain of that side.
std::optional<Outline> fitOutline(const OutlineInput& input, const Progress& progress = {});

}  // namespace lathelier::features
