#include "engine/core/material.h"

namespace lathelier {

const std::vector<Field<Material>>& fieldsOf(const Material*)
{
    static const auto all = described<Material>(
        field("name", &Material::name, Label{LT_TEXT("Engine", "Material"), LT_TEXT("Engine", "Its name.")}),
        field("elastic_modulus_MPa", &Material::elastic_modulus_MPa, {1, 1e7},
              Label{LT_TEXT("Engine", "Elastic modulus"), LT_TEXT("Engine", "Young's modulus E."),
                    LT_TEXT("Engine", "MPa")}),
        field("poisson_ratio", &Material::poisson_ratio, {0, 0.5},
              Label{LT_TEXT("Engine", "Poisson's ratio"), LT_TEXT("Engine", "Lateral by axial strain.")}),
        field("density_kg_m3", &Material::density_kg_m3, {1, 1e5},
              Label{LT_TEXT("Engine", "Density"), LT_TEXT("Engine", "Mass by volume."), LT_TEXT("Engine", "kg/m³")}),
        field("loss_factor", &Material::loss_factor, {0, 1},
              Label{LT_TEXT("Engine", "Loss factor"),
                    LT_TEXT("Engine", "Structural damping: the modulus is E (1 + iη).")}));
    return all;
}

}  // namespace lathelier
