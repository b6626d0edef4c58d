// STEP (ISO 10303-21) of a shaft: one solid, its closed meridian revolved about z.
//
// Lines become planes, cylinders and cones, arcs tori and spheres (an arc with its centre beyond the axis is a general
// surface of revolution). The free end lies in z = 0, the axis is +z, lengths are mm. Marks are left out (cad_notes.h).
#pragma once

#include <optional>
#include <string>

#include "engine/core/progress.h"
#include "engine/shaft/shaft.h"

namespace lathelier::cad {

enum class StepSchema {
    AP214,  ///< AUTOMOTIVE_DESIGN, ISO 10303-214
    AP242   ///< AP242_MANAGED_MODEL_BASED_3D_ENGINEERING, ISO 10303-242
};

struct StepOptions {
    StepSchema schema = StepSchema::AP214;  ///< application protocol named in the file
    std::string name;                       ///< of the product; empty: the shaft's, else "shaft"
    std::string description;                ///< of the product; empty: "material: …" where that is stated
    std::string author;                     ///< may be empty
    std::string organisation;               ///< may be empty
    std::optional<std::string> time_stamp;  ///< ISO 8601, or empty: not stated; none: now, in UTC
};

/// The file. The solid is checked before: valid, and its volume that of volume_mm3() to 1e-9. With a given time stamp
/// the same shaft gives the same bytes. Texts may be any UTF-8. Errors: those of checkShaft(); markNotTurned,
/// solidNotBuilt, solidVolumeWrong. Throws Cancelled. About 20 ms.
std::string stepText(const Shaft& shaft, const StepOptions& options, const Progress& progress = {});

/// A text as ISO 10303-21 writes it between quotes: quotes and backslashes doubled, other letters, and quotes
/// before anything but a letter or digit, as \X2\…\X0\ and
/// \X4\…\X0\. Invalid UTF-8 becomes "?".
std::string stepString(std::string_view utf8);

}  // namespace lathelier::cad
