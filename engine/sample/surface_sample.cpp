#include "engine/sample/surface_sample.h"

#include <nlohmann/json.hpp>

#include "engine/surface/synthetic.h"

namespace lathelier::sample {
namespace {

constexpr double before_rpm = 2016, after_rpm = 2154, feed_mm_rev = 0.1, diameter_mm = 30;
constexpr double chatter_hz = 364.8;  // where the tip of chatterSample()'s shaft chatters at before_rpm, exact relation
constexpr double amplitude_um = 9.375;  // 3 times the depth of a feed mark, f² / (8 r)

surface::SyntheticParameters taken(double speed_rpm, double vibration_um, std::uint64_t seed)
{
    surface::SyntheticParameters p;
    p.diameter_mm = diameter_mm;
    p.feed_mm_rev = feed_mm_rev;
    p.nose_radius_mm = 0.4;
    p.speed_rpm = speed_rpm;
    p.frequency_hz = chatter_hz;
    p.amplitude_um = vibration_um;
    p.mm_per_px = surfaceSample_mm_px;
    p.width = 450;
    p.height = 1900;
    p.cylinder = true;
    p.noise = 0.02;
    p.stamped = true;
    p.seed = static_cast<int>(seed % 1000000);
    return p;
}

SampleContent makeSurface(std::uint64_t seed, const Progress& progress)
{
    SampleContent content;
    const auto picture = [&](const surface::SyntheticParameters& p, const Progress& part) {
        content.texts.push_back(surface::syntheticPng(surface::syntheticPicture(p, part)));
    };
    picture(taken(before_rpm, amplitude_um, seed), progress.part(0, 0.5));
    picture(taken(after_rpm, 0, seed + 1), progress.part(0.5, 1));
    const surface::Waves waves = surface::wavesPerRevolution(chatter_hz, before_rpm);
    content.truth = std::make_shared<Json>(
        Json{{"surface",
              {{"about", "synthetic pictures of a turned surface"},
               {"diameter_mm", diameter_mm},
               {"feed_mm_rev", feed_mm_rev},
               {"mm_per_px", surfaceSample_mm_px},
               {"before", {{"speed_rpm", before_rpm}, {"chatter_hz", chatter_hz}, {"m", waves.m}, {"nu", waves.nu}}},
               {"after", {{"speed_rpm", after_rpm}, {"chatter_hz", nullptr}}}}}});
    SamplePanel panel;
    panel.inputs = {{"before", "surface_before.png"}, {"after", "surface_after.png"}, {"frf", "tip_response.uff"}};
    panel.parameters = {{"feed_mm_rev", feed_mm_rev},          {"diameter_mm", diameter_mm},
                        {"speed_before_rpm", before_rpm},      {"speed_after_rpm", after_rpm},
                        {"mm_per_px", surfaceSample_mm_px},    {"feed_direction_deg", 0.0},
                        {"cut_direction", std::string("down")}};
    content.panels["surface"] = std::move(panel);
    return content;
}

}  // namespace

const SamplePart& surfaceSample()
{
    static const SamplePart part{"surface", {"surface_before.png", "surface_after.png"}, makeSurface};
    return part;
}

}  // namespace lathelier::sample
