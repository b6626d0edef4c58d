#include "engine/sample/profile_sample.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "engine/core/random.h"

namespace lathelier::sample {
namespace {

constexpr char syntheticProfile[] = "synthetic: a profile made by Lathelier, not a measurement";
constexpr int profilePoints = 1024;
constexpr double profileRadius_mm = 15;
constexpr double eccentricity_um = 20;    ///< of the part on the table of the measuring machine
constexpr double oval_um = 1.2;           ///< amplitude of two undulations
constexpr double trilobe_um = 0.8;        ///< amplitude of three undulations, as of a three-jaw chuck
constexpr double chatterWaves_um = 0.3;   ///< amplitude of 27 undulations
constexpr double profileNoise_um = 0.05;  ///< standard deviation of a point

SampleContent makeProfile(std::uint64_t seed, const Progress& progress)
{
    std::string text = fmt::format("# {}\nangle_deg,r_mm\n", syntheticProfile);
    for (int i = 0; i < profilePoints; ++i) {
        const double angle = 2 * std::numbers::pi * i / profilePoints;
        const double form_um = eccentricity_um * std::cos(angle - 1) + oval_um * std::cos(2 * angle) +
                               trilobe_um * std::cos(3 * angle + 0.5) + chatterWaves_um * std::cos(27 * angle) +
                               profileNoise_um * randomNormal(seed, 12, static_cast<std::uint64_t>(i));
        text += fmt::format("{:.6f},{:.6f}\n", 360.0 * i / profilePoints, profileRadius_mm + 1e-3 * form_um);
    }
    progress.report(1);
    SampleContent content;
    content.texts = {std::move(text)};
    content.truth = std::make_shared<Json>(Json{{"profile",
                                                 {{"about", syntheticProfile},
                                                  {"points", profilePoints},
                                                  {"radius_mm", profileRadius_mm},
                                                  {"eccentricity_um", eccentricity_um},
                                                  {"amplitude_2_upr_um", oval_um},
                                                  {"amplitude_3_upr_um", trilobe_um},
                                                  {"amplitude_27_upr_um", chatterWaves_um},
                                                  {"noise_um", profileNoise_um}}}});
    return content;
}

}  // namespace

const SamplePart& profileSample()
{
    static const SamplePart part{"profile", {"profile.csv"}, makeProfile};
    return part;
}

}  // namespace lathelier::sample
