// Reading measured profiles: x and y, or angle and radius, of one section.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "engine/core/profile.h"
#include "engine/core/progress.h"
#include "engine/io/import.h"

namespace lathelier::io {

enum class ProfileColumns { Auto, Xy, AngleRadius };

/// Reading options of profiles, besides ImportOptions. The unit of an angle is the degree unless the heading says rad.
struct ProfileOptions {
    ProfileColumns columns = ProfileColumns::Auto;  ///< quantities in the table; Auto: by its headings, else by its
                                                    ///< values
    std::optional<double> nominal_radius_mm;        ///< required when the file contains only deviations from a circle
};

const std::vector<Field<ProfileOptions>>& fieldsOf(const ProfileOptions*);

struct ProfileFile {
    Profile profile;  ///< the points, in mm
    FileFacts facts;  ///< format "profile_xy" | "profile_polar" | "roundness_trace"; details: "points",
                      ///< "columns_read" ("x,y", "y,z", "angle,r", "r"), "column_names" (theirs in the
                      ///< file), "nominal_radius_mm"
    Values header;    ///< the key=value lines above the table, as written
    Notes notes;      ///< codes: see readProfile()
};

/// Reads CSV and text tables of x,y or angle,radius in mm, µm or inch, and traces of roundness instruments that hold
/// one deviation a line (uniform angles over one turn). Encodings, delimiters, decimal marks, units and malformed files
/// are handled as in readScan(). Columns: by their names; without names x,y unless the first one covers one revolution.
/// Three coordinates of which one is nearly constant lie in a coordinate plane (note profilePlane). Values at or below
/// zero, or below 0.1 mm or 5 % of the nominal radius, are deviations; the file's own `nominal_radius_mm`, `D_mm`… is
/// used when no radius is given. Their unit is never guessed. The columns read are named (note columnsRead). Errors as
/// readScan(), and nominalRadiusMissing (deviations only, no radius given), columnsUnknown, columnsAmbiguous.
ProfileFile readProfile(const std::string& path, const ImportOptions& options = {}, const ProfileOptions& profile = {},
                        const Progress& progress = {});

/// The same from memory; `name` replaces the path in messages.
ProfileFile readProfile(const std::string& name, std::string_view bytes, const ImportOptions& options,
                        const ProfileOptions& profile, const Progress& progress = {});

/// True for a table that can only be a profile (for `inspect`): x and y without z, angle and r or deviations, or no
/// more than two columns of numbers. Three coordinates are a cloud.
bool isProfileTable(std::string_view bytes, const ImportOptions& options = {},
                    ProfileColumns columns = ProfileColumns::Auto);

}  // namespace lathelier::io
