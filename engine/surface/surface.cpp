#include "engine/surface/surface.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <tuple>

#include "engine/core/core_codes.h"
#include "engine/surface/chatter_reading.h"
#include "engine/surface/picture_comparison.h"
#include "engine/surface/picture_lines.h"
#include "engine/surface/preparation.h"
#include "engine/surface/surface_codes.h"

namespace lathelier::surface {
namespace {

constexpr double fewPixels = 2e6;           // a picture is not made smaller than this…
constexpr double feedKept_px = 8;           // …nor so that a feed has fewer pixels
constexpr double mostUnknownReduction = 2;  // where the feed in pixels is not known
constexpr double saturatedMost_percent = 2;
constexpr double pitchMost_percent = 3;

[[noreturn]] void refuseValue(const char* parameter, Value found, Text expected)
{
    throw Error(errors::valueNotUnderstood,
                {{"parameter", std::string(parameter)}, {"found", std::move(found)}, {"expected", expected}});
}

std::optional<double> positive(std::string_view typed)
{
    double number = 0;
    const auto [stop, problem] = std::from_chars(typed.data(), typed.data() + typed.size(), number);
    if (problem != std::errc() || stop != typed.data() + typed.size() || !std::isfinite(number) || number <= 0)
        return std::nullopt;
    return number;
}

/// A list with one value for each picture, or one for all.
template <class T>
const T* ofPicture(const std::vector<T>& list, std::size_t index, std::size_t pictures, const char* parameter)
{
    if (list.empty()) return nullptr;
    if (list.size() != 1 && list.size() != pictures)
        refuseValue(parameter, static_cast<std::int64_t>(list.size()),
                    LT_TEXT("Engine", "one for all pictures, or one for each"));
    return &list[list.size() == 1 ? 0 : index];
}

/// How the camera sees the cylinder.
struct Unrolling {
    bool wanted = true;
    std::optional<double> distance_mm;
};

Unrolling unrollingOf(const SurfaceParameters& p)
{
    if (p.unroll == "auto" || p.unroll == "far") return {};
    if (p.unroll == "no") return {false, {}};
    const auto distance = positive(p.unroll);
    if (!distance || (p.diameter_mm && *distance <= 0.5 * *p.diameter_mm))
        refuseValue(
            "unroll", p.unroll,
            LT_TEXT("Engine", "auto, no, far, or the camera's distance from the axis in mm, beyond the surface"));
    return {true, distance};
}

/// The scale that is given, in mm per pixel of the file.
std::pair<std::optional<double>, ScaleSource> givenScale(const SurfaceParameters& p)
{
    const int given = (p.mm_per_px ? 1 : 0) + (p.scale_px_mm.empty() ? 0 : 1) + (p.scale_from_feed ? 1 : 0);
    if (given > 1) refuseValue("mm_per_px", Value(), LT_TEXT("Engine", "one scale only"));
    if (p.scale_from_feed && !p.feed_mm_rev)
        refuseValue("scale_from_feed", Value(true), LT_TEXT("Engine", "a feed beside it"));
    if (p.mm_per_px) return {p.mm_per_px, ScaleSource::Given};
    if (p.scale_px_mm.empty()) return {std::nullopt, ScaleSource::None};
    const std::size_t colon = std::min(p.scale_px_mm.find(':'), p.scale_px_mm.size());
    const auto px = positive(std::string_view(p.scale_px_mm).substr(0, colon));
    const auto mm = positive(std::string_view(p.scale_px_mm).substr(std::min(colon + 1, p.scale_px_mm.size())));
    if (!px || !mm) refuseValue("scale_px_mm", p.scale_px_mm, LT_TEXT("Engine", "PX:MM, such as 250:1"));
    return {*mm / *px, ScaleSource::ScaleBar};
}

void checkTogether(const SurfaceParameters& p, std::size_t pictures)
{
    givenScale(p);
    unrollingOf(p);
    ofPicture(p.speed_rpm, 0, pictures, "speed_rpm");
    ofPicture(p.roi, 0, pictures, "roi");
}

Grid part(const io::Image& image, const Region* roi)
{
    if (!roi) {
        Grid whole;
        whole.columns = image.width;
        whole.rows = image.height;
        whole.values = image.grey;
        return whole;
    }
    const bool inside = roi->x >= 0 && roi->y >= 0 && roi->width >= 1 && roi->height >= 1 &&
                        roi->x + roi->width <= image.width && roi->y + roi->height <= image.height;
    if (!inside)
        throw Error(errors::regionOutside, {{"found", std::vector<double>{roi->x, roi->y, roi->width, roi->height}},
                                            {"width", std::int64_t{image.width}},
                                            {"height", std::int64_t{image.height}}});
    Grid grid(static_cast<int>(roi->width), static_cast<int>(roi->height));
    for (int y = 0; y < grid.rows; ++y)
        for (int x = 0; x < grid.columns; ++x)
            grid.row(y)[x] = image.at(static_cast<int>(roi->x) + x, static_cast<int>(roi->y) + y);
    return grid;
}

double saturated_percent(const Grid& picture)
{
    const auto count =
        std::count_if(picture.values.begin(), picture.values.end(), [](float v) { return v <= 0 || v >= 0.9999F; });
    return 100.0 * static_cast<double>(count) / static_cast<double>(picture.values.size());
}

/// One picture on its way.
class Evaluation {
public:
    Evaluation(const NamedImage& named, const SurfaceParameters& p, std::size_t index, std::size_t pictures,
               Notes& notes)
        : p_(p), notes_(notes), roi_(ofPicture(p.roi, index, pictures, "roi")), picture_(part(named.image, roi_))
    {
        marks_.path = named.path;
        marks_.width = named.image.width;
        marks_.height = named.image.height;
        marks_.bits = named.image.bits;
        marks_.orientation_applied = named.image.orientation;
        if (const CutSpeed* speed = ofPicture(p.speed_rpm, index, pictures, "speed_rpm")) marks_.speed_rpm = speed->rpm;
        std::tie(marks_.mm_per_px, marks_.mm_per_px_source) = givenScale(p);
        if (p.scale_from_feed) marks_.mm_per_px_source = ScaleSource::Feed;
    }

    ImageMarks found(const Progress& progress)
    {
        if (std::min(picture_.columns, picture_.rows) < leastSide_px)
            throw Error(errors::pictureTooSmall, {{"path", marks_.path},
                                                  {"width", std::int64_t{picture_.columns}},
                                                  {"height", std::int64_t{picture_.rows}},
                                                  {"minimum", std::int64_t{leastSide_px}}});
        marks_.saturated_percent = saturated_percent(picture_);
        if (marks_.saturated_percent > saturatedMost_percent)
            note(notes::pictureSaturated, {{"percent", marks_.saturated_percent}});
        checkResolution(progress.part(0, 0.1));
        reduce();
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
        LineSearch search{std::nullopt, p_.alpha, leastChatter, {}, false};
        if (const auto px = feed_px()) search.feed_cycles_per_px = 1 / *px;
        if (marks_.unrolled) search.old_grid = turned({1, 0}, -turned_deg_);
        return search;
    }

    /// Fewer than four pixels for a feed: what is found is an alias, if anything.
    void checkResolution(const Progress& progress)
    {
        const auto px = feed_px();
        if (!px) return;
        if (*px < leastFeed_px) {
            const PictureLines lines =
                findLines(flattened(picture_), {std::nullopt, p_.alpha, leastChatter, {}, true}, progress);
            Values values{{"path", marks_.path},
                          {"feed_mm_rev", *p_.feed_mm_rev},
                          {"found_px", *px},
                          {"needed_px", leastFeed_px},
                          {"needed_mm_per_px", *p_.feed_mm_rev / leastFeed_px}};
            if (!lines.feed || !isAlias(length(lines.feed->frequency), 1 / *px))
                throw Error(errors::feedNotResolved, values);
            set(values, "alias_px", 1 / length(lines.feed->frequency));
            throw Error(errors::feedAliased, values);
        }
        if (*px < wantedFeed_px) note(notes::feedFewPixels, {{"found_px", *px}, {"wanted_px", wantedFeed_px}});
    }

    static bool isAlias(double found, double feed)
    {
        const double alias = std::abs(feed - std::round(feed));
        return std::abs(found / alias - 1) < feedTolerance;
    }

    void reduce()
    {
        const double pixels = double(picture_.columns) * picture_.rows;
        if (pixels <= fewPixels) return;
        const auto px = feed_px();
        const double factor = std::min(std::sqrt(pixels / fewPixels), px ? *px / feedKept_px : mostUnknownReduction);
        if (factor < 1.05) return;
        const int before = picture_.columns;
        picture_ = reduced(picture_, factor);
        shrunk_ = double(before) / picture_.columns;
    }

    void unroll(const Progress& progress)
    {
        const Unrolling unrolling = unrollingOf(p_);
        if (!p_.diameter_mm || !marks_.mm_per_px) return;
        const double diameter_px = *p_.diameter_mm / (*marks_.mm_per_px * shrunk_);
        if (std::max(picture_.columns, picture_.rows) <= curvedField * diameter_px) return;
        const PictureLines lines = [&] {
            LineSearch wanted = search();
            wanted.feed_only = true;
            return findLines(flattened(picture_), wanted, progress);
        }();
        Vector axis = turned({1, 0}, p_.feed_direction_deg.value_or(0));
        if (lines.feed)
            axis = axisDirection(towardFeed(lines.feed->frequency, p_.feed_direction_deg), p_.feed_mm_rev,
                                 p_.diameter_mm, p_.cut_direction);
        else if (!p_.feed_direction_deg)
            return;
        const Vector across = turned(axis, 90);
        const double field = std::abs(across.x) * picture_.columns + std::abs(across.y) * picture_.rows;
        if (field <= curvedField * diameter_px) return;
        if (!unrolling.wanted) {
            note(notes::curvatureIgnored, {});
            return;
        }
        Cylinder cylinder{0.5 * diameter_px, angle_deg(axis), axisPoint(axis), {}};
        if (unrolling.distance_mm) cylinder.distance_px = *unrolling.distance_mm / (*marks_.mm_per_px * shrunk_);
        Grid flat = unrolled(picture_, cylinder);
        if (std::min(flat.columns, flat.rows) < leastSide_px) return;
        picture_ = std::move(flat);
        turned_deg_ = cylinder.axis_deg;
        marks_.unrolled = true;
        note(notes::pictureUnrolled, {{"span_deg", picture_.rows / cylinder.radius_px * 180 / std::numbers::pi}});
    }

    /// A point of the axis in the picture as it is now.
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
        if (p_.scale_from_feed) {
            marks_.mm_per_px = *p_.feed_mm_rev / feed.pitch_px;
            note(notes::scaleFromFeed, {});
        }
        if (marks_.mm_per_px) feed.pitch_mm = feed.pitch_px * *marks_.mm_per_px;
        if (marks_.mm_per_px_source == ScaleSource::None) note(notes::scaleUnknown, {});
        if (feed.pitch_mm && p_.feed_mm_rev && !p_.scale_from_feed) {
            feed.pitch_error_percent = 100 * (*feed.pitch_mm / *p_.feed_mm_rev - 1);
            if (std::abs(*feed.pitch_error_percent) > pitchMost_percent)
                note(notes::pitchDiffersFromFeed, {{"pitch_mm", *feed.pitch_mm}, {"feed_mm_rev", *p_.feed_mm_rev}});
        }
        marks_.feed_marks = feed;
        marks_.verdict = MarksVerdict::FeedMarks;
        marks_.detection_limit_relative_to_feed = lines_.least_chatter / comb.amplitude;
    }

    void describeChatter(const Grid& flat)
    {
        CutFacts facts;
        facts.feed_mm_rev = p_.feed_mm_rev;
        facts.diameter_mm = p_.diameter_mm;
        if (p_.diameter_mm && marks_.mm_per_px) facts.diameter_px = *p_.diameter_mm / (*marks_.mm_per_px * shrunk_);
        facts.speed_rpm = marks_.speed_rpm;
        if (p_.feed_direction_deg) facts.feed_direction_deg = *p_.feed_direction_deg - turned_deg_;
        facts.cut = p_.cut_direction;
        facts.expect_hz = p_.expect_hz;
        facts.speed_uncertainty = p_.speed_uncertainty_percent / 100;
        facts.unrolled = marks_.unrolled;
        facts.columns = flat.columns;
        facts.rows = flat.rows;
        ChatterMarks chatter = readChatter(*lines_.chatter, *lines_.feed, facts, marks_.path, notes_);
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
    Grid picture_;
    double shrunk_ = 1;      ///< pixels of the file in one of the picture
    double turned_deg_ = 0;  ///< taken off directions by unrolling
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
