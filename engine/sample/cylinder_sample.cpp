#include "engine/sample/cylinder_sample.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "engine/core/random.h"

namespace lathelier::sample {
namespace {

constexpr char syntheticCylinder[] = "synthetic: sections of a cylinder made by Lathelier, not a measurement";
constexpr int cylinderSections = 25;
constexpr int sectionAngles = 180;
constexpr double cylinderLength_mm = 120;
constexpr double cylinderRadius_mm = 20;
constexpr double cylinderBow_um = 6;      ///< of the axis in the middle, towards x
constexpr double cylinderBarrel_um = 4;   ///< of the radius, the middle against the ends
constexpr double cylinderLobes_um = 1.5;  ///< amplitude of three undulations, as of a three-jaw chuck
constexpr double cylinderNoise_um = 0.2;  ///< standard deviation of a point

SampleContent makeCylinder(std::uint64_t seed, const Progress& progress)
{
    std::string text = fmt::format(
        "ply\nformat ascii 1.0\ncomment unit mm\ncomment {}\nelement vertex {}\n"
        "property double x\nproperty double y\nproperty double z\nend_header\n",
        syntheticCylinder, cylinderSections * sectionAngles);
    for (int s = 0; s < cylinderSections; ++s) {
        const double u = 2.0 * s / (cylinderSections - 1) - 1, middle = 1 - u * u;
        for (int i = 0; i < sectionAngles; ++i) {
            const double angle = 2 * std::numbers::pi * i / sectionAngles;
            const auto place = static_cast<std::uint64_t>(s) * static_cast<std::uint64_t>(sectionAngles) +
                               static_cast<std::uint64_t>(i);
            const double r =
                cylinderRadius_mm + 1e-3 * (cylinderBarrel_um * middle + cylinderLobes_um * std::cos(3 * angle) +
                                            cylinderNoise_um * randomNormal(seed, 11, place));
            text += fmt::format("{:.6f} {:.6f} {:.4f}\n", r * std::cos(angle) + 1e-3 * cylinderBow_um * middle,
                                r * std::sin(angle), cylinderLength_mm * s / (cylinderSections - 1));
        }
    }
    progress.report(1);
    SampleContent content;
    content.texts = {std::move(text)};
    content.truth = std::make_shared<Json>(Json{{"cylinder",
                                                 {{"about", syntheticCylinder},
                                                  {"sections", cylinderSections},
                                                  {"length_mm", cylinderLength_mm},
                                                  {"radius_mm", cylinderRadius_mm},
                                                  {"bow_um", cylinderBow_um},
                                                  {"barrel_um", cylinderBarrel_um},
                                                  {"lobes_um", cylinderLobes_um},
                                                  {"noise_um", cylinderNoise_um}}}});
    content.panels["cylindricity"] = {.inputs = {{"points", "cylinder_sections.ply"}},
                                      .parameters = {{"tolerance_um", 15.0}}};
    return content;
}

}  // namespace

const SamplePart& cylinderSample()
{
    static const SamplePart part{"cylinder", {"cylinder_sections.ply"}, makeCylinder};
    return part;
}

}  // namespace lathelier::sample
