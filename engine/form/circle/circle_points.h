// The points of a profile, centred and scaled for the fits of circles.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace lathelier::form {

/// Points about the middle of their bounding box, in units of about half its size: a power of two, so that scaling is
/// exact. All members are in these units; toMm() converts back.
class CirclePoints {
public:
    /// Errors: tooFewPoints (fewer than `least` different ones), pointsDegenerate, coordinateTooLarge.
    CirclePoints(std::span<const Eigen::Vector2d> points_mm, std::size_t least);

    std::size_t size() const { return static_cast<std::size_t>(x_.size()); }
    const Eigen::ArrayXd& x() const { return x_; }
    const Eigen::ArrayXd& y() const { return y_; }
    Eigen::Vector2d point(std::size_t index) const
    {
        const auto i = static_cast<Eigen::Index>(index);
        return {x_[i], y_[i]};
    }
    double extent() const { return extent_; }  ///< half of the bounding box's longer side: 0.5…1
    double scale_mm() const { return scale_mm_; }
    Eigen::Vector2d toMm(const Eigen::Vector2d& centre) const { return middle_mm_ + scale_mm_ * centre; }

    /// The points nearest to and farthest from a centre; of ties the first.
    struct Extremes {
        double nearest = 0, farthest = 0;                   ///< distances from the centre
        std::size_t nearest_index = 0, farthest_index = 0;  ///< places of the points that have these distances

        double width() const { return farthest - nearest; }
    };
    Extremes extremes(const Eigen::Vector2d& centre) const;
    /// Speeds up extremes() for many points sorted by direction.
    void prepareForManyCentres();

    /// The same for each of `sectorCount` equal sectors of direction (in the L1 pseudo-angle) about a centre.
    static constexpr std::size_t sectorCount = 64;
    struct Sector {
        bool occupied = false;             ///< false: no point lies in the sector, the other members are undefined
        double nearest = 0, farthest = 0;  ///< squared distances from the centre
        std::uint32_t nearest_index = 0, farthest_index = 0;  ///< places of the points that have these distances
    };
    std::array<Sector, sectorCount> sectors(const Eigen::Vector2d& centre) const;

private:
    /// Consecutive points of nearly one direction. Their distances from the middle bound those from another centre.
    struct Bundle {
        double nearest = 0, farthest = 0;  ///< distances of its points from the middle of the bounding box
        Eigen::Vector2d direction = Eigen::Vector2d::Zero();  ///< unit vector toward the mean of its points
        double spread = 0;  ///< largest distance of a point's direction from that of the bundle
    };
    static constexpr Eigen::Index blockSize = 512;
    using Squares = Eigen::Array<double, blockSize, 1>;  ///< squared distances of one block of points
    void squares(const Eigen::Vector2d& centre, Eigen::Index begin, Eigen::Index length, Squares& buffer) const;
    void search(const Eigen::Vector2d& centre, Eigen::Index begin, Eigen::Index length, double& low, double& high,
                Eigen::Index& low_block, Eigen::Index& high_block) const;

    Eigen::ArrayXd x_, y_;
    std::vector<Bundle> bundles_;  ///< empty for few points
    Eigen::Vector2d middle_mm_ = Eigen::Vector2d::Zero();
    double scale_mm_ = 1;
    double extent_ = 1;
};

}  // namespace lathelier::form
