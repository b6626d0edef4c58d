// What the panel "Surface" is asked: how the pictures were taken and cut, or which picture is to be made.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/surface/surface.h"
#include "engine/surface/synthetic.h"

namespace lathelier::surface_panel {

inline constexpr const char* beforeRole = "before";
inline constexpr const char* afterRole = "after";
inline constexpr const char* makeKey = "make_picture";
inline constexpr const char* madePrefix = "made.";  ///< of the keys of SurfaceQuestion::made

/// A picture that shows what marks of chatter look like.
surface::SyntheticParameters demonstration();

struct SurfaceQuestion {
    surface::SurfaceParameters surface;                   ///< but for the speeds
    std::optional<double> speed_before_rpm;               ///< of the first picture's cut
    std::optional<double> speed_after_rpm;                ///< of the second one's; none: as the first
    bool make_picture = false;                            ///< a picture is made in place of the files
    surface::SyntheticParameters made = demonstration();  ///< how
};

const std::vector<Field<SurfaceQuestion>>& fieldsOf(const SurfaceQuestion*);

/// Is a picture made, rather than taken from files?
bool makesPicture(const Values& parameters);

/// For the evaluation of so many pictures. Of a picture that is made, the cut is that of the picture.
surface::SurfaceParameters parametersOf(const SurfaceQuestion& question, std::size_t pictures);

/// The picture that is made: with room for the whole width of the part where that is asked.
surface::SyntheticParameters pictureOf(const SurfaceQuestion& question);

}  // namespace lathelier::surface_panel
