// Charts of the evaluation: spectrum with marked comb and lattice, their lines over the noise, grey levels of pictures.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/report/chart.h"
#include "engine/report/png.h"
#include "engine/surface/surface.h"

namespace lathelier::surface {

/// Decades of power over the median of its ring, with labelled rings around the lines of comb and lattice.
report::Plot ringedSpectrum(const ImageMarks& image);

/// "f", "2 f" of the comb; "c", "c + f", "2 c - f" of the lattice, with orders relative to the bands.
std::string nameOf(const NamedLine& line);

/// The line within 4 % of the drawn spectrum's edge of a place in it (the axes of ringedSpectrum()), or of its
/// opposite; -1: none.
int lineAt(const ImageMarks& image, double x, double y);

/// The lines of comb and lattice by their power over the noise, with the threshold.
report::Plot linesOverNoise(const ImageMarks& image);

/// Grey levels of a picture between `low` and `high`; a flattened one is shown between ±flatRange.
inline constexpr double flatRange = 2.5;
std::uint8_t levelOf(float value, double low, double high);
report::GreyImage greyOf(const Grid& grid, double low, double high);

/// The brightness of the picture as evaluated, as a PNG file, at most 900 px wide.
std::string picturePng(const ImageMarks& image);

}  // namespace lathelier::surface
