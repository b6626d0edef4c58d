// The verdict about the surface: every local mean, with its uncertainty, against the limits at its place.
// Sources: ISO 14253-1 (decision rules); Z. Šidák, JASA 62 (1967) (simultaneous intervals); P. R. Hansen, JBES 23
// (2005) 365-380 (inequalities that clearly hold are left out of the family).
#pragma once

#include <optional>
#include <vector>

#include "engine/registration/verdict/surface_windows.h"
#include "engine/registration/verdict/verdict_values.h"

namespace lathelier::registration {

/// Limits of the deviation at one place.
struct DeviationLimits {
    double lower_mm = 0;  ///< lower limit of the deviation
    double upper_mm = 0;  ///< upper limit of the deviation

    double half_mm() const { return (upper_mm - lower_mm) / 2; }
};

/// The limits along the axis: those of the zones, elsewhere the tolerance.
class LimitsAlong {
public:
    LimitsAlong(const std::optional<double>& tolerance_mm, const std::vector<ZoneLimits>& zones);

    /// Is there any limit?
    bool any() const;
    /// Limits at one place; none where nothing is judged.
    std::optional<DeviationLimits> at(double z_mm) const;
    /// The widest limits between two places; none where a part of it has no limits.
    std::optional<DeviationLimits> between(double z_start_mm, double z_end_mm) const;

private:
    std::optional<DeviationLimits> elsewhere_;
    std::vector<ZoneLimits> zones_;  ///< in order of z
};

/// A window's mean corrected for the sagitta of a coarse reference; absolute where the deviation has no sign.
double judgedMean_mm(const SurfaceWindows& all, const SurfaceWindow& window);

/// How far the interval mean_mm ± allowance_mm lies outside the limits; negative where it reaches into them.
double excess_mm(const SurfaceWindows& all, double mean_mm, double allowance_mm, const DeviationLimits& limits);

/// Combined verdict of the windows of one stretch of the axis, or of all.
struct WindowsVerdict {
    double judged_points = 0;     ///< of the smallest windows that have limits
    double undecided_points = 0;  ///< of these, in windows with too large an uncertainty
    double ambiguous_points = 0;  ///< of these, where the guarded rule gives neither pass nor fail
    double needed_mm = 0;         ///< largest half-width of the limits that the undecided ones would need
    double cell_mm = 0;           ///< size of the window with `needed_mm`
    bool fails = false;           ///< a window is out of its limits

    /// None where nothing has limits.
    std::optional<Verdict> verdict() const;
};

/// The verdict of all windows, of each given zone (by its z), and the worst place.
struct SurfaceVerdict {
    WindowsVerdict all;
    std::vector<WindowsVerdict> zones;  ///< of the windows within each of `zones`
    std::optional<WorstPlace> worst;    ///< none where nothing is judged
    /// Coverage factor for failing: that of the extreme of the windows that may be out of their limits. Windows that
    /// are within by the factor for all windows are left out of the family.
    double factor = 2;
};

SurfaceVerdict judgeWindows(const SurfaceWindows& all, const LimitsAlong& limits, DecisionRule rule,
                            const std::vector<Zone>& zones);

}  // namespace lathelier::registration
