// Clamping, tool and numerical parameters of the deflection: SETUP.json as a struct. Units: mm, N, N·mm/rad, MPa. z
// from the free (tailstock) end toward the chuck.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/beam/beam_section.h"
#include "engine/core/fields.h"
#include "engine/core/material.h"
#include "engine/cutting/cutting_forces.h"

namespace lathelier::deflection {

/// Workpiece material: elastic constants, and the cutting coefficients of the pair of material and insert.
struct WorkMaterial {
    Material elastic;                      ///< E and ν are used
    cutting::CuttingCoefficients cutting;  ///< of material and insert
    friend bool operator==(const WorkMaterial&, const WorkMaterial&) = default;
};

/// A chuck or a tailstock: springs at an end of the work. Axial and torsional ones do not affect the diameter.
struct HoldingSprings {
    double radial_N_mm = 0;       ///< against deflection
    double axial_N_mm = 0;        ///< along z; has no influence
    double tilt_N_mm_rad = 0;     ///< against rotation about x or y
    double torsion_N_mm_rad = 0;  ///< about z; has no influence
    friend bool operator==(const HoldingSprings&, const HoldingSprings&) = default;
};

/// A rest at a fixed position.
struct SteadyRest {
    double z_mm = 0;  ///< from the free end
    double radial_N_mm = 0;
    friend bool operator==(const SteadyRest&, const SteadyRest&) = default;
};

/// A rest that moves with the tool.
struct FollowerRest {
    double offset_mm = 0;  ///< from the tool toward the chuck; negative: on the machined surface behind it
    double radial_N_mm = 0;
    friend bool operator==(const FollowerRest&, const FollowerRest&) = default;
};

/// Tool, turret and slide, in series with the workpiece.
struct ToolPost {
    double radial_N_mm = 0;      ///< away from the workpiece axis
    double tangential_N_mm = 0;  ///< along the cutting speed
    friend bool operator==(const ToolPost&, const ToolPost&) = default;
};

/// Depth and entering angle used for the forces on a sloping contour. Identical on a cylinder.
enum class SlopeModel { Radial, Normal };

/// The tool of a set-up. Its corner radius and entering angle have to be stated; the rest is for the check against
/// stock.
struct SetupTool : Tool {
    SetupTool() = default;
    SetupTool(const Tool& tool) : Tool(tool) {}
    friend bool operator==(const SetupTool&, const SetupTool&) = default;
};

/// SETUP.json. Required values have no meaningful default.
struct TurningSetup {
    std::string stock;     ///< path, relative to the file; may be empty
    double z_zero_mm = 0;  ///< z of the program's Z0: z = z_zero_mm - Z
    WorkMaterial material;
    SetupTool tool;
    HoldingSprings chuck;                     ///< at z = length
    std::optional<HoldingSprings> tailstock;  ///< at z = 0; none: free end
    std::vector<SteadyRest> steady_rests;
    std::optional<FollowerRest> follower_rest;
    std::optional<ToolPost> tool_post;                             ///< none: rigid
    cutting::ContactLength contact = cutting::ContactLength::Arc;  ///< contact length of edge and chip
    bool feed_moment = false;                                      ///< M = -F_f (stock radius - depth/2)
    SlopeModel slope = SlopeModel::Radial;                         ///< for cones and arcs
    beam::ShearModel shear = beam::ShearModel::Cowper;  ///< must equal that of the receptance for agreement at 0 Hz
    double step_mm = 0.5;                               ///< longest step along z
    friend bool operator==(const TurningSetup&, const TurningSetup&) = default;
};

const std::vector<Field<WorkMaterial>>& fieldsOf(const WorkMaterial*);
const std::vector<Field<HoldingSprings>>& fieldsOf(const HoldingSprings*);
const std::vector<Field<SteadyRest>>& fieldsOf(const SteadyRest*);
const std::vector<Field<FollowerRest>>& fieldsOf(const FollowerRest*);
const std::vector<Field<ToolPost>>& fieldsOf(const ToolPost*);
const std::vector<Field<SetupTool>>& fieldsOf(const SetupTool*);
const std::vector<Field<TurningSetup>>& fieldsOf(const TurningSetup*);

}  // namespace lathelier::deflection
