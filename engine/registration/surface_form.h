// The form of the deviation without the scanner's noise: means over pieces of surface that grow until they are sure.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/core/progress.h"
#include "engine/core/scan.h"
#include "engine/registration/compare.h"

namespace lathelier::registration {

/// Of a place that no window is near to.
inline constexpr std::uint32_t kNoWindow = SurfaceWindow::kNone;
/// A mean is sure when its standard uncertainty is at most this share of the limit of the colour scale: a quarter of a
/// step of contours, of which there are kContourSteps (compare_plots.h) to each side.
inline constexpr double kSureShareOfScale = 0.04;

/// For each point (vertex) of the copy the place in result.windows->windows of the smallest window around it; kNoWindow
/// for points that do not count, and for those further than 1 mm outside every window: faces across the axis, places
/// without points. result.windows has to be there. The same bits for any number of threads. Throws Cancelled.
std::vector<std::uint32_t> windowsOfPoints(const Scan& copy, const CompareResult& result,
                                           const Progress& progress = {});

/// The same for the cells of the unrolled map, row-major, z slow. result.unrolled has to be there.
std::vector<std::uint32_t> windowsOfMap(const CompareResult& result, const Progress& progress = {});

/// The mean over the smallest window about each place whose standard uncertainty is at most `sure_mm`, or over a
/// smaller one from which the next larger differs by more than 4 standard uncertainties: form, which a larger window
/// would hide. NaN where the data carry neither. Source of the rule: O. V. Lepskii, Theory of Probability and its
/// Applications 35 (1990); A. Goldenshluger, A. Nemirovski, Mathematical Methods of Statistics 6 (1997).
std::vector<float> meansOf(const SurfaceWindows& all, const std::vector<std::uint32_t>& places, double sure_mm);

/// The same at one place, kNoWindow included.
float meanOf(const SurfaceWindows& all, std::uint32_t place, double sure_mm);

/// What a colour scale has to reach to show the form: `share` of the local means lie within it, and they are sure to
/// kSureShareOfScale of it. 0 without windows.
double formReach_mm(const SurfaceWindows& all, double share);

}  // namespace lathelier::registration
