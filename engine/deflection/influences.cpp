#include "engine/deflection/influences.h"

namespace lathelier::deflection {

const std::vector<InfluenceName>& influences()
{
    static const std::vector<InfluenceName> all{
        {Influence::Tailstock, "tailstock", LT_TEXT("Engine", "Stiffness of the tailstock")},
        {Influence::ChuckRadial, "chuck_radial", LT_TEXT("Engine", "Radial stiffness of the chuck")},
        {Influence::ChuckTilt, "chuck_tilt", LT_TEXT("Engine", "Tilting stiffness of the chuck")},
        {Influence::Rests, "rests", LT_TEXT("Engine", "Stiffness of the rests")},
        {Influence::ToolPost, "tool_post", LT_TEXT("Engine", "Stiffness of the tool post")},
        {Influence::Modulus, "modulus", LT_TEXT("Engine", "Elastic modulus")},
        {Influence::Forces, "forces", LT_TEXT("Engine", "Cutting forces")}};
    return all;
}

const InfluenceName& nameOf(Influence influence)
{
    return influences()[static_cast<std::size_t>(influence)];
}

bool hasInfluence(const TurningSetup& setup, Influence influence)
{
    switch (influence) {
        case Influence::Tailstock: return setup.tailstock.has_value();
        case Influence::ChuckRadial: return setup.chuck.radial_N_mm > 0;
        case Influence::ChuckTilt: return setup.chuck.tilt_N_mm_rad > 0;
        case Influence::Rests: return !setup.steady_rests.empty() || setup.follower_rest;
        case Influence::ToolPost: return setup.tool_post.has_value();
        case Influence::Modulus:
        case Influence::Forces: break;
    }
    return true;
}

TurningSetup scaled(TurningSetup setup, Influence influence, double factor)
{
    switch (influence) {
        case Influence::Tailstock:
            if (setup.tailstock) {
                setup.tailstock->radial_N_mm *= factor;
                setup.tailstock->tilt_N_mm_rad *= factor;
            }
            break;
        case Influence::ChuckRadial: setup.chuck.radial_N_mm *= factor; break;
        case Influence::ChuckTilt: setup.chuck.tilt_N_mm_rad *= factor; break;
        case Influence::Rests:
            for (SteadyRest& rest : setup.steady_rests) rest.radial_N_mm *= factor;
            if (setup.follower_rest) setup.follower_rest->radial_N_mm *= factor;
            break;
        case Influence::ToolPost:
            if (setup.tool_post) {
                setup.tool_post->radial_N_mm *= factor;
                setup.tool_post->tangential_N_mm *= factor;
            }
            break;
        case Influence::Modulus: setup.material.elastic.elastic_modulus_MPa *= factor; break;
        case Influence::Forces: {
            cutting::CuttingCoefficients& k = setup.material.cutting;
            for (double* coefficient : {&k.K_tc_N_mm2, &k.K_te_N_mm, &k.K_rfc_N_mm2, &k.K_rfe_N_mm})
                *coefficient *= factor;
            break;
        }
    }
    return setup;
}

TurningSetup withSpringsScaled(TurningSetup setup, double factor)
{
    for (const Influence one : {Influence::Tailstock, Influence::ChuckRadial, Influence::ChuckTilt, Influence::Rests})
        setup = scaled(std::move(setup), one, factor);
    return setup;
}

}  // namespace lathelier::deflection
