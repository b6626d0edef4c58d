#include "engine/features/stretches/stretch_ends.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/core/statistics.h"
#include "engine/features/stretches/stretch_limits.h"

namespace lathelier::features {
namespace {

/// A point near an end: its distance beyond the end that was known before, and whether it lies on the shape.
struct NearEnd {
    double beyond_mm = 0, r_mm = 0;
    double shape_mm = 0;  ///< radius of the shape there
    bool is_on = false;
    bool is_below = false, is_high = false;  ///< where the shape is a gap or a face, a crest or a corner
    bool is_level = false;                   ///< where it reaches its level: there a chamfer begins
};

struct ShareOn {
    double count = 0, on = 0;

    void add(bool is_on)
    {
        count += 1;
        on += is_on ? 1 : 0;
    }
    /// Never quite none and all.
    double share() const { return (on + 0.5) / (count + 1); }
};

std::vector<NearEnd> pointsNear(const MeridianCloud& cloud, const NotRoundStretch& stretch, double sigma_mm,
                                double end_mm, double sign, double before_mm)
{
    const double limit = stretchProof.on_sigmas * sigma_mm + stretchProof.on_mm;
    const SectionShape& shape = stretch.shape;
    const double depth = shape.pitch_mm.empty() && shape.face_mm > 0 ? shape.level_mm - shape.face_mm : 0;
    const double high = shape.level_mm - std::max(limit, stretchEnds.corner_share * depth);
    std::vector<NearEnd> near;
    for (std::size_t i = 0; i < cloud.z_mm.size(); ++i) {
        const double beyond = sign * (static_cast<double>(cloud.z_mm[i]) - end_mm);
        if (beyond < -before_mm || beyond > stretchEnds.extend_mm) continue;
        const double radius =
            stretch.shape.radiusAt_mm(static_cast<double>(cloud.turn[i]), static_cast<double>(cloud.z_mm[i]));
        if (std::isnan(radius)) continue;
        const double r = static_cast<double>(cloud.r_mm[i]);
        near.push_back({beyond, r, radius, std::abs(r - radius) < limit, isBelowRound(stretch.shape, radius, sigma_mm),
                        radius > high, radius > shape.level_mm - limit});
    }
    std::sort(near.begin(), near.end(), [](const NearEnd& a, const NearEnd& b) { return a.beyond_mm < b.beyond_mm; });
    return near;
}

/// How far beyond the end of its sections the points go on to lie on the shape, in whole steps; those on crests and
/// corners as well, which a chamfer cuts.
double growthOf(const MeridianCloud& cloud, const NotRoundStretch& stretch, double sigma_mm, double end_mm, double sign)
{
    const double limit = stretchProof.on_sigmas * sigma_mm + stretchProof.on_mm;
    struct Step {
        ShareOn all, high;
    };
    std::vector<Step> steps;
    for (std::size_t i = 0; i < cloud.z_mm.size(); ++i) {
        const double z = static_cast<double>(cloud.z_mm[i]), beyond = sign * (z - end_mm);
        const auto step = static_cast<std::size_t>(std::max(0.0, beyond) / stretchEnds.grow_step_mm);
        if (beyond < 0 || step >= stretchEnds.most_grow_steps) continue;
        const double radius = stretch.shape.radiusAt_mm(static_cast<double>(cloud.turn[i]), z);
        if (std::isnan(radius)) continue;
        if (step >= steps.size()) steps.resize(step + 1);
        const bool is_on = std::abs(static_cast<double>(cloud.r_mm[i]) - radius) < limit;
        steps[step].all.add(is_on);
        if (radius > stretch.shape.level_mm - limit) steps[step].high.add(is_on);
    }
    const auto end = std::find_if(steps.begin(), steps.end(), [](const Step& step) {
        return step.all.count < static_cast<double>(stretchEnds.least_points) ||
               step.all.on < stretchEnds.absorb_share * step.all.count ||
               step.high.on < stretchEnds.crest_share * step.high.count;
    });
    return stretchEnds.grow_step_mm * static_cast<double>(end - steps.begin());
}

/// How far beyond the known end, at most `reach_mm` from it, the shape ends; nothing where the points do not say.
std::optional<double> changeOf(const std::vector<NearEnd>& near, double reach_mm)
{
    ShareOn inside, outside;
    for (const NearEnd& point : near) {
        if (point.beyond_mm < -stretchEnds.beyond_mm) inside.add(point.is_on);
        if (point.beyond_mm > stretchEnds.beyond_mm && point.beyond_mm < stretchEnds.reach_mm) outside.add(point.is_on);
    }
    // Beyond the end of the data, a chamfer may be before it.
    const double beyond = outside.count < static_cast<double>(stretchEnds.least_points)
                              ? stretchEnds.unseen_share * inside.share()
                              : outside.share();
    const double of_on = std::log(inside.share() / beyond), of_off = std::log((1 - inside.share()) / (1 - beyond));
    if (!(of_on > 0)) return std::nullopt;
    double sum = 0, most = 0, place = -reach_mm;
    for (std::size_t i = 0; i < near.size(); ++i) {
        if (near[i].beyond_mm < -reach_mm) continue;
        if (near[i].beyond_mm > reach_mm) break;
        sum += near[i].is_on ? of_on : of_off;
        if (sum <= most) continue;
        most = sum;
        place = i + 1 < near.size() ? (near[i].beyond_mm + near[i + 1].beyond_mm) / 2 : near[i].beyond_mm;
    }
    return place;
}

/// The same of crests or corners alone, which a chamfer cuts long before the most of the shape; nothing where they go
/// on.
std::optional<double> changeOfCrests(const std::vector<NearEnd>& near, double reach_mm)
{
    std::vector<NearEnd> crests;
    ShareOn outside;
    for (const NearEnd& point : near) {
        if (!point.is_level) continue;
        crests.push_back(point);
        if (point.beyond_mm > stretchEnds.beyond_mm && point.beyond_mm < stretchEnds.reach_mm) outside.add(point.is_on);
    }
    if (outside.share() > stretchEnds.unseen_share) return std::nullopt;
    return changeOf(crests, reach_mm);
}

/// Where the section begins to differ, beyond the known end.
double endOfSection(const std::vector<NearEnd>& near, double reach_mm, double before_mm, MarkKind kind)
{
    const double change = changeOf(near, reach_mm).value_or(0);
    if (kind == MarkKind::Eccentric || kind == MarkKind::Thread) return change;
    const std::optional<double> crests = changeOfCrests(near, std::min(before_mm, stretchEnds.crest_reach_mm));
    return crests && *crests < change - stretchEnds.earlier_mm ? *crests : change;
}

/// How far beyond `from_mm` gaps or faces go on: there they lie below what is beside them.
double extensionOf(const std::vector<NearEnd>& near, double from_mm, double least_mm)
{
    double reached = from_mm;
    for (double step = from_mm; step < stretchEnds.extend_mm; step += stretchEnds.extend_step_mm) {
        std::vector<double> below, high;
        double last = reached;
        for (const NearEnd& point : near) {
            if (point.beyond_mm < step || point.beyond_mm > step + stretchEnds.extend_step_mm) continue;
            if (point.is_below) below.push_back(point.r_mm);
            if (point.is_high) high.push_back(point.r_mm);
            if (point.is_below) last = point.beyond_mm;
        }
        if (std::min(below.size(), high.size()) < stretchEnds.least_step_points ||
            !(upperMedianInPlace(below) < upperMedianInPlace(high) - least_mm))
            break;
        reached = last;
    }
    return reached;
}

/// A line of radii over the distance from the known end, by least squares; nothing where that is one place.
struct RadiusLine {
    double radius_mm = 0, slope = 0;

    double at_mm(double beyond_mm) const { return radius_mm + slope * beyond_mm; }
    double offOf(const NearEnd& point) const { return point.r_mm - at_mm(point.beyond_mm); }
    /// Where a line that falls has come down to a radius.
    std::optional<double> placeOf(double level_mm) const
    {
        return slope < -stretchEnds.least_slope ? std::optional((level_mm - radius_mm) / slope) : std::nullopt;
    }
};

std::optional<RadiusLine> lineThrough(const std::vector<NearEnd>& points)
{
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (const NearEnd& point : points) {
        n += 1;
        sx += point.beyond_mm;
        sy += point.r_mm;
        sxx += point.beyond_mm * point.beyond_mm;
        sxy += point.beyond_mm * point.r_mm;
    }
    const double spread = n * sxx - sx * sx;
    if (!(spread > 0)) return std::nullopt;
    const double slope = (n * sxy - sx * sy) / spread;
    return RadiusLine{(sy - slope * sx) / n, slope};
}

/// The middle of a share of the points: medians of distance and radius.
NearEnd middleOf(const std::vector<NearEnd>& points, std::size_t from, std::size_t to)
{
    std::vector<double> beyond, radii;
    for (std::size_t i = from; i < to; ++i) {
        beyond.push_back(points[i].beyond_mm);
        radii.push_back(points[i].r_mm);
    }
    return {upperMedianInPlace(beyond), upperMedianInPlace(radii)};
}

/// Smallest radius of a shape: of its faces or roots.
double lowest_mm(const SectionShape& shape)
{
    double lowest = shape.pitch_mm.empty() ? shape.face_mm : shape.level_mm;
    for (const double radius : shape.pitch_mm) lowest = radius < lowest ? radius : lowest;
    return lowest;
}

/// The round that cuts a stretch beyond the end of its section, and where it begins and leaves nothing of the shape.
class CutBeyond {
public:
    CutBeyond(const std::vector<NearEnd>& near, const SectionShape& shape, double sigma_mm, double change_mm)
        : near_(near),
          shape_(shape),
          limit_mm_(stretchProof.on_sigmas * sigma_mm + stretchProof.on_mm),
          on_mm_(stretchEnds.edge_sigmas * sigma_mm + stretchEnds.edge_off_mm),
          from_mm_(change_mm),
          to_mm_(extensionOf(near, change_mm, stretchEnds.low_sigmas * sigma_mm + stretchEnds.low_mm)),
          line_{shape.level_mm, 0}
    {
        if (const std::optional<RadiusLine> first = firstLine()) follow(*first);
    }

    double from_mm() const { return from_mm_; }
    double to_mm() const { return to_mm_; }
    const RadiusLine& line() const { return line_; }

    /// Do nearly all points from shortly before the end of the section on lie on the shape or on the round? Of a thread
    /// those on flanks are not judged, which are most of its points.
    bool isExplained() const
    {
        if (isThread()) return false;
        ShareOn explained;
        for (const NearEnd& point : near_)
            if (point.beyond_mm > from_mm_ - stretchEnds.beyond_mm &&
                point.beyond_mm < from_mm_ + stretchEnds.at_end_mm)
                explained.add(point.is_on || std::abs(line_.offOf(point)) < on_mm_);
        return explained.share() > stretchEnds.absorb_share;
    }

private:
    bool isThread() const { return shape_.kind == MarkKind::Thread; }

    bool isBeyond(const NearEnd& point) const
    {
        return point.is_high && point.beyond_mm > from_mm_ && point.beyond_mm <= to_mm_;
    }

    /// Through the medians of the halves of what is cut: hits of the face at the end are few.
    std::optional<RadiusLine> firstLine() const
    {
        std::vector<NearEnd> cut;
        for (const NearEnd& point : near_)
            if (isBeyond(point) && !point.is_on) cut.push_back(point);
        if (cut.size() < stretchEnds.least_points) return std::nullopt;
        const std::size_t half = cut.size() / 2;
        return lineThrough({middleOf(cut, 0, half), middleOf(cut, half, cut.size())});
    }

    /// Through the points near the line where it lies below the shape; it begins at the level and ends at the lowest.
    void follow(RadiusLine line)
    {
        for (int round = 0; round < stretchEnds.line_rounds; ++round) {
            const std::optional<double> last = line.placeOf(lowest_mm(shape_));
            if (last && !isThread()) to_mm_ = std::max(to_mm_, std::min(*last, near_.back().beyond_mm));
            std::vector<NearEnd> on;
            for (const NearEnd& point : near_)
                if (isBeyond(point) && line.at_mm(point.beyond_mm) < point.shape_mm - limit_mm_ &&
                    std::abs(line.offOf(point)) < on_mm_)
                    on.push_back(point);
            const std::optional<RadiusLine> next = lineThrough(on);
            if (!next) return;
            line = *next;
        }
        line_ = line;
        const std::optional<double> begin = line.placeOf(shape_.level_mm);
        if (begin && !isThread() && std::abs(*begin - from_mm_) < stretchEnds.begin_mm) from_mm_ = *begin;
    }

    const std::vector<NearEnd>& near_;
    const SectionShape& shape_;
    double limit_mm_, on_mm_;
    double from_mm_, to_mm_;
    RadiusLine line_;
};

}  // namespace

bool isBelowRound(const SectionShape& shape, double radius_mm, double sigma_mm)
{
    return shape.kind != MarkKind::Eccentric &&
           radius_mm < shape.level_mm - stretchEnds.low_sigmas * sigma_mm - stretchEnds.low_mm;
}

void placeStretchEnds(const MeridianCloud& cloud, double sigma_mm, NotRoundStretch& stretch)
{
    const MarkKind kind = stretch.shape.kind;
    const double reach_mm = kind == MarkKind::Thread ? stretchEnds.helix_reach_mm : stretchEnds.reach_mm;
    const double before_mm = std::max(reach_mm, (stretch.to_mm - stretch.from_mm) / 3);
    const auto place = [&](double& end_mm, double sign, RoundBeyond& beyond) {
        end_mm += sign * growthOf(cloud, stretch, sigma_mm, end_mm, sign);
        const std::vector<NearEnd> near = pointsNear(cloud, stretch, sigma_mm, end_mm, sign, before_mm);
        const CutBeyond cut(near, stretch.shape, sigma_mm, endOfSection(near, reach_mm, before_mm, kind));
        const double known = end_mm;
        beyond = {known, cut.line().radius_mm, sign * cut.line().slope, cut.isExplained()};
        end_mm = known + sign * cut.from_mm();
        return known + sign * cut.to_mm();
    };
    stretch.mark.z_start_mm = place(stretch.from_mm, -1, stretch.before);
    stretch.mark.z_end_mm = place(stretch.to_mm, 1, stretch.behind);
}

}  // namespace lathelier::features
