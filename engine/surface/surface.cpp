#include "engine/surface/surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "engine/surface/chatter_reading.h"
#include "engine/surface/picture_comparison.h"
#include "engine/surface/picture_lines.h"
#include "engine/surface/preparation.h"
#include "engine/surface/surface_codes.h"
#include "engine/surface/surface_inputs.h"

namespace lathelier::surface {
namespace {

constexpr double fewPixels = 2e6;           // smallest number of pixels after reduction…
constexpr double feedKept_px = 8;           // …and smallest number of pixels per feed
constexpr double mostUnknownReduction = 2;  // if the feed in pixels is unknown
constexpr int searchedForAlias_px = 1400;   // side of the examined region
constexpr double saturatedMost_percent = 2;
constexpr double pitchMost_percent = 3;
constexpr double slowestWaves = 2;  // in a revolution: symmetric light shows one as two

double saturated_percent(const GridView& pixels)
{
    std::ptrdiff_t count = 0;
    for (int y = 0; y < pixels.rows; ++y)
        count += std::count_if(pixels.row(y), pixels.row(y) + pixels.columns,
                               [](float v) { return v <= 0 || v >= 0.9999F; });
    return 100.0 * static_cast<double>(count) / (double(pixels.columns) * pixels.rows);
}

/// True if the pattern may have less than one wave in a revolution, seen doubled: no vibration of the cut is that slow.
bool isSlow(const ChatterMarks& chatter)
{
    return *chatter.slowest_waves < slowestWaves;
}

/// Evaluation of one picture.
class Evaluation {
public:
    Evaluation(const NamedImage& named, const SurfaceParameters& p, std::size_t index, std::size_t pictures,
               Notes& notes)
        : p_(p), notes_(notes), roi_(ofPicture(p.roi, index, pictures, "roi")), pixels_(regionOf(*named.image, roi_))
    {
        marks_.path = named.path;
        marks_.width = named.image->width;
        marks_.height = named.image->height;
        marks_.bits = named.image->bits;
        marks_.orientation_applied = named.image->orientation;
        const CutSpeed* const speed = ofPicture(p.speed_rpm, index, pictures, "speed_rpm");
        if (speed && speed->rpm > 0) marks_.speed_rpm = speed->rpm;
        std::tie(marks_.mm_per_px, marks_.mm_per_px_source) = givenScale(p);
        if (named.mm_per_px) {
            marks_.mm_per_px = named.mm_per_px;
            marks_.mm_per_px_source = ScaleSource::Given;
        }
        if (marks_.mm_per_px_source == ScaleSource::File) {
            const double um_per_px = named.image->um_per_px;
            if (!(um_per_px > 0)) throw Error(errors::scaleNotStated, {{"path", named.path}});
            marks_.mm_per_px = um_per_px * 1e-3;
            note(notes::scaleFromFile, {{"um_per_px", um_per_px}});
        }
        marks_.feed_direction_deg = named.feed_direction_deg ? named.feed_direction_deg : p.feed_direction_deg;
    }

    ImageMarks found(const Progress& progress)
    {
        if (std::min(pixels_.columns, pixels_.rows) < leastSide_px)
            throw Error(errors::pictureTooSmall, {{"path", marks_.path},
                                                  {"width", std::int64_t{pixels_.columns}},
                                                  {"height", std::int64_t{pixels_.rows}},
                                                  {"minimum", std::int64_t{leastSide_px}}});
        marks_.saturated_percent = saturated_percent(pixels_);
        if (marks_.saturated_percent > saturatedMost_percent)
            note(notes::pictureSaturated, {{"percent", marks_.saturated_percent}});
        checkResolution(progress.part(0, 0.1));
        loadPixels();
        unroll(progress.part(0.1, 0.3));
        const Grid flat = flattened(picture_, progress.part(0.3, 0.4));
        lines_ = findLines(flat, search(), progress.part(0.4, 0.95));
        marks_.threshold = lines_.threshold;
        marks_.largest_significance = lines_.largest_significance;
        if (lines_.feed) {
            describeFeed();
            if (lines_.chatter) describeChatter(flat);
        } else if (marks_.mm_per_px_source == ScaleSource::None) {
            note(notes::scaleUnknown, {});
        }
        if (!marks_.chatter_marks) lines_.chatter.reset();  // nor is it drawn
        draw(flat);
        return std::move(marks_);
    }

private:
    void note(const NoteCode& code, Values values)
    {
        values.insert(values.begin(), {"path", marks_.path});
        notes_.push_back({code, std::move(values)});
    }

    std::optional<double> feed_px() const
    {
        if (!p_.feed_mm_rev || !marks_.mm_per_px) return std::nullopt;
        return *p_.feed_mm_rev / (*marks_.mm_per_px * shrunk_);
    }

    LineSearch search() const
    {
        LineSearch search{std::nullopt, p_.alpha, leastChatter, {}, {}, false};
        if (const auto px = feed_px()) search.feed_cycles_per_px = 1 / *px;
        if (marks_.feed_direction_deg) search.direction_deg = *marks_.feed_direction_deg - turned_deg_;
        if (marks_.unrolled) search.old_grid = turned({1, 0}, -turned_deg_);
        return search;
    }

    /// Refuses fewer than four pixels per feed; below two, feed marks appear as aliases.
    void checkResolution(const Progress& progress)
    {
        const auto px = feed_px();
        if (!px) return;
        if (*px < leastFeed_px) {
            Values values{{"path", marks_.path},
                          {"feed_mm_rev", *p_.feed_mm_rev},
                          {"found_px", *px},
                          {"needed_px", leastFeed_px},
                          {"needed_mm_per_px", *p_.feed_mm_rev / leastFeed_px}};
            const auto alias = aliasSeen(1 / *px, progress);
            if (!alias) throw Error(errors::feedNotResolved, values);
            set(values, "alias_px", 1 / *alias);
            throw Error(errors::feedAliased, values);
        }
        if (*px < wantedFeed_px) note(notes::feedFewPixels, {{"found_px", *px}, {"wanted_px", wantedFeed_px}});
    }

    /// The alias of a feed above half a cycle per pixel, if significant; none up to half a cycle.
    std::optional<double> aliasSeen(double feed, const Progress& progress) const
    {
        constexpr double nyquist = 0.5, least = 0.01;
        if (feed <= nyquist) return std::nullopt;
        const double alias = length(folded(feed * turned({1, 0}, marks_.feed_direction_deg.value_or(0))));
        if (alias < least) return std::nullopt;
        const Grid flat = flattened(pixels_.middle(searchedForAlias_px).copy());
        LineSearch search{alias, p_.alpha, leastChatter, {}, {}, true};
        const auto found = findLines(flat, search, progress.part(0, 0.5)).feed;
        if (!found || std::abs(length(found->frequency) / alias - 1) > feedTolerance) return std::nullopt;
        search.feed_cycles_per_px.reset();
        const auto strongest = findLines(flat, search, progress.part(0.5, 1)).feed;
        const bool is_strong = strongest && found->amplitude >= 0.5 * strongest->amplitude;
        return is_strong ? std::optional(length(found->frequency)) : std::nullopt;
    }

    /// Reads the picture at the reduction needed.
    void loadPixels()
    {
        const double pixels = double(pixels_.columns) * pixels_.rows;
        const auto px = feed_px();
        const double factor = std::min(std::sqrt(pixels / fewPixels), px ? *px / feedKept_px : mostUnknownReduction);
        picture_ = pixels <= fewPixels || factor < 1.05 ? pixels_.copy() : reduced(pixels_, factor);
        shrunk_ = double(pixels_.columns) / picture_.columns;
    }

    /// Scale from the pitch of the marks, which equals the feed also on a curved part, as the axis is not
    /// foreshortened.
    void setScaleFromFeed(const Progress& progress)
    {
        LineSearch wanted = search();
        wanted.feed_only = true;
        if (const auto feed = findLines(flattened(picture_), wanted, progress).feed)
            marks_.mm_per_px = *p_.feed_mm_rev * length(feed->frequency) / shrunk_;
    }

    /// Marks the picture as curved: the number of waves per revolution is undetermined.
    void markCurved(const NoteCode& code)
    {
        marks_.curved = true;
        note(code, {});
    }

    void unroll(const Progress& progress)
    {
        const Unrolling unrolling = unrollingOf(p_);
        if (!p_.diameter_mm) return;
        if (marks_.mm_per_px_source == ScaleSource::Feed) setScaleFromFeed(progress.part(0, 0.5));
        if (!marks_.mm_per_px) return;  // the number of waves per revolution is unknown
        const double diameter_px = *p_.diameter_mm / (*marks_.mm_per_px * shrunk_);
        if (std::max(picture_.columns, picture_.rows) <= curvedField * diameter_px) return;
        const PictureLines lines = [&] {
            LineSearch wanted = search();
            wanted.feed_only = true;
            return findLines(flattened(picture_), wanted, progress.part(0.5, 1));
        }();
        Vector axis = turned({1, 0}, marks_.feed_direction_deg.value_or(0));
        if (lines.feed)
            axis = axisDirection(towardFeed(lines.feed->frequency, marks_.feed_direction_deg), p_.feed_mm_rev,
                                 p_.diameter_mm, p_.cut_direction);
        else if (!marks_.feed_direction_deg)
            return markCurved(notes::axisUnknown);
        const Vector across = turned(axis, 90);
        const double field = std::abs(across.x) * picture_.columns + std::abs(across.y) * picture_.rows;
        if (field <= curvedField * diameter_px) return;
        if (!unrolling.wanted) return markCurved(notes::curvatureIgnored);
        Cylinder cylinder{0.5 * diameter_px, angle_deg(axis), axisPoint(axis), {}};
        if (unrolling.distance_mm) cylinder.distance_px = *unrolling.distance_mm / (*marks_.mm_per_px * shrunk_);
        Grid flat = unrolled(picture_, cylinder);
        if (std::min(flat.columns, flat.rows) < leastSide_px) return markCurved(notes::curvatureIgnored);
        picture_ = std::move(flat);
        turned_deg_ = cylinder.axis_deg;
        marks_.unrolled = true;
        note(notes::pictureUnrolled, {{"span_deg", picture_.rows / cylinder.radius_px * 180 / std::numbers::pi}});
    }

    /// A point of the axis in the current picture.
    Vector axisPoint(Vector axis) const
    {
        Vector point{0.5 * (picture_.columns - 1), 0.5 * (picture_.rows - 1)};
        if (!p_.axis_px) return point;
        const bool is_level = std::abs(axis.x) >= std::abs(axis.y);
        const double corner = roi_ ? (is_level ? roi_->y : roi_->x) : 0;
        (is_level ? point.y : point.x) = (*p_.axis_px - corner) / shrunk_ - 0.5;
        return point;
    }

    void describeFeed()
    {
        const FeedComb& comb = *lines_.feed;
        FeedMarks feed;
        feed.pitch_px = shrunk_ / length(comb.frequency);
        feed.direction_deg = angleModulo180(angle_deg(comb.frequency) + turned_deg_);
        feed.significance = comb.significance;
        feed.amplitude = comb.amplitude;
        feed.regularity = lines_.feed_weight.regularity;
        feed.share_percent = 100 * lines_.feed_weight.share;
        const bool from_feed = marks_.mm_per_px_source == ScaleSource::Feed;
        if (from_feed) {
            marks_.mm_per_px = *p_.feed_mm_rev / feed.pitch_px;
            note(notes::scaleFromFeed, {});
            if (feed.pitch_px < wantedFeed_px)
                note(notes::feedFewPixels, {{"found_px", feed.pitch_px}, {"wanted_px", wantedFeed_px}});
        }
        if (marks_.mm_per_px) feed.pitch_mm = feed.pitch_px * *marks_.mm_per_px;
        if (marks_.mm_per_px_source == ScaleSource::None) note(notes::scaleUnknown, {});
        if (feed.pitch_mm && p_.feed_mm_rev && !from_feed) {
            feed.pitch_error_percent = 100 * (*feed.pitch_mm / *p_.feed_mm_rev - 1);
            if (std::abs(*feed.pitch_error_percent) > pitchMost_percent)
                note(notes::pitchDiffersFromFeed, {{"pitch_mm", *feed.pitch_mm}, {"feed_mm_rev", *p_.feed_mm_rev}});
        }
        marks_.feed_marks = feed;
        marks_.verdict = MarksVerdict::FeedMarks;
        marks_.detection_limit_relative_to_feed = lines_.least_chatter / comb.amplitude;
    }

    void describeSecondFeed()
    {
        const FeedComb& comb = *lines_.second_feed;
        FeedMarks second;
        second.pitch_px = shrunk_ / length(comb.frequency);
        second.direction_deg = angleModulo180(angle_deg(comb.frequency) + turned_deg_);
        second.significance = comb.significance;
        second.amplitude = comb.amplitude;
        if (marks_.mm_per_px) second.pitch_mm = second.pitch_px * *marks_.mm_per_px;
        const FeedMarks& first = *marks_.feed_marks;
        const bool in_mm = first.pitch_mm && second.pitch_mm;
        note(notes::twoFeeds, {{"pitch", in_mm ? *first.pitch_mm : first.pitch_px},
                               {"second_pitch", in_mm ? *second.pitch_mm : second.pitch_px},
                               {"unit", std::string(in_mm ? "mm" : "px")}});
        marks_.second_feed_marks = second;
    }

    void describeChatter(const Grid& flat)
    {
        CutFacts facts;
        facts.feed_mm_rev = p_.feed_mm_rev;
        facts.diameter_mm = p_.diameter_mm;
        if (p_.diameter_mm && marks_.mm_per_px) facts.diameter_px = *p_.diameter_mm / (*marks_.mm_per_px * shrunk_);
        facts.speed_rpm = marks_.speed_rpm;
        if (marks_.feed_direction_deg) facts.feed_direction_deg = *marks_.feed_direction_deg - turned_deg_;
        facts.cut = p_.cut_direction;
        facts.expect_hz = p_.expect_hz;
        facts.speed_uncertainty = p_.speed_uncertainty_percent / 100;
        facts.unrolled = marks_.unrolled;
        facts.curved = marks_.curved;
        facts.scale_checked = marks_.mm_per_px_source != ScaleSource::Feed || marks_.feed_direction_deg;
        facts.columns = flat.columns;
        facts.rows = flat.rows;
        if (marks_.feed_marks->pitch_error_percent) facts.scale_error = *marks_.feed_marks->pitch_error_percent / 100;
        Notes remarks;
        ChatterMarks chatter = readChatter(*lines_.chatter, *lines_.feed, facts, marks_.path, remarks);
        const bool is_slow = chatter.waves_measured && isSlow(chatter);
        // a second feed reads as f / f₂ - 1 waves
        if (lines_.second_feed && (is_slow || !chatter.waves_measured)) return describeSecondFeed();
        if (is_slow) {
            marks_.verdict = MarksVerdict::Undecided;
            return note(notes::lessThanOneWave, {{"waves", *chatter.waves_measured + chatter.nu},
                                                 {"least", std::max(0.0, *chatter.slowest_waves)}});
        }
        notes_.insert(notes_.end(), remarks.begin(), remarks.end());
        chatter.regularity = lines_.chatter_weight.regularity;
        chatter.share_percent = 100 * lines_.chatter_weight.share;
        marks_.chatter_marks = chatter;
        marks_.verdict = MarksVerdict::ChatterMarks;
    }

    void draw(const Grid& flat)
    {
        SurfaceView& view = marks_.view;
        view.px_per_px = shrunk_;
        view.turned_deg = turned_deg_;
        view.picture = std::move(picture_);
        view.flat = flat;
        drawSpectrum(view, lines_);
    }

    const SurfaceParameters& p_;
    Notes& notes_;
    const Region* roi_;
    GridView pixels_;        ///< evaluated region of the file
    Grid picture_;           ///< reduced and unrolled picture
    double shrunk_ = 1;      ///< file pixels per pixel of picture_
    double turned_deg_ = 0;  ///< rotation by unrolling, subtracted from directions
    PictureLines lines_;
    ImageMarks marks_;
};

}  // namespace

SurfaceResult findSurfaceMarks(const std::vector<NamedImage>& images, const SurfaceParameters& parameters,
                               const Progress& progress)
{
    checkTogether(parameters, images.size());
    SurfaceResult result;
    result.parameters = parameters;
    const double share = 1.0 / static_cast<double>(std::max<std::size_t>(1, images.size()));
    for (std::size_t i = 0; i < images.size(); ++i)
        result.images.push_back(
            Evaluation(images[i], parameters, i, images.size(), result.notes)
                .found(progress.part(static_cast<double>(i) * share, static_cast<double>(i + 1) * share)));
    if (images.size() > 1) result.comparison = compared(result.images, result.notes);
    return result;
}

}  // namespace lathelier::surface
