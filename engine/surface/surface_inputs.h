// Validated inputs of the evaluation of photographs: values per picture, scale, camera.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "engine/core/core_codes.h"
#include "engine/surface/surface.h"

namespace lathelier::surface {

/// Projection of the cylinder.
struct Unrolling {
    bool wanted = true;                 ///< false: the picture is not unrolled
    std::optional<double> distance_mm;  ///< of the camera from the axis; none: parallel projection
};

/// Error valueNotUnderstood.
Unrolling unrollingOf(const SurfaceParameters& parameters);

/// The scale that is given, in mm per pixel of the file; that of a file or from the feed is found later. Errors
/// valueNotUnderstood (two scales, no feed for a scale from it).
std::pair<std::optional<double>, ScaleSource> givenScale(const SurfaceParameters& parameters);

/// Errors of parameter combinations.
void checkTogether(const SurfaceParameters& parameters, std::size_t pictures);

/// The pixels of a region; null: all. Error regionOutside.
GridView regionOf(const io::Image& image, const Region* region);

/// A list with one value for each picture, or one for all; null: empty. Error valueNotUnderstood.
template <class T>
const T* ofPicture(const std::vector<T>& list, std::size_t index, std::size_t pictures, const char* parameter)
{
    if (list.empty()) return nullptr;
    if (list.size() != 1 && list.size() != pictures)
        throw Error(errors::valueNotUnderstood,
                    {{"parameter", std::string(parameter)},
                     {"found", static_cast<std::int64_t>(list.size())},
                     {"expected", LT_TEXT("Engine", "one for all pictures, or one for each")}});
    return &list[list.size() == 1 ? 0 : index];
}

}  // namespace lathelier::surface
