#include "engine/sample/surface_sample.h"

#include <nlohmann/json.hpp>

#include "engine/surface/synthetic.h"

namespace lathelier::sample {
namespace {

constexpr double before_rpm = 2016, after_rpm = 2154;

surface::SyntheticParameters taken(double speed_rpm, double amplitude_um, double feed_direction_deg, std::uint64_t seed)
{
    surface::SyntheticParameters p;
    p.feed_mm_rev = 0.2;
    p.nose_radius_mm = 0.8;
    p.speed_rpm = speed_rpm;
    p.frequency_hz = 361;
    p.amplitude_um = amplitude_um;
    p.feed_direction_deg = feed_direction_deg;
    p.mm_per_px = 0.03;
    p.width = 400;
    p.height = 880;
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
    const double amplitude_um = 18.75;  // 3 times the depth of a feed mark, f² / (8 r)
    picture(taken(before_rpm, amplitude_um, 0, seed), progress.part(0, 0.5));
    picture(taken(after_rpm, 0, 0, seed + 1), progress.part(0.5, 1));
    content.truth =
        std::make_shared<Json>(Json{{"surface",
                                     {{"about", "synthetic pictures of a turned surface"},
                                      {"diameter_mm", 30},
                                      {"feed_mm_rev", 0.2},
                                      {"mm_per_px", 0.03},
                                      {"before", {{"speed_rpm", before_rpm}, {"chatter_hz", 361}, {"m", 11}}},
                                      {"after", {{"speed_rpm", after_rpm}, {"chatter_hz", nullptr}}}}}});
    SamplePanel panel;
    panel.inputs = {{"before", "surface_before.png"}, {"after", "surface_after.png"}, {"frf", "tip_response.uff"}};
    panel.parameters = {{"feed_mm_rev", 0.2},
                        {"diameter_mm", 30.0},
                        {"speed_before_rpm", before_rpm},
                        {"speed_after_rpm", after_rpm},
                        {"mm_per_px", 0.03},
                        {"feed_direction_deg", 0.0},
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
