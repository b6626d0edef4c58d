// A material, as structural dynamics and deflection need it.
#pragma once

#include <string>

#include "engine/core/fields.h"

namespace lathelier {

/// Isotropic, linearly elastic. Default: steel with handbook values, to be marked as assumed unless stated.
struct Material {
    std::string name = "steel";           ///< for people
    double elastic_modulus_MPa = 210000;  ///< Young's modulus E
    double poisson_ratio = 0.3;           ///< ν, lateral contraction over extension
    double density_kg_m3 = 7850;          ///< mass density ρ
    double loss_factor = 0.002;           ///< η of the complex modulus E (1 + iη)
    friend bool operator==(const Material&, const Material&) = default;
};

const std::vector<Field<Material>>& fieldsOf(const Material*);

}  // namespace lathelier
