#include "engine/features/scene/surroundings/holders.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "engine/core/statistics.h"
#include "engine/core/units.h"
#include "engine/features/scene/scene_footprint.h"
#include "engine/features/scene/surroundings/plane_shares.h"
#include "engine/features/scene/surroundings/point_cubes.h"
#include "engine/features/scene/surroundings/surroundings_limits.h"

namespace lathelier::features {
namespace {

using Eigen::Vector3d;

/// A group of points outside the part's surface.
struct OutsideGroup {
    std::vector<std::size_t> points;                   ///< indices into HolderInput::off
    double first_mm = 0, last_mm = 0, largest_mm = 0;  ///< z and radius
};

/// One end of the part. z grows toward the end: it is multiplied by `sense`.
class EndSearch {
public:
    EndSearch(const HolderInput& input, const std::vector<OutsideGroup>& groups, bool last)
        : input_(input), groups_(groups), last_(last), sense_(last ? 1 : -1)
    {
        const double a = sense_ * input.cloud.z_first_mm, b = sense_ * input.cloud.z_last_mm;
        from_ = std::min(a, b);
        to_ = std::max(a, b);
    }

    std::optional<Holder> jaws(const Progress& progress)
    {
        for (const OutsideGroup& group : groups_) {
            progress.check();
            if (canHold(group)) jaws_.push_back(&group);
        }
        if (jaws_.empty()) return std::nullopt;
        front_ = std::numeric_limits<double>::infinity();
        for (const OutsideGroup* group : jaws_) front_ = std::min(front_, begin(*group));
        radius_ = *radiusBefore(front_);
        chuck_ = chuckBehind(front_);
        if (!isLimitedInAngle() || !hasPlanes()) return std::nullopt;
        return holder();
    }

    std::optional<Holder> centre() const
    {
        const std::vector<const Chain*>& chains = input_.surface.outside();
        for (std::size_t k = 0; k + 1 < chains.size(); ++k) {
            const Chain& part = last_ ? *chains[k] : *chains[chains.size() - 1 - k];
            const Chain& cone = last_ ? *chains[k + 1] : *chains[chains.size() - 2 - k];
            if (!isCentre(part, cone)) continue;
            const double face = (sense_ * end(part).z_mm + sense_ * start(cone).z_mm) / 2;
            Holder found;
            found.at_last = last_;
            found.from_mm = sense_ * face;
            found.to_mm = sense_ * to_;
            found.hides_end = false;
            found.parts.resize(1);
            for (std::size_t i = 0; i < input_.cloud.z_mm.size(); ++i) {
                const double z = along(i), r = static_cast<double>(input_.cloud.r_mm[i]);
                const bool at_face = z > face - surroundingsLimits.beside_holder_mm &&
                                     r < surroundingsLimits.face_centre_share * end(part).r_mm;
                if (at_face || z > face + surroundingsLimits.outside_mm)
                    found.parts[0].push_back(static_cast<std::uint32_t>(i));
            }
            return found;
        }
        return std::nullopt;
    }

private:
    double along(std::size_t i) const { return sense_ * static_cast<double>(input_.cloud.z_mm[i]); }
    double begin(const OutsideGroup& group) const { return last_ ? group.first_mm : -group.last_mm; }
    double end(const OutsideGroup& group) const { return last_ ? group.last_mm : -group.first_mm; }
    const Wall& start(const Chain& chain) const { return last_ ? chain.walls.front() : chain.walls.back(); }
    const Wall& end(const Chain& chain) const { return last_ ? chain.walls.back() : chain.walls.front(); }
    bool isSeen(double z) const { return input_.surface.isSeen(sense_ * z); }
    double outer(double z) const { return input_.surface.outer_mm(sense_ * z); }

    /// Radius of the part just before a holder; none where no part is seen there.
    std::optional<double> radiusBefore(double front) const
    {
        double seen = 0;
        for (double z = from_; z < front; z += surroundingsLimits.look_mm)
            seen += isSeen(z) ? surroundingsLimits.look_mm : 0;
        if (seen < surroundingsLimits.least_part_mm) return std::nullopt;
        for (double z = front - surroundingsLimits.look_mm; z > front - surroundingsLimits.before_jaws_mm;
             z -= surroundingsLimits.look_mm)
            if (isSeen(z)) return outer(z);
        return std::nullopt;
    }

    /// Where a body larger than the part begins, after which nothing of the part's size follows. Infinite: no wall is
    /// seen behind `from`. None: something smaller follows.
    std::optional<double> bodyBehind(double from, double radius) const
    {
        double begins = std::numeric_limits<double>::infinity();
        for (double z = from; z < to_; z += surroundingsLimits.look_mm) {
            if (!isSeen(z)) continue;
            const bool larger = outer(z) > radius + surroundingsLimits.holder_reach_mm;
            if (!larger && begins < z) return std::nullopt;
            if (larger) begins = std::min(begins, z);
        }
        return begins;
    }

    std::optional<double> chuckBehind(double front) const
    {
        const std::optional<double> begins = bodyBehind(front, radius_);
        return begins && std::isfinite(*begins) ? begins : std::nullopt;
    }

    /// May a group grip this end: does it stand high on the part, with nothing but a chuck behind it?
    bool canHold(const OutsideGroup& group) const
    {
        const double front = begin(group), back = end(group);
        const std::optional<double> radius = radiusBefore(front);
        if (!radius || group.largest_mm < *radius + surroundingsLimits.holder_reach_mm) return false;
        const std::optional<double> body = bodyBehind(front, *radius);
        if (!body) return false;
        if (std::isfinite(*body)) return *body < back + surroundingsLimits.touching_mm;
        // Without a chuck the part may be seen between the jaws, but not behind them.
        for (double z = back + surroundingsLimits.touching_mm; z < to_; z += surroundingsLimits.look_mm)
            if (isSeen(z)) return false;
        return group.largest_mm > *radius * (1 + surroundingsLimits.holder_reach_share);
    }

    /// Do few parts stand high, and is the surface between these low?
    bool isLimitedInAngle() const
    {
        std::array<double, surroundingsLimits.jaw_directions> height{};
        double most = 0;
        for (const OutsideGroup* group : jaws_)
            for (const std::size_t k : group->points) {
                const Vector3d& p = input_.off_on_axis[k];
                if (chuck_ && sense_ * p.z() > *chuck_ - surroundingsLimits.touching_mm) continue;
                const double turn = std::atan2(p.y(), p.x()) / turn_rad + 0.5;
                const auto d = std::min(surroundingsLimits.jaw_directions - 1,
                                        static_cast<std::size_t>(turn * surroundingsLimits.jaw_directions));
                height[d] = std::max(height[d], std::hypot(p.x(), p.y()) - radius_);
                most = std::max(most, height[d]);
            }
        int count = 0;
        for (std::size_t d = 0; d < surroundingsLimits.jaw_directions; ++d)
            count += height[d] > most / 2 && !(height[(d + 1) % surroundingsLimits.jaw_directions] > most / 2) ? 1 : 0;
        if (count == 0 || count > surroundingsLimits.most_jaws || (count == 1 && !chuck_ && !widens())) return false;
        std::vector<double> sorted(height.begin(), height.end());
        return lowerQuantileInPlace(sorted, surroundingsLimits.low_directions) <= surroundingsLimits.low_share * most;
    }

    /// Is what follows behind the front of a single jaw larger: a chuck seen from one side?
    bool widens() const
    {
        double front = 0, behind = 0;
        for (const OutsideGroup* group : jaws_)
            for (const std::size_t k : group->points) {
                const Vector3d& p = input_.off_on_axis[k];
                double& largest = sense_ * p.z() < front_ + surroundingsLimits.holder_reach_mm ? front : behind;
                largest = std::max(largest, std::hypot(p.x(), p.y()));
            }
        return behind > front + surroundingsLimits.holder_reach_mm;
    }

    bool hasPlanes() const
    {
        std::vector<Vector3d> points;
        for (const OutsideGroup* group : jaws_)
            for (const std::size_t k : group->points) points.push_back(input_.off_on_axis[k]);
        return planesShare(points, surroundingsLimits.plane_share,
                           input_.surface.band_mm() / surroundingsLimits.on_sigmas) >
               surroundingsLimits.all_planes_share;
    }

    /// Is the part seen between the jaws, behind their fronts?
    bool isSeenBetween(const std::vector<std::uint16_t>& taken, double limit) const
    {
        const double from = front_ + surroundingsLimits.outside_mm,
                     to = std::min(front_ + surroundingsLimits.between_jaws_mm, limit);
        double seen = 0;
        for (std::size_t i = 0; i < input_.cloud.z_mm.size(); ++i)
            seen += taken[i] == 0 && along(i) > from && along(i) < to ? 1 : 0;
        return seen > surroundingsLimits.between_jaws_share * input_.cloud.points_per_mm * std::max(1.0, to - from);
    }

    /// For each point 0: the part's; else the number of its jaw from 1, or `rest`.
    std::vector<std::uint16_t> takenPoints(std::uint16_t rest, double from, double limit) const
    {
        const MeridianCloud& cloud = input_.cloud;
        std::vector<std::uint16_t> taken(cloud.z_mm.size(), 0);
        std::vector<SceneFootprint> footprints(jaws_.size());  // of each jaw: between two of them the part may be seen
        std::uint16_t jaw = 0;
        for (const OutsideGroup* group : jaws_) {
            ++jaw;
            for (const std::size_t k : group->points) {
                taken[input_.off[k]] = jaw;
                const Vector3d& p = input_.off_on_axis[k];
                if (std::hypot(p.x(), p.y()) < outer(sense_ * p.z()) + surroundingsLimits.jaw_contact_mm)
                    footprints[jaw - 1U].add(p);
            }
        }
        for (SceneFootprint& footprint : footprints) footprint.close();
        for (std::size_t i = 0; i < cloud.z_mm.size(); ++i) {
            const double z = along(i), r = static_cast<double>(cloud.r_mm[i]);
            if (taken[i] > 0 || z < from) continue;
            const double angle = turn_rad * static_cast<double>(cloud.turn[i]);
            const bool high = r > (chuck_ ? radius_ : outer(z)) + surroundingsLimits.outside_mm;
            const Vector3d point(r * std::cos(angle), r * std::sin(angle), sense_ * z);
            const auto is_under = [&](const SceneFootprint& footprint) { return footprint.contains(point); };
            if (high || (chuck_ && z > limit) || std::any_of(footprints.begin(), footprints.end(), is_under))
                taken[i] = rest;
        }
        if (!isSeenBetween(taken, limit))
            for (std::size_t i = 0; i < cloud.z_mm.size(); ++i)
                if (taken[i] == 0 && along(i) >= from) taken[i] = rest;
        return taken;
    }

    Holder holder() const
    {
        const double from = front_ - surroundingsLimits.beside_holder_mm, end = chuck_ ? *chuck_ : to_;
        // Without a chuck the rest are points at the contacts: they go with the largest jaw.
        const auto largest = std::max_element(jaws_.begin(), jaws_.end(), [](const auto* a, const auto* b) {
            return a->points.size() < b->points.size();
        });
        const std::size_t rest = chuck_ ? jaws_.size() + 1 : static_cast<std::size_t>(largest - jaws_.begin()) + 1;
        const auto taken = takenPoints(static_cast<std::uint16_t>(rest), from, end - surroundingsLimits.face_mm);
        Holder found;
        found.at_last = last_;
        found.from_mm = sense_ * from;
        found.to_mm = sense_ * end;
        found.parts.resize(jaws_.size() + 1);
        for (std::size_t i = 0; i < taken.size(); ++i)
            if (taken[i] > 0) found.parts[taken[i] - 1U].push_back(static_cast<std::uint32_t>(i));
        return found;
    }

    bool isCentre(const Chain& part, const Chain& cone) const
    {
        const double apart = sense_ * start(cone).z_mm - sense_ * end(part).z_mm;
        if (apart > surroundingsLimits.shoulder_mm ||
            start(cone).r_mm > surroundingsLimits.centre_tip_share * end(part).r_mm)
            return false;
        if (!radiusBefore(sense_ * end(part).z_mm)) return false;
        double n = 0, sz = 0, sr = 0, szz = 0, szr = 0, length = 0;
        for (const Wall& wall : cone.walls) {
            const double z = std::abs(wall.z_mm - start(cone).z_mm);
            if (z > surroundingsLimits.centre_fit_mm) continue;
            n += 1;
            sz += z;
            sr += wall.r_mm;
            szz += z * z;
            szr += z * wall.r_mm;
            length = std::max(length, z);
        }
        const double spread = szz - sz * sz / std::max(1.0, n);
        if (length < surroundingsLimits.centre_fit_mm / 2 || !(spread > 0)) return false;
        const double angle = std::atan((szr - sz * sr / n) / spread) * deg_per_rad;
        return std::abs(angle - surroundingsLimits.centre_half_angle_deg) < surroundingsLimits.centre_angle_error_deg;
    }

    const HolderInput& input_;
    const std::vector<OutsideGroup>& groups_;
    bool last_;
    double sense_, from_ = 0, to_ = 0;
    std::vector<const OutsideGroup*> jaws_;
    double front_ = 0, radius_ = 0;
    std::optional<double> chuck_;  ///< where the chuck begins
};

/// Groups of points well outside the surface.
std::vector<OutsideGroup> groupsOutside(const HolderInput& input)
{
    std::vector<Vector3d> points;
    std::vector<std::size_t> index;
    std::vector<double> radii;
    for (std::size_t k = 0; k < input.off.size(); ++k) {
        const Vector3d& p = input.off_on_axis[k];
        const double r = std::hypot(p.x(), p.y());
        if (!(r > input.surface.outer_mm(p.z()) + surroundingsLimits.outside_mm)) continue;
        points.push_back(p);
        index.push_back(k);
        radii.push_back(r);
    }
    std::vector<OutsideGroup> groups;
    if (points.size() < surroundingsLimits.least_in_holder) return groups;
    const double around = 2 * std::numbers::pi * median(radii);
    const PointCubes cubes(points, std::max(surroundingsLimits.jaw_cube_mm,
                                            surroundingsLimits.jaw_cube_spacings *
                                                std::sqrt(around / std::max(1.0, input.cloud.points_per_mm))));
    for (const auto& own : cubes.groups([](std::size_t) { return true; })) {
        OutsideGroup group;
        std::vector<double> z, r;
        for (const std::size_t cube : own)
            for (const std::uint32_t* i = cubes.begin(cube); i != cubes.end(cube); ++i) {
                group.points.push_back(index[*i]);
                z.push_back(points[*i].z());
                r.push_back(radii[*i]);
            }
        if (group.points.size() < surroundingsLimits.least_in_holder) continue;
        group.first_mm = quantileInPlace(z, surroundingsLimits.end_quantile);
        group.last_mm = quantileInPlace(z, 1 - surroundingsLimits.end_quantile);
        group.largest_mm = quantileInPlace(r, surroundingsLimits.largest_quantile);
        groups.push_back(std::move(group));
    }
    return groups;
}

}  // namespace

std::vector<Holder> findHolders(const HolderInput& input, const Progress& progress)
{
    const std::vector<OutsideGroup> groups = groupsOutside(input);
    std::vector<Holder> holders;
    for (const bool last : {true, false}) {
        EndSearch search(input, groups, last);
        std::optional<Holder> found = groups.empty() ? std::nullopt : search.jaws(progress);
        if (!found) found = search.centre();
        if (found) holders.push_back(std::move(*found));
    }
    return holders;
}

}  // namespace lathelier::features
