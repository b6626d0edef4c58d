// Synthetic pictures of turned surfaces from a physical model, with known truth: a round nose is swept along the helix
// with a vibration x(t) = A sin(2π f_c t), the surface is the lower envelope of neighbouring tracks, and its slopes
// reflect light from one side or all round. For tests, samples and teaching. Source: the kinematics of turning
// (theoretical roughness f² / (8 r)); reflection after B. T. Phong, "Illumination for computer generated pictures",
// CACM 18 (1975).
#pragma once

#include <cstdint>
#include <string>

#include "engine/core/fields.h"
#include "engine/core/progress.h"
#include "engine/io/image/image.h"
#include "engine/surface/chatter_geometry.h"

namespace lathelier::surface {

/// Direction of the light.
enum class Light { AlongFeed, AcrossFeed, Oblique, Ring };

struct SyntheticParameters {
    double diameter_mm = 30;      ///< of the turned part
    double feed_mm_rev = 0.1;     ///< f
    double nose_radius_mm = 0.4;  ///< r
    double speed_rpm = 2016;
    double frequency_hz = 361;              ///< of the vibration
    double amplitude_um = 0;                ///< of the vibration; 0: none
    double feed_direction_deg = 0;          ///< in the picture, from x toward y
    CutDirection cut = CutDirection::Down;  ///< in the picture; Unknown: Down
    double mm_per_px = 0.006;
    int width = 720;                 ///< in pixels
    int height = 540;                ///< in pixels
    bool cylinder = false;           ///< parallel projection of a cylinder; false: a small, flat field
    Light light = Light::AlongFeed;  ///< direction of the light
    double elevation_deg = 60;       ///< of the light above the surface
    double irregular = 0.1;          ///< standard deviation of the tracks' depths, as a share of Rt = f² / (8 r)
    double grooves = 0.1;            ///< amplitude of random grooves relative to the brightness
    double noise = 0.03;             ///< standard deviation of pixel noise, relative to full scale
    double blur_px = 0.8;            ///< of the optics
    int bits = 8;                    ///< of a pixel: 8 or 16
    bool stamped = false;            ///< draws the word SYNTHETIC in a corner
    int seed = 1;
};

const std::vector<Field<SyntheticParameters>>& fieldsOf(const SyntheticParameters*);

/// The same parameters give the same picture. Throws Cancelled.
io::Image syntheticPicture(const SyntheticParameters& parameters, const Progress& progress = {});

/// The picture as a PNG file whose comment says SYNTHETIC.
std::string syntheticPng(const io::Image& image);

}  // namespace lathelier::surface
