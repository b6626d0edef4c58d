// What holds the work, what cuts it, and how the deflection is computed: SETUP.json as a struct.
// Units: mm, N, N·mm/rad, MPa. z from the free (tailstock) end toward the chuck.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/beam/beam_section.h"
#include "engine/core/fields.h"
#include "engine/core/material.h"
#include "engine/cutting/cutting_forces.h"

namespace lathelier::deflection {

/// A material to be cut: an elastic one, with the coefficients of a pair of it and an insert.
struct WorkMaterial {
    Material elastic;                      ///< E and ν are used
    cutting::CuttingCoefficients cutting;  ///< of material and insert
    friend bool operator==(const WorkMaterial&, const WorkMaterial&) = default;
};

/// A chuck or a tailstock: springs at an end of the work. Axial and torsional ones never couple to the diameter.
struct HoldingSprings {
    double radial_N_mm = 0;       ///< against deflection
    double axial_N_mm = 0;        ///< along z; has no influence
    double tilt_N_mm_rad = 0;     ///< against rotation about x or y
    double torsion_N_mm_rad = 0;  ///< about z; has no influence
    friend bool operator==(const HoldingSprings&, const HoldingSprings&) = default;
};

/// A rest that stands at one place.
struct SteadyRest {
    double z_mm = 0;         ///< from the free end
    double radial_N_mm = 0;  ///< stiffness
    friend bool operator==(const SteadyRest&, const SteadyRest&) = default;
};

/// A rest that moves with the tool.
struct FollowerRest {
    double offset_mm = 0;    ///< from the tool toward the chuck; negative: behind it, on the machined surface
    double radial_N_mm = 0;  ///< stiffness
    friend bool operator==(const FollowerRest&, const FollowerRest&) = default;
};

/// Tool, turret and slide, in series with the work.
struct ToolPost {
    double radial_N_mm = 0;      ///< against being pushed out of the work
    double tangential_N_mm = 0;  ///< against being pushed along the cutting speed
    friend bool operator==(const ToolPost&, const ToolPost&) = default;
};

/// Which depth and entering angle the forces of a sloping contour have. Both are the same on a cylinder.
enum class SlopeModel { Radial, Normal };

/// SETUP.json. Defaults of what has to be stated are those of no machine.
struct TurningSetup {
    std::string stock;                                             ///< path, relative to the file; may be empty
    double z_zero_mm = 0;                                          ///< z of the program's Z0: z = z_zero_mm - Z
    WorkMaterial material;                                         ///< of the work
    cutting::ToolGeometry tool;                                    ///< insert
    HoldingSprings chuck;                                          ///< at z = length
    std::optional<HoldingSprings> tailstock;                       ///< at z = 0; none: free end
    std::vector<SteadyRest> steady_rests;                          ///< any number
    std::optional<FollowerRest> follower_rest;                     ///< none: none
    std::optional<ToolPost> tool_post;                             ///< none: rigid
    cutting::ContactLength contact = cutting::ContactLength::Arc;  ///< of edge and chip
    bool feed_moment = false;                                      ///< M = -F_f (stock radius - depth/2)
    SlopeModel slope = SlopeModel::Radial;                         ///< of cones and arcs
    beam::ShearModel shear = beam::ShearModel::Cowper;             ///< the receptance takes the same to agree at 0 Hz
    double step_mm = 0.5;                                          ///< longest step along z
    friend bool operator==(const TurningSetup&, const TurningSetup&) = default;
};

const std::vector<Field<WorkMaterial>>& fieldsOf(const WorkMaterial*);
const std::vector<Field<HoldingSprings>>& fieldsOf(const HoldingSprings*);
const std::vector<Field<SteadyRest>>& fieldsOf(const SteadyRest*);
const std::vector<Field<FollowerRest>>& fieldsOf(const FollowerRest*);
const std::vector<Field<ToolPost>>& fieldsOf(const ToolPost*);
const std::vector<Field<TurningSetup>>& fieldsOf(const TurningSetup*);

}  // namespace lathelier::deflection
