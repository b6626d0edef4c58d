// Image operations that the module lathelier-opencv does with OpenCV, on grids of brightness.
#pragma once

#include <array>
#include <vector>

#include "engine/core/progress.h"
#include "engine/surface/grid.h"

namespace lathelier::surface {

/// From a pixel of a picture to one of another: x' = xx x + xy y + x0, y' = yx x + yy y + y0.
struct AffineMap {
    double xx = 1, xy = 0, x0 = 0;
    double yx = 0, yy = 1, y0 = 0;
};

enum class Interpolation { Linear, Cubic };

struct PictureKernel {
    /// Means over the areas of the new pixels.
    Grid (*resized)(const GridView& picture, int columns, int rows);
    /// See flattened() in preparation.h.
    Grid (*flattened)(const Grid& picture, const Progress& progress);
    /// `columns` × `rows` pixels taken at `places` of the picture (Lanczos, 8 × 8), its border repeated beyond it.
    Grid (*remapped)(const Grid& picture, const std::vector<std::array<float, 2>>& places, int columns, int rows);
    /// The picture moved by `map`, 0 beyond it.
    Grid (*moved)(const Grid& picture, const AffineMap& map, int columns, int rows, Interpolation interpolation);
    /// The smallest size of at least `least` that a Fourier transform is fast for.
    int (*fast_size)(int least);
    /// Squared modulus of the discrete Fourier transform, frequency 0 in the middle (columns / 2, rows / 2).
    Grid (*power)(const Grid& picture);
    /// Where the second lies against the first, by phase correlation; its response 0…1, or not a number.
    Vector (*shift)(const Grid& first, const Grid& second, double& response);
    /// Gaussian blur in place, the border mirrored.
    void (*blur)(Grid& picture, double sigma_px);
};

const PictureKernel& pictureKernel();

}  // namespace lathelier::surface
