// What makes a line of the spectrum that is not in the comb of the feed, before it is called chatter.
//
// Light: highlights of lamps are broad bands, mostly along the axis. They modulate brightness and contrast of the feed
// marks: lines near those of the comb, displaced across the feed. A vibration displaces them along it by ν of the
// comb's spacing; a whole number of waves in a revolution (ν = 0) in few waves cannot be told from a lamp. A wave along
// the cut that is shorter than the feed: the clearance face rubs it out (process damping; Y. Altintas, "Manufacturing
// Automation", section 4.8), while the grid of the pixels makes such lines with any fine texture. A second feed: a line
// along the axis where the first feed is not, while chatter lies on its feed marks.
#pragma once

#include "engine/surface/grid.h"
#include "engine/surface/spectrum.h"

namespace lathelier::surface {

/// Thresholds; in bins: periods across the picture.
struct LineOriginLimits {
    double modulation_bins = 25;    ///< from the nearest line of the comb, within which lamps are seen; highlights of
                                    ///< 2 % of the height and wider have faded there
    double unresolved_bins = 1.6;   ///< along the axis: half the main lobe of a Hann window
    double oblique = 0.35;          ///< displacement along the axis over that across: bands up to 20° off the axis
    double second_feed_bins = 1.6;  ///< across the axis, of a second feed
    double second_feed_overlap = 0.7;  ///< of the amplitudes in nine parts of the picture (cosine); of chatter near 1
};

/// `feed`: first line of the comb, cycles per pixel.
bool isOfLight(const WindowedPicture& picture, Vector feed, Vector line);
bool isShorterThanFeed(Vector feed, Vector line);

/// `flat`: the picture; costs 18 sums over a ninth of it.
bool isSecondFeed(const Grid& flat, Vector feed, Vector line);

}  // namespace lathelier::surface
