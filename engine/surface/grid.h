// Brightness on a grid of pixels, passed between the steps of the evaluation.
#pragma once

#include <cstddef>
#include <vector>

namespace lathelier::surface {

/// Row-major from the top left: x to the right, y down.
struct Grid {
    int columns = 0;  ///< width in pixels
    int rows = 0;     ///< height in pixels
    std::vector<float> values;

    Grid() = default;
    Grid(int width, int height)
        : columns(width), rows(height), values(static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
    {
    }
    const float* row(int y) const { return values.data() + index(0, y); }
    float* row(int y) { return values.data() + index(0, y); }
    float at(int x, int y) const { return values[index(x, y)]; }

private:
    std::size_t index(int x, int y) const
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(x);
    }
};

/// Non-owning view of a grid or a part of a picture.
struct GridView {
    const float* first = nullptr;  ///< upper left pixel
    int columns = 0;               ///< width in pixels
    int rows = 0;                  ///< height in pixels
    std::ptrdiff_t stride = 0;     ///< distance of rows, in values

    GridView() = default;
    GridView(const float* values, int width, int height, std::ptrdiff_t step)
        : first(values), columns(width), rows(height), stride(step)
    {
    }
    GridView(const Grid& grid) : GridView(grid.values.data(), grid.columns, grid.rows, grid.columns) {}
    const float* row(int y) const { return first + y * stride; }

    /// The middle of it, at most `side` pixels either way.
    GridView middle(int side) const;
    Grid copy() const;
};

/// A point or a spatial frequency of a picture, in pixels or cycles per pixel: x to the right, y down.
struct Vector {
    double x = 0;  ///< to the right
    double y = 0;  ///< down

    friend Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y}; }
    friend Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y}; }
    friend Vector operator*(double s, Vector v) { return {s * v.x, s * v.y}; }
    friend double dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y; }
};

double length(Vector v);
double angle_deg(Vector v);              ///< from x toward y
Vector turned(Vector v, double by_deg);  ///< from x toward y
double angleModulo180(double degrees);   ///< in (-90, 90]

}  // namespace lathelier::surface
