// Data of one picture for display in panels and reports.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/surface/grid.h"

namespace lathelier::surface {

/// A line of the spectrum with its name.
struct NamedLine {
    Vector frequency{};                    ///< cycles per pixel of `picture`
    bool is_feed = true;                   ///< false: line of the chatter lattice
    int multiple = 1;                      ///< multiple of the fundamental of comb or vibration
    int order = 0;                         ///< chatter: order of the feed
    std::optional<double> significance{};  ///< S; none: not evaluated
};

struct SurfaceView {
    Grid picture;           ///< evaluated brightness (reduced, unrolled), 0 to 1
    Grid flat;              ///< the same after flattening
    double px_per_px = 1;   ///< file pixels per pixel of `picture`
    double turned_deg = 0;  ///< rotation from the file to `picture`, subtracted from directions
    Grid spectrum;          ///< logarithm (base 10) of the power over the median of its ring, centred at zero frequency
    double spectrum_edge = 0.5;  ///< largest frequency of `spectrum`, cycles per pixel of `picture`
    std::vector<NamedLine> lines;
    std::optional<Vector> feed;  ///< first line of the comb, cycles per pixel of `picture`
    std::optional<Vector>
        bands;  ///< wave vector of the chatter bands: the K_c + j K_f with the smallest component along the feed
};

struct PictureLines;

/// Fills in spectrum and lines.
void drawSpectrum(SurfaceView& view, const PictureLines& lines);

}  // namespace lathelier::surface
