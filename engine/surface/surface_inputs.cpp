#include "engine/surface/surface_inputs.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "engine/surface/surface_codes.h"

namespace lathelier::surface {
namespace {

[[noreturn]] void refuseValue(const char* parameter, Value found, Text expected)
{
    throw Error(errors::valueNotUnderstood,
                {{"parameter", std::string(parameter)}, {"found", std::move(found)}, {"expected", expected}});
}

std::optional<double> positive(std::string_view typed)
{
    double number = 0;
    const auto [stop, problem] = std::from_chars(typed.data(), typed.data() + typed.size(), number);
    if (problem != std::errc() || stop != typed.data() + typed.size() || !std::isfinite(number) || number <= 0)
        return std::nullopt;
    return number;
}

}  // namespace

Unrolling unrollingOf(const SurfaceParameters& p)
{
    if (p.unroll == "auto" || p.unroll == "far") return {};
    if (p.unroll == "no") return {false, {}};
    const auto distance = positive(p.unroll);
    if (!distance || (p.diameter_mm && *distance <= 0.5 * *p.diameter_mm))
        refuseValue(
            "unroll", p.unroll,
            LT_TEXT("Engine", "auto, no, far, or the camera's distance from the axis in mm, beyond the surface"));
    return {true, distance};
}

std::pair<std::optional<double>, ScaleSource> givenScale(const SurfaceParameters& p)
{
    const int given = (p.mm_per_px ? 1 : 0) + (p.scale_px_mm.empty() ? 0 : 1) + (p.scale_from_feed ? 1 : 0) +
                      (p.scale_from_file ? 1 : 0);
    if (given > 1) refuseValue("mm_per_px", Value(), LT_TEXT("Engine", "one scale only"));
    if (p.scale_from_feed && !p.feed_mm_rev)
        refuseValue("scale_from_feed", Value(true), LT_TEXT("Engine", "a feed beside it"));
    if (p.scale_from_feed) return {std::nullopt, ScaleSource::Feed};
    if (p.scale_from_file) return {std::nullopt, ScaleSource::File};
    if (p.mm_per_px) return {p.mm_per_px, ScaleSource::Given};
    if (p.scale_px_mm.empty()) return {std::nullopt, ScaleSource::None};
    const std::size_t colon = std::min(p.scale_px_mm.find(':'), p.scale_px_mm.size());
    const auto px = positive(std::string_view(p.scale_px_mm).substr(0, colon));
    const auto mm = positive(std::string_view(p.scale_px_mm).substr(std::min(colon + 1, p.scale_px_mm.size())));
    if (!px || !mm) refuseValue("scale_px_mm", p.scale_px_mm, LT_TEXT("Engine", "PX:MM, such as 250:1"));
    return {*mm / *px, ScaleSource::ScaleBar};
}

void checkTogether(const SurfaceParameters& p, std::size_t pictures)
{
    givenScale(p);
    unrollingOf(p);
    ofPicture(p.speed_rpm, 0, pictures, "speed_rpm");
    ofPicture(p.roi, 0, pictures, "roi");
}

GridView regionOf(const io::Image& image, const Region* roi)
{
    if (!roi) return {image.grey.data(), image.width, image.height, image.width};
    const bool inside = roi->x >= 0 && roi->y >= 0 && roi->width >= 1 && roi->height >= 1 &&
                        roi->x + roi->width <= image.width && roi->y + roi->height <= image.height;
    if (!inside)
        throw Error(errors::regionOutside, {{"found", std::vector<double>{roi->x, roi->y, roi->width, roi->height}},
                                            {"width", std::int64_t{image.width}},
                                            {"height", std::int64_t{image.height}}});
    const auto left = static_cast<std::size_t>(roi->x), top = static_cast<std::size_t>(roi->y);
    return {image.grey.data() + top * static_cast<std::size_t>(image.width) + left, static_cast<int>(roi->width),
            static_cast<int>(roi->height), image.width};
}

}  // namespace lathelier::surface
