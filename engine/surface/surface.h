// Photographs of turned surfaces: pitch and direction of the feed marks, whether there is chatter, and its frequency.
// Source: P. Jasiewicz and K. Miądlicki, "An integrated CNC system for chatter suppression in turning", figs. 16-18
// (marks of one surface at two spindle speeds); geometry in chatter_geometry.h, significance in significance.h. A
// photograph contains no height information: contrast depends on illumination far more than on the surface. So no
// roughness parameter is derived, and amplitudes are compared only between pictures taken under equal conditions.
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

/// Cutting speed of the surface in a picture.
struct CutSpeed {
    double rpm = 0;  ///< spindle speed; 0: unknown
};

const std::vector<Field<Region>>& fieldsOf(const Region*);
const std::vector<Field<CutSpeed>>& fieldsOf(const CutSpeed*);

struct SurfaceParameters {
    std::optional<double> feed_mm_rev;  ///< none: only periods and directions
    std::optional<double> diameter_mm;  ///< of the turned part
    std::vector<CutSpeed> speed_rpm;    ///< one for each picture, or one for all; none: no frequencies
    std::optional<double> mm_per_px;
    std::string scale_px_mm;        ///< "PX:MM": PX pixels correspond to MM mm; empty: not given
    bool scale_from_feed = false;   ///< the pitch of the marks is the feed
    bool scale_from_file = false;   ///< the size of a pixel that the files of the pictures state
    std::string unroll = "auto";    ///< "auto", "no", "far", or the camera's distance from the axis in mm
    std::optional<double> axis_px;  ///< where the axis crosses the picture's middle, from the top (an upright
                                    ///< axis: from the left); none: in the middle
    std::vector<Region> roi;        ///< one for each picture, or one for all; none: the whole picture
    std::optional<double> feed_direction_deg;            ///< in the picture, from right toward down; none: not known
    CutDirection cut_direction = CutDirection::Unknown;  ///< in a picture rotated so that the feed points right
    std::optional<double> expect_hz;         ///< expected frequency, for the choice among ambiguous candidates
    double alpha = 1e-3;                     ///< false-detection probability per picture
    double speed_uncertainty_percent = 0.5;  ///< of the spindle speed
};

const std::vector<Field<SurfaceParameters>>& fieldsOf(const SurfaceParameters*);

enum class MarksVerdict { NoPeriodicMarks, FeedMarks, ChatterMarks, Undecided };
enum class ChatterKind { Unknown, Regenerative, Forced };
enum class ScaleSource { None, Given, ScaleBar, Feed, File };

const char* key(MarksVerdict verdict);
const char* key(ChatterKind kind);
const char* key(ScaleSource source);

struct FeedMarks {
    std::optional<double> pitch_mm;             ///< none without a scale
    double pitch_px = 0;                        ///< in pixels of the file
    std::optional<double> pitch_error_percent;  ///< against the feed
    double direction_deg =
        0;                    ///< normal to the marks, in (-90, 90], from x toward y; not corrected for the helix angle
    double significance = 0;  ///< S: power over the noise level
    double amplitude = 0;     ///< of the flattened picture; dimensionless
    double regularity = 0;    ///< power of the line over the power within ±20 % of its frequency
    double share_percent = 0;  ///< of the flattened picture's variance, all lines
};

struct ChatterMarks {
    double nu = 0;                                   ///< ν: waves between neighbouring tracks, in (-½, ½]
    std::optional<int> m;                            ///< whole waves in a revolution; none without diameter and scale
    bool m_certain = false;                          ///< m is determined by the picture alone
    double phase_deg = 0;                            ///< ε of the regeneration
    std::optional<double> axial_period_mm;           ///< f / |ν|
    std::optional<double> circumferential_pitch_mm;  ///< πD / m
    std::optional<double> inclination_deg;           ///< of the crests to the axis
    std::optional<double> frequency_hz;              ///< of the vibration
    std::optional<double> frequency_uncertainty_hz;  ///< standard uncertainty, that of the spindle speed included
    std::vector<double> candidates_hz;               ///< the best first
    std::vector<double>
        harmonic_of_hz;  ///< half and a third of frequency_hz, as symmetric illumination shows multiples
    std::optional<double> nearest_other_hz;   ///< distance to the nearest alternative reading; if
                                              ///< there is none, to that with m ± 1
    double amplitude = 0;                     ///< of the strongest line; dimensionless
    double relative_to_feed = 0;              ///< amplitude relative to the feed line
    double significance = 0;                  ///< of the strongest line
    double regularity = 0;                    ///< as that of the feed marks
    double share_percent = 0;                 ///< of the flattened picture's variance, all lines
    std::optional<double> waves_measured;     ///< measured m, not rounded
    std::optional<double> waves_uncertainty;  ///< standard uncertainty of it
    std::optional<double> slowest_waves;      ///< smallest number of waves in a revolution that may look so
    std::optional<double> waves_in_view;      ///< waves in the picture along the circumference
    int lines = 0;                            ///< number of detected lines
    ChatterKind kind = ChatterKind::Unknown;
};

struct ImageMarks {
    std::string path;
    int width = 0;                ///< in pixels
    int height = 0;               ///< in pixels
    int bits = 8;                 ///< of a sample
    int orientation_applied = 1;  ///< EXIF orientation that was corrected; 1: none
    std::optional<double> mm_per_px;
    ScaleSource mm_per_px_source = ScaleSource::None;  ///< source of the scale
    double saturated_percent = 0;                      ///< share of saturated pixels
    double threshold = 0;                              ///< T: threshold of S
    double largest_significance = 0;                   ///< S of the strongest line
    std::optional<double> speed_rpm;
    std::optional<double> feed_direction_deg;                ///< as stated, in the picture
    bool unrolled = false;                                   ///< the cylinder was unrolled
    bool curved = false;                                     ///< the visible curvature was not unrolled
    std::optional<FeedMarks> feed_marks;                     ///< none: no comb
    std::optional<FeedMarks> second_feed_marks;              ///< of another feed, in a part of the picture
    std::optional<ChatterMarks> chatter_marks;               ///< none: no line outside the comb
    std::optional<double> detection_limit_relative_to_feed;  ///< smallest detectable chatter amplitude
    MarksVerdict verdict = MarksVerdict::NoPeriodicMarks;
    SurfaceView view;
};

/// Whether there is chatter could not be told.
inline bool isOpen(const ImageMarks& image)
{
    return image.verdict == MarksVerdict::Undecided || image.second_feed_marks;
}

struct SurfaceComparison {
    bool same_scale = false;           ///< all scales are known
    double registration_response = 0;  ///< of phase correlation of the first two pictures, 0 to 1
    bool registered = false;           ///< the pictures show the same surface
    Vector shift{};  ///< if registered: of the second picture relative to the first, in pixels of aligned()
    std::vector<std::optional<double>> relative_to_feed;  ///< by picture; none: no chatter detected
};

struct SurfaceResult {
    SurfaceParameters parameters;
    std::vector<ImageMarks> images;               ///< in the order given
    std::optional<SurfaceComparison> comparison;  ///< of two pictures or more
    Notes notes;
};

/// A picture with its name.
struct NamedImage {
    std::string path;
    std::shared_ptr<const io::Image> image;    ///< never null
    std::optional<double> mm_per_px;           ///< scale of this picture, overrides that of the parameters
    std::optional<double> feed_direction_deg;  ///< direction of feed of this picture

    NamedImage(std::string name, std::shared_ptr<const io::Image> there)
        : path(std::move(name)), image(std::move(there))
    {
    }
    NamedImage(std::string name, io::Image made)
        : NamedImage(std::move(name), std::make_shared<const io::Image>(std::move(made)))
    {
    }
};

inline constexpr int leastSide_px = 128;
inline constexpr double leastFeed_px = 4;     ///< smallest number of pixels per feed
inline constexpr double wantedFeed_px = 6;    ///< recommended number of pixels per feed
inline constexpr double leastChatter = 0.02;  ///< smallest amplitude of chatter relative to the feed line
inline constexpr double curvedField = 0.2;    ///< field width over diameter above which the picture is unrolled

/// Errors valueNotUnderstood (numbers of speeds or regions, two scales, no feed for a scale from it), scaleNotStated,
/// regionOutside,
/// pictureTooSmall, feedNotResolved, feedAliased. Throws Cancelled.
SurfaceResult findSurfaceMarks(const std::vector<NamedImage>& images, const SurfaceParameters& parameters = {},
                               const Progress& progress = {});

}  // namespace lathelier::surface
