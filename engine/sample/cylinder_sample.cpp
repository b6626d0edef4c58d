#include "engine/sample/cylinder_sample.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "engine/core/random.h"

namespace lathelier::sample {
namespace {

constexpr char kSynthetic[] = "synthetic: sections of a cylinder made by Lathelier, not a measurement";
constexpr int sections = 25;
constexpr int angles = 180;
constexpr double length_mm = 120;
constexpr double radius_mm = 20;
constexpr double bow_um = 6;      ///< of the axis in the middle, towards x
constexpr double barrel_um = 4;   ///< of the radius, the middle against the ends
constexpr double lobes_um = 1.5;  ///< amplitude of three undulations, as of a three-jaw chuck
constexpr double noise_um = 0.2;  ///< standard deviation of a point

SampleContent makeCylinder(std::uint64_t seed, const Progress& progress)
{
    std::string text = fmt::format(
        "ply\nformat ascii 1.0\ncomment unit mm\ncomment {}\nelement vertex {}\n"
        "property double x\nproperty double y\nproperty double z\nend_header\n",
        kSynthetic, sections * angles);
    for (int s = 0; s < sections; ++s) {
        const double u = 2.0 * s / (sections - 1) - 1, middle = 1 - u * u;
        for (int i = 0; i < angles; ++i) {
            const double angle = 2 * std::numbers::pi * i / angles;
            const auto place =
                static_cast<std::uint64_t>(s) * static_cast<std::uint64_t>(angles) + static_cast<std::uint64_t>(i);
            const double r = radius_mm + 1e-3 * (barrel_um * middle + lobes_um * std::cos(3 * angle) +
                                                 noise_um * randomNormal(seed, 11, place));
            text += fmt::format("{:.6f} {:.6f} {:.4f}\n", r * std::cos(angle) + 1e-3 * bow_um * middle,
                                r * std::sin(angle), length_mm * s / (sections - 1));
        }
    }
    progress.report(1);
    SampleContent content;
    content.texts = {std::move(text)};
    content.truth = std::make_shared<Json>(Json{{"cylinder",
                                                 {{"about", kSynthetic},
                                                  {"sections", sections},
                                                  {"length_mm", length_mm},
                                                  {"radius_mm", radius_mm},
                                                  {"bow_um", bow_um},
                                                  {"barrel_um", barrel_um},
                                                  {"lobes_um", lobes_um},
                                                  {"noise_um", noise_um}}}});
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
