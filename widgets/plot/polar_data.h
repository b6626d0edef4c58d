// Closed profiles around a base circle, prepared for drawing: decimated traces, and the mapping from angle and
// deviation to the screen.
#pragma once

#include <QCoreApplication>
#include <QPointF>
#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "engine/report/chart.h"

namespace lathelier::plot {

/// Texts of polar plots.
struct PolarWords {
    Q_DECLARE_TR_FUNCTIONS(lathelier::plot::PolarWords)
};

/// A trace decimated for drawing: for each tenth of a degree at most the first, lowest, highest and last sample.
struct PolarLine {
    std::vector<double> angle_deg;     ///< NaN: the line breaks
    std::vector<double> deviation_um;  ///< from the base circle
    bool closed = false;               ///< the last point is connected to the first
};

/// A polar plot with its decimated traces. Made in the worker, since every sample is processed.
struct PolarPicture {
    report::PolarPlot plot;
    std::vector<PolarLine> lines;  ///< one for each trace
    double lowest_um = 0;          ///< smallest deviation of the plot
    double highest_um = 0;
    std::size_t without_readout = 0;  ///< number of traces at the end without pointer readout

    std::size_t readoutTraces() const { return plot.traces.size() - std::min(without_readout, plot.traces.size()); }
};

using PolarPicturePtr = std::shared_ptr<const PolarPicture>;

PolarPicturePtr polarPicture(report::PolarPlot plot, std::size_t withoutReadout = 0);

/// Deviation of a circle that lies off the centre, seen from the base circle's centre at this angle; exact, so that it
/// is right at every magnification (where it looks like a limaçon). NaN where the ray misses it.
double deviationAt(const report::PolarPlot::ReferenceLine& circle, double base_radius_mm, double angle_deg);

/// The sample of a trace that is nearest to an angle; nullopt when it has none within 5°.
std::optional<std::size_t> nearestSample(const report::PolarPlot::Trace& trace, double angle_deg);

/// Scale of the drawn deviations.
class PolarScale {
public:
    /// `share_per_um`: one micrometre relative to the drawn radius of the base circle.
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

/// The largest magnification of 1, 2, 5 × 10^n that keeps the centre free and the base circle visible. A plot that has
/// no base radius (error motion) is treated as having one of 1 mm.
double fittingMagnification(const PolarPicture& picture);

/// The next larger or smaller one of 1, 2, 5 × 10^n.
double steppedMagnification(double magnification, int steps);

/// In µm; 1, 2 or 5 × 10^n of the display unit (µm × factor), so that divisions are at least `smallest_px` apart.
double division_um(const PolarScale& scale, double smallest_px, double factor = 1);

/// One line for each sample: trace, angle, deviation; then the reference circles degree by degree and the contacts, all
/// as deviations from the base circle. Decimal point in every locale.
QString toCsv(const report::PolarPlot& plot);

}  // namespace lathelier::plot
