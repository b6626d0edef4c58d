// What panels and reports draw of one picture.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/surface/grid.h"

namespace lathelier::surface {

/// A line of the spectrum with its name.
struct NamedLine {
    Vector frequency{};                    ///< cycles per pixel of `picture`
    bool is_feed = true;                   ///< of the comb; else of the chatter lattice
    int multiple = 1;                      ///< of the comb's or the vibration's first line
    int order = 0;                         ///< chatter: distance in lines of the comb
    std::optional<double> significance{};  ///< power over the level of the noise; none: not looked at
};

struct SurfaceView {
    Grid picture;           ///< brightness as evaluated (unrolled, made smaller), 0 to 1
    Grid flat;              ///< the same after flattening
    double px_per_px = 1;   ///< pixels of the file in one of `picture`
    double turned_deg = 0;  ///< direction of the file's x axis turned into that of `picture`: angle that was taken off
    Grid spectrum;          ///< logarithm (base 10) of the power over the median of its ring, about zero
    double spectrum_edge = 0.5;    ///< largest frequency of `spectrum`, cycles per pixel of `picture`
    std::vector<NamedLine> lines;  ///< that were found
    std::optional<Vector> feed;    ///< first line of the comb, cycles per pixel of `picture`
    std::optional<Vector> bands;   ///< wave vector of the chatter bands: the K_c + j K_f that is least along the feed
};

struct PictureLines;

/// Fills in spectrum and lines.
void drawSpectrum(SurfaceView& view, const PictureLines& lines);

}  // namespace lathelier::surface
