// The verdict about the surface: every local mean, with its uncertainty, against the limits at its place.
// Sources: ISO 14253-1 (decision rules); Z. Šidák, JASA 62 (1967) (the worst of many); P. R. Hansen, JBES 23 (2005)
// 365-380 (inequalities that surely hold do not count among the many).
#pragma once

#include <optional>
#include <vector>

#include "engine/registration/verdict/surface_windows.h"
#include "engine/registration/verdict/verdict_values.h"

namespace lathelier::registration {

/// Limits of the deviation at one place.
struct DeviationLimits {
    double lower_mm = 0;  ///< smallest deviation allowed
    double upper_mm = 0;  ///< largest deviation allowed

    double half_mm() const { return (upper_mm - lower_mm) / 2; }
};

/// The limits along the axis: those of the zones, elsewhere the tolerance.
class LimitsAlong {
public:
    LimitsAlong(const std::optional<double>& tolerance_mm, const std::vector<ZoneLimits>& zones);

    /// Are there any limits at all?
    bool any() const;
    /// Those at one place; none where nothing is judged.
    std::optional<DeviationLimits> at(double z_mm) const;
    /// The wider ones of what lies between two places; none where some of it is not judged.
    std::optional<DeviationLimits> between(double z_start_mm, double z_end_mm) const;

private:
    std::optional<DeviationLimits> elsewhere_;
    std::vector<ZoneLimits> zones_;  ///< in order of z
};

/// A window's mean without what a coarse reference's facets amount to, the sign dropped where it says nothing.
double judgedMean_mm(const SurfaceWindows& all, const SurfaceWindow& window);

/// How far `mean` is surely outside the limits, when `allowance` is what it may be off; negative within them.
double excess_mm(const SurfaceWindows& all, double mean_mm, double allowance_mm, const DeviationLimits& limits);

/// What the windows of one stretch of the axis, or of all, say together.
struct WindowsVerdict {
    double judged_points = 0;     ///< of the smallest windows that have limits
    double undecided_points = 0;  ///< of them, where no window is sure enough
    double unsure_points = 0;     ///< of them, where the guarded rule neither passes nor fails
    double needed_mm = 0;         ///< half-width that the unsure ones would need, at most
    double cell_mm = 0;           ///< size of the window that needs it
    bool fails = false;           ///< a window is out of its limits

    /// None where nothing has limits.
    std::optional<Verdict> verdict() const;
};

/// The verdict of all windows, of each given zone (by its z), and the worst place.
struct SurfaceVerdict {
    WindowsVerdict all;
    std::vector<WindowsVerdict> zones;  ///< of the windows within each of `zones`
    std::optional<WorstPlace> worst;    ///< none where nothing is judged
    /// What a window has to be out of its limits by, in standard uncertainties, to fail: the allowance for the worst of
    /// those that may be out. Windows that are surely within, by the allowance for the worst of all, cannot be it.
    double factor = 2;
};

SurfaceVerdict judgeWindows(const SurfaceWindows& all, const LimitsAlong& limits, DecisionRule rule,
                            const std::vector<Zone>& zones);

}  // namespace lathelier::registration
