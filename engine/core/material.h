// A material, as structural dynamics and deflection need it.
#pragma once

#include <string>

#include "engine/core/fields.h"

namespace lathelier {

/// Isotropic, linearly elastic. Default: steel as the handbooks have it, to be marked assumed where nobody stated it.
struct Material {
    std::string name = "steel";
    double elastic_modulus_MPa = 210000;
    double poisson_ratio = 0.3;
    double density_kg_m3 = 7850;
    double loss_factor = 0.002;  ///< η of the complex modulus E (1 + iη)
    friend bool operator==(const Material&, const Material&) = default;
};

const std::vector<Field<Material>>& fieldsOf(const Material*);

}  // namespace lathelier
