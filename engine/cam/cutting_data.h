// Power, roughness and materials for turning.
//
// O. Kienzle: F_c = k_c1.1 b h^(1 - m_c), h = f sin κ, b = a_p / sin κ; P_c = F_c v_c / 60 000 in kW. The numbers are
// good for ± 25 %. Ideal roughness of a nose: Rz = r - √(r² - f²/4); where f > 2 r sin κ' the straight back edge trims
// the cusp. Real steel, wear and chatter only add to it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/core/fields.h"
#include "engine/core/library.h"

namespace lathelier::cam {

/// What Kienzle's equation needs of a work material.
struct WorkMaterial {
    std::string name;        ///< as drawings state it, "C45"
    double k_c11_N_mm2 = 0;  ///< specific cutting force at a chip of 1 by 1 mm
    double m_c = 0;          ///< exponent of the thickness
    std::string standing;    ///< "given" or "assumed"
    friend bool operator==(const WorkMaterial&, const WorkMaterial&) = default;
};

const std::vector<Field<WorkMaterial>>& fieldsOf(const WorkMaterial*);

/// The library that is built in.
const std::vector<LibraryEntry<WorkMaterial>>& workMaterials();
/// By name or key, ignoring case and hyphens; null: not found.
const LibraryEntry<WorkMaterial>* workMaterial(const std::string& name);

/// P_c in kW; κ in degrees.
double cuttingPower(const WorkMaterial& material, double depth_mm, double feed_mm_rev, double entering_angle_deg,
                    double cutting_speed_m_min);

/// Ideal Rz in µm. `back_angle_deg`: κ' of the insert, without margin; 90: no straight back edge. NaN where f ≥ 2 r and
/// no straight back edge trims the cusp.
double idealRz_um(double feed_mm_rev, double corner_radius_mm, double back_angle_deg = 90);

/// The largest feed up to `most_mm_rev` whose ideal Rz is no more than `Rz_um`.
double feedForRz(double Rz_um, double corner_radius_mm, double back_angle_deg, double most_mm_rev);

}  // namespace lathelier::cam
