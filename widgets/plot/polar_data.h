// Closed profiles around a base circle, ready to be drawn: thinned traces, and the way from angle and deviation to a
// place on the screen.
#pragma once

#include <QCoreApplication>
#include <QPointF>
#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "engine/report/chart.h"

namespace lathelier::plot {

/// The words of polar plots.
struct PolarWords {
    Q_DECLARE_TR_FUNCTIONS(lathelier::plot::PolarWords)
};

/// A trace as it is drawn: for each tenth of a degree at most the first, lowest, highest and last sample.
struct PolarLine {
    std::vector<double> angle_deg;     ///< NaN: the line breaks
    std::vector<double> deviation_um;  ///< from the base circle
    bool closed = false;               ///< its last point is joined to the first
};

/// A plot with what its view draws of it. Made in the worker, because it looks at every sample.
struct PolarPicture {
    report::PolarPlot plot;
    std::vector<PolarLine> lines;  ///< one for each trace
    double lowest_um = 0;          ///< of all that is drawn
    double highest_um = 0;
    std::size_t silent = 0;  ///< so many traces at the end are drawn, but not read at the pointer

    std::size_t spoken() const { return plot.traces.size() - std::min(silent, plot.traces.size()); }
};

using PolarPicturePtr = std::shared_ptr<const PolarPicture>;

PolarPicturePtr polarPicture(report::PolarPlot plot, std::size_t silent = 0);

/// Deviation of a circle that lies off the centre, seen from the base circle's centre at this angle; exact, so that it
/// is right at every magnification (where it looks like a limaçon). NaN where the ray misses it.
double deviationAt(const report::PolarPlot::ReferenceLine& circle, double base_radius_mm, double angle_deg);

/// The sample of a trace that is nearest to an angle; nullopt when it has none within 5°.
std::optional<std::size_t> nearestSample(const report::PolarPlot::Trace& trace, double angle_deg);

/// How large deviations are drawn.
class PolarScale {
public:
    /// `share_per_um`: what one micrometre is of the drawn radius of the base circle.
    PolarScale(double share_per_um, const PolarPicture& picture, const QPointF& centre, double room_px);

    QPointF at(double angle_deg, double deviation_um) const;
    double angleOf(const QPointF& place) const;  ///< degrees, 0…360
    double base_px() const { return base_px_; }
    double pixelsPerUm() const { return base_px_ * share_; }
    QPointF centre() const { return centre_; }
    double room_px() const { return room_px_; }

private:
    double share_;
    QPointF centre_;
    double room_px_;
    double base_px_;
};

/// The largest magnification of 1, 2, 5 × 10^n whose drawing keeps a clear middle and something of the base circle. A
/// plot that has no base radius
/// (error motion) counts as if it had one of 1 mm.
double fittingMagnification(const PolarPicture& picture);

/// The next larger or smaller one of 1, 2, 5 × 10^n.
double steppedMagnification(double magnification, int steps);

/// In µm; 1, 2 or 5 × 10^n of the unit that is shown (µm × factor), so that divisions lie at least `smallest_px` apart.
double division_um(const PolarScale& scale, double smallest_px, double factor = 1);

/// One line for each sample: trace, angle, deviation; then the reference circles degree by degree and the contacts, all
/// as deviations from the base circle. Decimal point in every locale.
QString toCsv(const report::PolarPlot& plot);

}  // namespace lathelier::plot
