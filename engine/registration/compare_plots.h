// The pictures of a comparison: map, curves along the axis, histogram.
#pragma once

#include <span>
#include <vector>

#include "engine/registration/compare.h"
#include "engine/report/document.h"

namespace lathelier::registration {

/// Whether zones have limits of their own: pass and fail are then shown as shares of the limits at each place.
bool showsShares(const CompareParameters& parameters);

/// Scale of these shares.
inline constexpr double shareLimit_percent = 200;

/// Deviations at places along the axis as shares of the limits there: -100 at the lower, +100 at the upper limit; NaN
/// where there is no limit. `z_mm` as SurfaceWindows::z_mm, one for each deviation.
std::vector<float> sharesOfLimits_percent(const CompareParameters& parameters, std::span<const float> deviation_mm,
                                          std::span<const float> z_mm);

/// Deviations over length and angle, as local means of sufficient certainty (surface_form.h): with the tolerance band
/// in green (or the shares of each place's limits), or plain, which shows the form of the error also within the band.
/// result.unrolled has to be there.
/// `form_mm`: localMeansOfMap(result), where they are known already.
report::ColourMap unrolledMap(const CompareResult& result, bool with_tolerance, std::span<const float> form_mm = {});

/// Values of the map's cells, row-major, z slow; NaN: no colour. result.unrolled has to be there.
std::vector<float> localMeansOfMap(const CompareResult& result, const Progress& progress = {});

/// Mean deviation along the axis with its scatter and the tolerance. result.meridian has to be there.
report::Plot deviationAlongAxis(const CompareResult& result, const Language& language = {});

/// Half section of the original and of the copy, whose deviation is drawn `factor` times larger (default:
/// magnification()), with excess and missing material shaded, the limits at each place and the zones left out.
/// result.meridian has to be there. The curves are excess, missing, original, copy, then the limits.
report::Plot magnifiedMeridian(const CompareResult& result, const Language& language = {},
                               std::optional<double> factor = {});

/// How many times larger the deviation is drawn: 1, 2 or 5 × 10^n, at least 1.
double magnification(const CompareResult& result);

/// Histogram with the normal curve of the same mean and scatter, at least from -limit_mm to limit_mm (default:
/// colourLimit_mm()). With a tolerance the bars are coloured by it, and its two limits are the handles "lower" and
/// "upper". Where zones have limits of their own: of the shares of each point's limits.
report::Plot histogramPlot(const CompareResult& result, const Language& language = {},
                           std::optional<double> limit_mm = {});

/// The limit of the colour scale: a round number, with most local means and the tolerance band within it.
double colourLimit_mm(const CompareResult& result, bool with_tolerance = true);

/// Standard uncertainty up to which a local mean has a colour: small against the scale without tolerance.
double colourSigmaLimit_mm(const CompareResult& result);

}  // namespace lathelier::registration
