// Significance S of a spectral line: its power over the local noise level. For exponentially distributed noise power
// the probability that any of M independent bins exceeds T is about M exp(-T). Source: N. L. Johnson, S. Kotz, N.
// Balakrishnan, "Continuous Univariate Distributions" 1: the mean of the logarithm of an exponential variable is ln μ -
// γ, its median μ ln 2. The level follows the rows and columns of the spectrum, as random grooves concentrate in a
// narrow ridge along an axis: with an isotropic level every ground surface would appear periodic.
#pragma once

#include <vector>

#include "engine/core/progress.h"
#include "engine/surface/grid.h"
#include "engine/surface/spectrum.h"

namespace lathelier::surface {

/// A local maximum of the spectrum.
struct SpectralPeak {
    Vector frequency{};       ///< in the picture, cycles per pixel
    double power = 0;         ///< |spectrum|²
    double significance = 0;  ///< power over the local level of the noise
};

/// Estimator of the noise level.
enum class NoiseLevel {
    Means,   ///< test for any periodicity: the largest of the log-means of a square ring and of rows and columns, raw
             ///< and without the common slope of the spectrum
    Medians  ///< test for further lines: medians of rows and columns, which are robust against a comb
};

/// S of one bin.
class Significance {
public:
    explicit Significance(const PowerSpectrum& spectrum);

    double levelAt(int column, int row, NoiseLevel level) const;

    /// All local maxima with S > `least` of at least four periods across the picture, largest first; of each pair at
    /// ±f the one with fx > 0. `largest`: the largest S of all.
    std::vector<SpectralPeak> peaks(NoiseLevel level, double least, double* largest = nullptr,
                                    const Progress& progress = {}) const;

    /// S at a frequency of the picture: the largest power within a bin of it.
    double at(Vector frequency, NoiseLevel level) const;

    /// The level of the noise at a frequency of the picture.
    double levelAt(Vector frequency, NoiseLevel level) const;

    /// The typical level of the noise at the radius of a frequency.
    double typicalLevel(double cycles_per_px) const;

private:
    double logMean(int column, int row, int across, int down, int hole, bool whitened) const;
    double median(int column, int row, int across, int down) const;
    double meansLevel(int column, int row, double give_up) const;
    double mediansLevel(int column, int row, double give_up) const;
    int foldedColumn(int column) const;
    int foldedRow(int row) const;
    bool binOf(Vector frequency, int& column, int& row) const;

    const PowerSpectrum& spectrum_;
    Grid logPower_;
    std::vector<double> logRing_;  ///< logarithms of the ring medians
    Grid logRingAt_;               ///< of the ring of each bin
};

/// T = ln(M / α), M half the pixels: false-detection probability α for the whole picture.
double significanceThreshold(double pixels, double alpha);

}  // namespace lathelier::surface
