#include "engine/surface/picture_comparison.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/surface/picture_kernel.h"
#include "engine/surface/surface_codes.h"

namespace lathelier::surface {
namespace {

constexpr int leastShared_px = 32;  // smallest side of the common area
constexpr int mostShared_px = 2048;

/// mm per pixel of the view, or file pixels per pixel of the view.
double scaleOf(const ImageMarks& image, bool in_mm)
{
    return image.view.px_per_px * (in_mm ? *image.mm_per_px : 1);
}

/// Direction of the feed in the view.
double direction_deg(const ImageMarks& image)
{
    return image.feed_marks ? angleModulo180(image.feed_marks->direction_deg - image.view.turned_deg) : 0;
}

/// Approximate width and height of the largest rectangle with the common aspect ratio inside a rotated view.
Vector shown(const ImageMarks& image, double scale)
{
    const double angle = std::abs(direction_deg(image)) * std::numbers::pi / 180;
    const double zoom = scaleOf(image, scale > 0) / (scale > 0 ? scale : 1);
    const double width = image.view.flat.columns * zoom, height = image.view.flat.rows * zoom;
    const double c = std::cos(angle), s = std::sin(angle);
    return {std::max(width * c - height * s, 0.5 * width), std::max(height * c - width * s, 0.5 * height)};
}

Grid brought(const ImageMarks& image, double scale, int columns, int rows, Vector shift)
{
    const double zoom = scaleOf(image, scale > 0) / (scale > 0 ? scale : 1);
    const double angle = -direction_deg(image) * std::numbers::pi / 180;
    const Grid& flat = image.view.flat;
    const double c = zoom * std::cos(angle), s = zoom * std::sin(angle);
    const double cx = 0.5 * (flat.columns - 1), cy = 0.5 * (flat.rows - 1);
    const AffineMap move{c, -s, 0.5 * (columns - 1) - c * cx + s * cy - shift.x,
                         s, c,  0.5 * (rows - 1) - s * cx - c * cy - shift.y};
    return pictureKernel().moved(flat, move, columns, rows, Interpolation::Linear);
}

/// Shift of the second picture relative to the first, with the response.
Vector shiftBetween(const Grid& first, const Grid& second, double& response)
{
    const Vector shift = pictureKernel().shift(first, second, response);
    response = std::isfinite(response) ? std::clamp(response, 0.0, 1.0) : 0;
    return shift;
}

}  // namespace

AlignedPictures aligned(const std::vector<ImageMarks>& images, Vector shift)
{
    AlignedPictures result;
    const bool in_mm = std::all_of(images.begin(), images.end(), [](const auto& image) { return image.mm_per_px; });
    if (in_mm)
        for (const ImageMarks& image : images) result.mm_per_px = std::max(result.mm_per_px, scaleOf(image, true));
    double width = mostShared_px, height = mostShared_px;
    for (const ImageMarks& image : images) {
        const Vector size = shown(image, result.mm_per_px);
        width = std::min(width, size.x);
        height = std::min(height, size.y);
    }
    const int columns = std::max(leastShared_px, static_cast<int>(width));
    const int rows = std::max(leastShared_px, static_cast<int>(height));
    for (std::size_t i = 0; i < images.size(); ++i)
        result.pictures.push_back(brought(images[i], result.mm_per_px, columns, rows, i == 1 ? shift : Vector{}));
    return result;
}

SurfaceComparison compared(const std::vector<ImageMarks>& images, Notes& notes)
{
    const AlignedPictures pictures = aligned(images);
    SurfaceComparison comparison;
    comparison.same_scale = pictures.mm_per_px > 0;
    const Vector shift = shiftBetween(pictures.pictures[0], pictures.pictures[1], comparison.registration_response);
    comparison.registered = comparison.registration_response > sameSurface;
    if (comparison.registered) comparison.shift = shift;
    for (const ImageMarks& image : images)
        comparison.relative_to_feed.push_back(image.chatter_marks ? std::optional(image.chatter_marks->relative_to_feed)
                                                                  : std::nullopt);
    notes.push_back({notes::sameLightingAssumed, {}});
    if (!comparison.registered)
        notes.push_back({notes::notRegistered, {{"response", comparison.registration_response}}});
    return comparison;
}

}  // namespace lathelier::surface
