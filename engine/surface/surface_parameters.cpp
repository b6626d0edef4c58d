#include "engine/surface/surface.h"

#include "engine/core/units.h"

namespace lathelier::surface {

const std::vector<Field<Region>>& fieldsOf(const Region*)
{
    static const std::vector<Field<Region>> all{
        field("x_px", &Region::x, {0, 65535},
              {LT_TEXT("Engine", "Left"), LT_TEXT("Engine", "Left edge of the region."), LT_TEXT("Engine", "px"), false,
               true}),
        field("y_px", &Region::y, {0, 65535},
              {LT_TEXT("Engine", "Top"), LT_TEXT("Engine", "Upper edge of the region."), LT_TEXT("Engine", "px"), false,
               true}),
        field("width_px", &Region::width, {1, 65535},
              {LT_TEXT("Engine", "Width"), LT_TEXT("Engine", "Width of the region."), LT_TEXT("Engine", "px"), false,
               true}),
        field("height_px", &Region::height, {1, 65535},
              {LT_TEXT("Engine", "Height"), LT_TEXT("Engine", "Height of the region."), LT_TEXT("Engine", "px"), false,
               true})};
    return all;
}

const std::vector<Field<CutSpeed>>& fieldsOf(const CutSpeed*)
{
    static const std::vector<Field<CutSpeed>> all{
        field("rpm", &CutSpeed::rpm, {0, 100000},
              {LT_TEXT("Engine", "Spindle speed"), LT_TEXT("Engine", "That the surface was cut with; 0: not known."),
               LT_TEXT("Engine", "rpm"), false, true})};
    return all;
}

const std::vector<Field<SurfaceParameters>>& fieldsOf(const SurfaceParameters*)
{
    using P = SurfaceParameters;
    static const std::vector<Field<P>> all{
        field("feed_mm_rev", &P::feed_mm_rev, {0.001, 10},
              {LT_TEXT("Engine", "Feed"),
               LT_TEXT("Engine", "Feed of the cut; none: the best comb of lines is taken for it."), unit::mm_rev}),
        field("diameter_mm", &P::diameter_mm, {0.5, 5000},
              {LT_TEXT("Engine", "Diameter"), LT_TEXT("Engine", "Of the turned part."), unit::mm}),
        rows("speed_rpm", &P::speed_rpm, {0, 1000},
             {LT_TEXT("Engine", "Spindle speed"),
              LT_TEXT("Engine", "Of the cut: one for all pictures, or one for each in their order; 0: not known."),
              LT_TEXT("Engine", "rpm")}),
        field("mm_per_px", &P::mm_per_px, {1e-6, 100},
              {LT_TEXT("Engine", "Scale"), LT_TEXT("Engine", "Millimetres that a pixel is wide."),
               LT_TEXT("Engine", "mm/px")}),
        field("scale_px_mm", &P::scale_px_mm,
              {LT_TEXT("Engine", "Scale bar"), LT_TEXT("Engine", "Its length as PX:MM, such as 250:1.")}),
        field("scale_from_feed", &P::scale_from_feed,
              {LT_TEXT("Engine", "Scale from the feed"),
               LT_TEXT("Engine", "The pitch of the marks is the feed, and checks nothing then.")}),
        field("scale_from_file", &P::scale_from_file,
              {LT_TEXT("Engine", "Scale from the file"),
               LT_TEXT("Engine", "The size of a pixel that the picture's file states, as microscopes write it.")}),
        field("unroll", &P::unroll,
              {LT_TEXT("Engine", "Unroll"),
               LT_TEXT("Engine",
                       "auto (a field wider than 0.2 diameters, seen from far), no, far, or the camera's distance "
                       "from the axis in mm.")}),
        field("axis_px", &P::axis_px, {-100000, 100000},
              {LT_TEXT("Engine", "Place of the axis"),
               LT_TEXT("Engine",
                       "Where the axis crosses the picture's middle, from the top (an upright axis: from the left); "
                       "none: in the middle."),
               LT_TEXT("Engine", "px"), true}),
        rows("roi", &P::roi, {0, 1000},
             {LT_TEXT("Engine", "Region"),
              LT_TEXT("Engine", "Part of the picture that is evaluated: one for all pictures, or one for each.")}),
        field("feed_direction_deg", &P::feed_direction_deg, {-360, 360},
              {LT_TEXT("Engine", "Direction of feed"),
               LT_TEXT("Engine", "In the picture, from right toward down; none: not known."), unit::deg}),
        field("cut_direction", &P::cut_direction,
              {{"unknown", LT_TEXT("Engine", "not known")},
               {"down", LT_TEXT("Engine", "down")},
               {"up", LT_TEXT("Engine", "up")}},
              {LT_TEXT("Engine", "Direction of cut"),
               LT_TEXT("Engine",
                       "Along a track toward what was cut later, in a picture turned so that the feed points "
                       "right.")}),
        field(
            "expect_hz", &P::expect_hz, {0.1, 100000},
            {LT_TEXT("Engine", "Expected frequency"),
             LT_TEXT("Engine", "Of a model or a tap test: chooses among the candidates that the picture leaves open."),
             unit::hz}),
        field("alpha", &P::alpha, {1e-9, 0.5},
              {LT_TEXT("Engine", "False alarms"),
               LT_TEXT("Engine", "Chance of a false line in a picture of noise."),
               {},
               true}),
        field("speed_uncertainty_percent", &P::speed_uncertainty_percent, {0, 20},
              {LT_TEXT("Engine", "Uncertainty of the speed"),
               LT_TEXT("Engine", "Standard uncertainty of the spindle speed."), unit::percent, true}),
    };
    return all;
}

const char* key(MarksVerdict verdict)
{
    switch (verdict) {
        case MarksVerdict::NoPeriodicMarks: return "no_periodic_marks";
        case MarksVerdict::FeedMarks: return "feed_marks";
        case MarksVerdict::ChatterMarks: return "chatter_marks";
        case MarksVerdict::Undecided: return "undecided";
    }
    return "";
}

const char* key(ChatterKind kind)
{
    switch (kind) {
        case ChatterKind::Unknown: return "unknown";
        case ChatterKind::Regenerative: return "regenerative";
        case ChatterKind::Forced: return "forced";
    }
    return "";
}

const char* key(ScaleSource source)
{
    switch (source) {
        case ScaleSource::None: return "none";
        case ScaleSource::Given: return "given";
        case ScaleSource::ScaleBar: return "scale_bar";
        case ScaleSource::Feed: return "feed";
        case ScaleSource::File: return "file";
    }
    return "";
}

}  // namespace lathelier::surface
