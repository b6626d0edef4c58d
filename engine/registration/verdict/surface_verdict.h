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

/// The verdict of one mean with its expanded uncertainty by lathelier::judge(). A mean whose uncertainty exceeds the
/// half-width of the limits is not judged: it is undecided unless it is surely out.
Verdict judgeMean(const SurfaceWindows& all, double mean_mm, double expanded_uncertainty_mm,
                  const DeviationLimits& limits, DecisionRule rule);

/// Size of the defects that a scan has to show for a pass, by the guarded rule and by the others; and the largest that
/// is looked for as a defect. Sides of squares of the same area: discs of 2.5, 4 and 9 mm.
inline constexpr double leastDefect_mm = 2.2;
inline constexpr double plainDefect_mm = 3.5;
inline constexpr double largestDefect_mm = 8;

/// Combined verdict of the windows of one stretch of the axis, or of all.
struct WindowsVerdict {
    bool fails = false;   ///< a window is out of its limits
    bool unsure = false;  ///< the rule gives neither pass nor fail for a window
    /// Of each of the smallest windows that have limits: size of the smallest window about it whose expanded
    /// uncertainty is within the half-width of the limits; infinite where there is none up to largestDefect_mm.
    std::vector<float> resolved_mm;
    double needed_mm = 0;  ///< largest half-width of the limits that the unresolved places would need
    double cell_mm = 0;    ///< size of the window with `needed_mm`

    /// Size from which on a defect as high as its limits is seen on all of the surface but rims and small corners.
    double defect_mm() const;
    /// None where nothing has limits.
    std::optional<Verdict> verdict(DecisionRule rule) const;
};

/// The verdict of all windows, of each given zone (by its z), and the worst place.
///
/// A window's expanded uncertainty U is its standard uncertainty times a coverage factor for the extreme of many: that
/// of all windows; for means beyond their limits that of the windows that may be out of them. A window is not judged
/// when its standard uncertainty is more than half the half-width of its limits. Of the others
/// - one with mean - U beyond the limit fails by every rule;
/// - one with its mean beyond the limit by less is undecided; by the simple rule it fails where U is within the
///   half-width of the limits. It does not count where a wider window about the place is within the limit and the
///   two differ by no more than noise: the smallest of thousands of windows exceed any limit;
/// - by the guarded rule every place has to have mean + U within the limit in the smallest window of sufficient
///   uncertainty about it, and a defect of leastDefect_mm has to be seen everywhere;
/// - by the others a defect of plainDefect_mm has to be seen everywhere.
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
