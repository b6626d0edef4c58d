// The form of the deviation without the scanner's noise: local means over windows enlarged until their standard
// uncertainty is small against the colour scale.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/core/progress.h"
#include "engine/core/scan.h"
#include "engine/registration/compare.h"

namespace lathelier::registration {

/// Index of a place without a window nearby.
inline constexpr std::uint32_t noWindow = SurfaceWindow::noWiderWindow;
/// Largest standard uncertainty of a shown mean as a share of the limit of the colour scale: a quarter of a contour
/// step, of which there are contourSteps (report/colours.h) to each side.
inline constexpr double uncertaintyShareOfScale = 0.04;

/// For each point (vertex) of the copy the place in result.windows->windows of the smallest window around it; noWindow
/// for points that do not count, and for those further than 1 mm outside every window: faces across the axis, places
/// without points. result.windows has to be there. The same bits for any number of threads. Throws Cancelled.
std::vector<std::uint32_t> windowsOfPoints(const Scan& copy, const CompareResult& result,
                                           const Progress& progress = {});

/// The same for the cells of the unrolled map, row-major, z slow. result.unrolled has to be there.
std::vector<std::uint32_t> windowsOfMap(const CompareResult& result, const Progress& progress = {});

/// Which windows may colour a place: the nearest of all, or of the sides only, or of the faces across the axis only.
enum class WindowsOn { All, Sides, Faces };

/// The same for places on the reference's surface, in its frame. result.windows has to be there.
std::vector<std::uint32_t> windowsOfPlaces(std::span<const Eigen::Vector3d> places_mm, const CompareResult& result,
                                           WindowsOn on, const Progress& progress = {});

/// The mean over the smallest window about each place whose standard uncertainty is at most `sigma_limit_mm`, or over a
/// smaller one from which the next larger differs by more than 4 standard uncertainties: form, which a larger window
/// would average out. NaN where neither exists. Source of the rule: O. V. Lepskii, Theory of Probability and its
/// Applications 35 (1990); A. Goldenshluger, A. Nemirovski, Mathematical Methods of Statistics 6 (1997).
std::vector<float> meansOf(const SurfaceWindows& all, const std::vector<std::uint32_t>& places, double sigma_limit_mm);

/// The same at one place, noWindow included.
float meanOf(const SurfaceWindows& all, std::uint32_t place, double sigma_limit_mm);

/// Limit of a colour scale for the form: `share` of the local means lie within it, and their standard uncertainty is at
/// most uncertaintyShareOfScale of it. 0 without windows.
double formLimit_mm(const SurfaceWindows& all, double share);

}  // namespace lathelier::registration
