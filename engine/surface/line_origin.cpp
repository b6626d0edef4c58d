#include "engine/surface/line_origin.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace lathelier::surface {
namespace {

constexpr LineOriginLimits limits;

/// Number of periods of a frequency along a unit vector across a picture.
double periodsAlong(Vector frequency, Vector along, int columns, int rows)
{
    return std::abs(dot(frequency, along)) * (std::abs(along.x) * columns + std::abs(along.y) * rows);
}

/// One of 3 × 3 parts.
Grid partOf(const Grid& picture, int across, int down)
{
    const int columns = picture.columns / 3, rows = picture.rows / 3;
    Grid part(columns, rows);
    for (int y = 0; y < rows; ++y)
        std::copy_n(std::next(picture.row(down * rows + y), static_cast<std::ptrdiff_t>(across) * columns), columns,
                    part.row(y));
    return part;
}

}  // namespace

bool isOfLight(const WindowedPicture& picture, Vector feed, Vector line)
{
    constexpr int harmonics = 12;
    const Vector along = (1 / length(feed)) * feed, across = turned(along, 90);
    for (int j = -harmonics; j <= harmonics; ++j) {
        const Vector off = line - double(j) * feed;
        const double z = periodsAlong(off, along, picture.columns(), picture.rows());
        const double y = periodsAlong(off, across, picture.columns(), picture.rows());
        if (std::hypot(z, y) < limits.modulation_bins && z < std::max(limits.unresolved_bins, limits.oblique * y))
            return true;
    }
    return false;
}

bool isShorterThanFeed(Vector feed, Vector line)
{
    return std::abs(dot(line, turned((1 / length(feed)) * feed, 90))) > length(feed);
}

bool isSecondFeed(const Grid& flat, Vector feed, Vector line)
{
    const Vector across = turned((1 / length(feed)) * feed, 90);
    if (periodsAlong(line, across, flat.columns, flat.rows) > limits.second_feed_bins) return false;
    double both = 0, feeds = 0, lines = 0;
    for (int i = 0; i < 9; ++i) {
        const WindowedPicture part(partOf(flat, i % 3, i / 3));
        const double a = part.amplitudeAt(feed), b = part.amplitudeAt(line);
        both += a * b;
        feeds += a * a;
        lines += b * b;
    }
    return both < limits.second_feed_overlap * std::sqrt(feeds * lines);
}

}  // namespace lathelier::surface
