// Image operations of the module lathelier-opencv with OpenCV, on grids of brightness.
#pragma once

#include <array>
#include <vector>

#include "engine/core/progress.h"
#include "engine/surface/grid.h"

namespace lathelier::surface {

/// Affine map between pixels of two pictures: x' = xx x + xy y + x0, y' = yx x + yy y + y0.
struct AffineMap {
    double xx = 1, xy = 0, x0 = 0;
    double yx = 0, yy = 1, y0 = 0;
};

enum class Interpolation { Linear, Cubic };

struct PictureKernel {
    /// Resizes by means over the areas of the new pixels.
    Grid (*resized)(const GridView& picture, int columns, int rows);
    /// See flattened() in preparation.h.
    Grid (*flattened)(const Grid& picture, const Progress& progress);
    /// `columns` × `rows` pixels sampled at `places` of the picture (Lanczos, 8 × 8), with replicated border.
    Grid (*remapped)(const Grid& picture, const std::vector<std::array<float, 2>>& places, int columns, int rows);
    /// The picture transformed by `map`, 0 outside.
    Grid (*moved)(const Grid& picture, const AffineMap& map, int columns, int rows, Interpolation interpolation);
    /// The smallest size ≥ `least` with a fast Fourier transform.
    int (*fast_size)(int least);
    /// Squared modulus of the discrete Fourier transform, frequency 0 in the middle (columns / 2, rows / 2).
    Grid (*power)(const Grid& picture);
    /// Shift of the second relative to the first by phase correlation; response 0…1, or NaN.
    Vector (*shift)(const Grid& first, const Grid& second, double& response);
    /// Gaussian blur in place, with mirrored border.
    void (*blur)(Grid& picture, double sigma_px);
};

const PictureKernel& pictureKernel();

}  // namespace lathelier::surface
