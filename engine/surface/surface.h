// Photographs of turned surfaces: pitch and direction of the feed marks, whether there is chatter, and its frequency.
// Source: P. Jasiewicz and K. Miądlicki, "An integrated CNC system for chatter suppression in turning", figs. 16-18
// (marks of one surface at two spindle speeds); geometry in chatter_geometry.h, significance in significance.h.
// A photograph says nothing of heights: contrast depends on the light far more than on the surface, so that no figure
// of roughness is made from it, and amplitudes are compared only between pictures that were taken alike.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/fields.h"
#include "engine/core/progress.h"
#include "engine/io/image/image.h"
#include "engine/surface/chatter_geometry.h"
#include "engine/surface/grid.h"
#include "engine/surface/surface_view.h"

namespace lathelier::surface {

/// A part of a picture.
struct Region {
    double x = 0;       ///< left edge, px
    double y = 0;       ///< upper edge, px
    double width = 0;   ///< px
    double height = 0;  ///< px
};

/// The speed that a picture's surface was cut with.
struct CutSpeed {
    double rpm = 0;  ///< of the spindle; 0: not known
};

const std::vector<Field<Region>>& fieldsOf(const Region*);
const std::vector<Field<CutSpeed>>& fieldsOf(const CutSpeed*);

struct SurfaceParameters {
    std::optional<double> feed_mm_rev;  ///< of the cut; none: periods and directions only
    std::optional<double> diameter_mm;  ///< of the turned part
    std::vector<CutSpeed> speed_rpm;    ///< one for each picture, or one for all; none: no frequencies
    std::optional<double> mm_per_px;    ///< scale
    std::string scale_px_mm;            ///< "PX:MM": so many pixels are so many mm; empty: not given
    bool scale_from_feed = false;       ///< the marks' pitch is the feed
    std::string unroll = "auto";        ///< "auto", "no", "far", or the camera's distance from the axis in mm
    std::optional<double> axis_px;      ///< where the axis crosses the picture's middle, from the top (an upright
                                        ///< axis: from the left); none: in the middle
    std::vector<Region> roi;            ///< one for each picture, or one for all; none: the whole picture
    std::optional<double> feed_direction_deg;            ///< in the picture, from right toward down; none: not known
    CutDirection cut_direction = CutDirection::Unknown;  ///< of later points of a track, the feed pointing right
    std::optional<double> expect_hz;                     ///< chooses among candidates that the picture leaves open
    double alpha = 1e-3;                                 ///< chance of a false line in a picture
    double speed_uncertainty_percent = 0.5;              ///< of the spindle speed
};

const std::vector<Field<SurfaceParameters>>& fieldsOf(const SurfaceParameters*);

enum class MarksVerdict { NoPeriodicMarks, FeedMarks, ChatterMarks };
enum class ChatterKind { Unknown, Regenerative, Forced };
enum class ScaleSource { None, Given, ScaleBar, Feed };

const char* key(MarksVerdict verdict);
const char* key(ChatterKind kind);
const char* key(ScaleSource source);

struct FeedMarks {
    std::optional<double> pitch_mm;             ///< distance of the marks; none without a scale
    double pitch_px = 0;                        ///< in pixels of the file
    std::optional<double> pitch_error_percent;  ///< against the feed
    double direction_deg = 0;  ///< across the marks, in (-90, 90], from x toward y; no correction for the helix
    double significance = 0;   ///< power over the level of the noise
    double amplitude = 0;      ///< of the flattened picture; without a unit
    double regularity = 0;     ///< power of the line over the power within ±20 % of its frequency
    double share_percent = 0;  ///< of the flattened picture's variance, all lines
};

struct ChatterMarks {
    double nu = 0;                                   ///< ν: waves between neighbouring tracks, in (-½, ½]
    std::optional<int> m;                            ///< whole waves in a revolution; none without diameter and scale
    bool m_certain = false;                          ///< the picture itself decides m
    double phase_deg = 0;                            ///< ε of the regeneration
    std::optional<double> axial_period_mm;           ///< f / |ν|
    std::optional<double> circumferential_pitch_mm;  ///< πD / m
    std::optional<double> inclination_deg;           ///< of the crests to the axis
    std::optional<double> frequency_hz;              ///< of the vibration
    std::optional<double> frequency_uncertainty_hz;  ///< standard uncertainty, that of the spindle speed included
    std::vector<double> candidates_hz;               ///< the best first
    std::vector<double> harmonic_of_hz;              ///< half and a third of it: symmetric light shows multiples
    std::optional<double> nearest_other_hz;          ///< distance to the next reading that the marks leave open; where
                                                     ///< they leave none, to m one more or less
    double amplitude = 0;                            ///< of the strongest line; without a unit
    double relative_to_feed = 0;                     ///< the same as a multiple of the feed line's
    double significance = 0;                         ///< of the strongest line
    double regularity = 0;                           ///< as that of the feed marks
    double share_percent = 0;                        ///< of the flattened picture's variance, all lines
    std::optional<double> waves_measured;            ///< m as measured, no whole number
    std::optional<double> waves_in_view;             ///< across the picture along the circumference
    int lines = 0;                                   ///< of the lattice that are seen
    ChatterKind kind = ChatterKind::Unknown;         ///< by ν
};

struct ImageMarks {
    std::string path;                                        ///< of the file
    int width = 0;                                           ///< in pixels
    int height = 0;                                          ///< in pixels
    int bits = 8;                                            ///< of a sample
    int orientation_applied = 1;                             ///< EXIF orientation that was undone; 1: none
    std::optional<double> mm_per_px;                         ///< scale
    ScaleSource mm_per_px_source = ScaleSource::None;        ///< where it is from
    double saturated_percent = 0;                            ///< pixels at an end of the scale
    double threshold = 0;                                    ///< T: what S has to exceed
    double largest_significance = 0;                         ///< S of the strongest line
    std::optional<double> speed_rpm;                         ///< of the cut
    std::optional<double> feed_direction_deg;                ///< as stated, in the picture
    bool unrolled = false;                                   ///< the cylinder was laid flat
    bool curved = false;                                     ///< it curves away and was not laid flat
    std::optional<FeedMarks> feed_marks;                     ///< none: no comb
    std::optional<ChatterMarks> chatter_marks;               ///< none: nothing beside the comb
    std::optional<double> detection_limit_relative_to_feed;  ///< chatter above it would have been found
    MarksVerdict verdict = MarksVerdict::NoPeriodicMarks;    ///< what is seen
    SurfaceView view;                                        ///< to draw
};

struct SurfaceComparison {
    bool same_scale = false;           ///< scales are known, so that lengths can be compared
    double registration_response = 0;  ///< of phase correlation, 0 to 1: the first two pictures
    bool registered = false;           ///< they show one surface
    Vector shift{};                    ///< registered: of the second picture against the first, in pixels of aligned()
    std::vector<std::optional<double>> relative_to_feed;  ///< by picture; none: no chatter was found
};

struct SurfaceResult {
    SurfaceParameters parameters;                 ///< as asked
    std::vector<ImageMarks> images;               ///< in the order given
    std::optional<SurfaceComparison> comparison;  ///< of two pictures or more
    Notes notes;                                  ///< of all pictures
};

/// A picture with its name.
struct NamedImage {
    std::string path;                          ///< for messages
    std::shared_ptr<const io::Image> image;    ///< shared with whoever has read it; never null
    std::optional<double> mm_per_px;           ///< its own scale, in place of that of the parameters
    std::optional<double> feed_direction_deg;  ///< its own direction of feed

    NamedImage(std::string name, std::shared_ptr<const io::Image> there)
        : path(std::move(name)), image(std::move(there))
    {
    }
    NamedImage(std::string name, io::Image made)
        : NamedImage(std::move(name), std::make_shared<const io::Image>(std::move(made)))
    {
    }
};

inline constexpr int leastSide_px = 128;      ///< of a picture
inline constexpr double leastFeed_px = 4;     ///< pixels for a feed, below which it is not resolved
inline constexpr double wantedFeed_px = 6;    ///< pixels for a feed that are wanted
inline constexpr double leastChatter = 0.02;  ///< amplitude of chatter relative to the feed line
inline constexpr double curvedField = 0.2;    ///< of the diameter: a wider field is unrolled

/// Errors valueNotUnderstood (numbers of speeds or regions, two scales, no feed for a scale from it), regionOutside,
/// pictureTooSmall, feedNotResolved, feedAliased. Throws Cancelled.
SurfaceResult findSurfaceMarks(const std::vector<NamedImage>& images, const SurfaceParameters& parameters = {},
                               const Progress& progress = {});

}  // namespace lathelier::surface
