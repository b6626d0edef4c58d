// The spectrum of a flattened picture: exact values at any frequency, and the whole plane rotated so that the strongest
// ridge (the common direction of all grooves) lies on an axis. Source: Hann window; power spectra of textures: R. M.
// Haralick, "Statistical and structural approaches to texture", Proc. IEEE 67 (1979).
#pragma once

#include <complex>
#include <vector>

#include "engine/core/progress.h"
#include "engine/surface/grid.h"

namespace lathelier::surface {

/// Weights ½ - ½ cos(2π (i + ½) / count).
std::vector<double> hann(int count);

/// A flattened picture under a Hann window in both directions.
class WindowedPicture {
public:
    explicit WindowedPicture(const Grid& flat);

    const Grid& values() const { return windowed_; }
    int columns() const { return windowed_.columns; }
    int rows() const { return windowed_.rows; }
    double windowSum() const { return windowSum_; }

    /// Σ value exp(-2πi (f·place)) with f in cycles per pixel.
    std::complex<double> at(Vector frequency) const;

    /// The same at one fx and several fy.
    std::vector<std::complex<double>> at(double fx, const std::vector<double>& fy) const;

    /// Amplitude of a cosine of this frequency.
    double amplitudeAt(Vector frequency) const { return 2 * std::abs(at(frequency)) / windowSum_; }

    /// The frequency of the local maximum of |at()| near `start`: Newton on its logarithm over a grid of 3 × 3 points
    /// 0.35 bins apart. Stays within 1.5 bins of `start`.
    Vector refined(Vector start) const;

    /// Distance of two frequencies in bins (cycles across the picture).
    double binsBetween(Vector a, Vector b) const;

private:
    /// |at()| at all pairs of three fx and three fy.
    void around(Vector middle, double step_bins, double (&magnitude)[3][3]) const;

    Grid windowed_;
    double windowSum_ = 0;
};

/// |spectrum|² over the plane of frequencies, zero in the middle.
struct PowerSpectrum {
    Grid power;           ///< columns along fx, rows along fy, each from -N/2
    double turn_deg = 0;  ///< rotation applied to the picture before, from x toward y

    int zeroColumn() const { return power.columns / 2; }
    int zeroRow() const { return power.rows / 2; }
    /// The frequency of a bin in the unrotated picture, in cycles per pixel.
    Vector frequencyOf(int column, int row) const;
};

/// Direction of the ridge of largest mean power, 0 to 180° from fx toward fy, in steps of ¼°.
double ridgeDirection_deg(const PowerSpectrum& spectrum);

/// Spectrum of the picture rotated by `turn_deg`.
PowerSpectrum powerSpectrum(const WindowedPicture& picture, double turn_deg = 0);

/// The rotation in (-45, 45] that aligns a direction with the nearer axis.
double turnToAxis_deg(double direction_deg);

/// Medians of the power in rings about zero, by radius in units of the finer bin; never 0.
std::vector<double> ringMedians(const PowerSpectrum& spectrum);
std::size_t ringOf(const PowerSpectrum& spectrum, int column, int row);

}  // namespace lathelier::surface
