#include "engine/form/circle/circle_points.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "engine/core/core_codes.h"
#include "engine/core/error.h"
#include "engine/form/largest_coordinate.h"

namespace lathelier::form {
namespace {

constexpr Eigen::Index bundleSize = 64;
constexpr Eigen::Index worthBundles = 16384;

void checkDifferent(std::span<const Eigen::Vector2d> points_mm, std::size_t least)
{
    std::vector<Eigen::Vector2d> different;
    for (const Eigen::Vector2d& point : points_mm) {
        if (std::find(different.begin(), different.end(), point) == different.end()) different.push_back(point);
        if (different.size() == least) return;
    }
    if (different.size() == 1 && points_mm.size() >= least)
        throw Error(errors::pointsDegenerate, {{"found", LT_TEXT("Engine", "in one place")}});
    throw Error(errors::tooFewPoints, {{"found", static_cast<std::int64_t>(different.size())},
                                       {"minimum", static_cast<std::int64_t>(least)}});
}

/// Smallest width of the points across their principal direction.
double widthAcross(const Eigen::ArrayXd& x, const Eigen::ArrayXd& y)
{
    const double mean_x = x.mean(), mean_y = y.mean();
    const double xx = (x - mean_x).square().sum(), yy = (y - mean_y).square().sum();
    const double xy = ((x - mean_x) * (y - mean_y)).sum();
    const double angle = 0.5 * std::atan2(2 * xy, xx - yy);
    const Eigen::ArrayXd across = y * std::cos(angle) - x * std::sin(angle);
    return across.maxCoeff() - across.minCoeff();
}

/// Whether the points lie on a line, no wider than `width`.
bool areStraight(const Eigen::ArrayXd& x, const Eigen::ArrayXd& y, double width)
{
    // A subset cannot be wider than the whole set.
    constexpr Eigen::Index few = 1024;
    if (const Eigen::Index stride = x.size() / few; stride > 1) {
        using Some = Eigen::Map<const Eigen::ArrayXd, 0, Eigen::InnerStride<>>;
        const Eigen::InnerStride<> step(stride);
        if (widthAcross(Some(x.data(), few, step), Some(y.data(), few, step)) > 10 * width) return false;
    }
    return widthAcross(x, y) <= width;
}

}  // namespace

CirclePoints::CirclePoints(std::span<const Eigen::Vector2d> points_mm, std::size_t least)
{
    checkDifferent(points_mm, least);
    Eigen::Array2d low = points_mm.front(), high = points_mm.front();
    for (const Eigen::Vector2d& point : points_mm) {
        low = low.min(point.array());
        high = high.max(point.array());
        // Comparison in this form also rejects NaN, which minimum and maximum would discard.
        if (const double size = point.cwiseAbs().maxCoeff(); !(size <= largestCoordinate_mm) || !point.allFinite())
            throw Error(errors::coordinateTooLarge, {{"found", size}, {"maximum", largestCoordinate_mm}});
    }
    middle_mm_ = 0.5 * low + 0.5 * high;
    const double half_mm = 0.5 * (high - low).maxCoeff();
    scale_mm_ = std::ldexp(1.0, std::ilogb(half_mm) + 1);
    extent_ = half_mm / scale_mm_;
    const auto count = static_cast<Eigen::Index>(points_mm.size());
    x_.resize(count);
    y_.resize(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const Eigen::Vector2d local = (points_mm[static_cast<std::size_t>(i)] - middle_mm_) / scale_mm_;
        x_[i] = local.x();
        y_[i] = local.y();
    }
    const double rounding = low.abs().max(high.abs()).maxCoeff() / scale_mm_ * std::numeric_limits<double>::epsilon();
    if (areStraight(x_, y_, std::max(1e-10, 16 * rounding)))
        throw Error(errors::pointsDegenerate, {{"found", LT_TEXT("Engine", "on a line")}});
}

void CirclePoints::prepareForManyCentres()
{
    if (x_.size() < worthBundles || !bundles_.empty()) return;
    for (Eigen::Index begin = 0; begin < x_.size(); begin += bundleSize) {
        const Eigen::Index end = std::min(x_.size(), begin + bundleSize);
        Bundle bundle;
        bundle.nearest = std::numeric_limits<double>::infinity();
        for (Eigen::Index i = begin; i < end; ++i) bundle.direction += Eigen::Vector2d(x_[i], y_[i]);
        bundle.direction.stableNormalize();
        for (Eigen::Index i = begin; i < end; ++i) {
            const Eigen::Vector2d ray(x_[i], y_[i]);
            const double distance = ray.norm();
            bundle.nearest = std::min(bundle.nearest, distance);
            bundle.farthest = std::max(bundle.farthest, distance);
            bundle.spread = std::max(
                bundle.spread, distance > 0 ? (ray / distance - bundle.direction).norm() : bundle.direction.norm());
        }
        bundles_.push_back(bundle);
    }
}

void CirclePoints::squares(const Eigen::Vector2d& centre, Eigen::Index begin, Eigen::Index length,
                           Squares& buffer) const
{
    buffer.head(length) =
        (x_.segment(begin, length) - centre.x()).square() + (y_.segment(begin, length) - centre.y()).square();
}

/// Blocks keep the distances in the first cache and the comparisons in vector registers; the index is looked for in
/// the one block that holds the extreme.
void CirclePoints::search(const Eigen::Vector2d& centre, Eigen::Index begin, Eigen::Index length, double& low,
                          double& high, Eigen::Index& low_block, Eigen::Index& high_block) const
{
    Squares buffer;
    squares(centre, begin, length, buffer);
    const double block_low = buffer.head(length).minCoeff(), block_high = buffer.head(length).maxCoeff();
    if (block_low < low) {
        low = block_low;
        low_block = begin;
    }
    if (block_high > high) {
        high = block_high;
        high_block = begin;
    }
}

CirclePoints::Extremes CirclePoints::extremes(const Eigen::Vector2d& centre) const
{
    double low = std::numeric_limits<double>::infinity(), high = -1;
    Eigen::Index low_block = 0, high_block = 0;
    if (bundles_.empty()) {
        for (Eigen::Index begin = 0; begin < x_.size(); begin += blockSize)
            search(centre, begin, std::min(blockSize, x_.size() - begin), low, high, low_block, high_block);
    } else {
        // |p - c| with p = d v, |v| = 1: no less than d - v·c and no more than that + c²/2(d - |c|). Only bundles that
        // may contain an extreme are searched.
        const double length = centre.norm();
        const double rounding = 1e-14 * (1 + length);
        double nearest = std::numeric_limits<double>::infinity(), farthest = -1;
        for (std::size_t b = 0; b < bundles_.size(); ++b) {
            const Bundle& bundle = bundles_[b];
            const double along = bundle.direction.dot(centre), loose = bundle.spread * length + rounding;
            const double least = bundle.nearest - along - loose;
            const double sideways = length * length / (2 * std::max(bundle.nearest - length, 1e-300));
            if (least > nearest && bundle.farthest - along + loose + sideways < farthest) continue;
            const auto begin = static_cast<Eigen::Index>(b) * bundleSize;
            search(centre, begin, std::min(bundleSize, x_.size() - begin), low, high, low_block, high_block);
            nearest = std::sqrt(low) + rounding;
            farthest = std::sqrt(high) - rounding;
        }
    }
    const auto indexOf = [&](Eigen::Index begin, double wanted) {
        Squares buffer;
        const Eigen::Index length = std::min(bundles_.empty() ? blockSize : bundleSize, x_.size() - begin);
        squares(centre, begin, length, buffer);
        Eigen::Index index = 0;
        while (buffer[index] != wanted) ++index;
        return begin + index;
    };
    const Eigen::Index low_index = indexOf(low_block, low), high_index = indexOf(high_block, high);
    return {std::sqrt(low), std::sqrt(high), static_cast<std::size_t>(low_index), static_cast<std::size_t>(high_index)};
}

std::array<CirclePoints::Sector, CirclePoints::sectorCount> CirclePoints::sectors(const Eigen::Vector2d& centre) const
{
    std::array<Sector, sectorCount> result;
    for (Eigen::Index i = 0; i < x_.size(); ++i) {
        const double dx = x_[i] - centre.x(), dy = y_[i] - centre.y();
        const double sum = std::abs(dx) + std::abs(dy);
        if (sum == 0) continue;
        const double turn = dy >= 0 ? 1 - dx / sum : 3 + dx / sum;  // 0…4, grows with the angle
        const auto index = std::min(static_cast<std::size_t>(turn * (sectorCount / 4.0)), sectorCount - 1);
        Sector& sector = result[index];
        const double square = dx * dx + dy * dy;
        if (!sector.occupied || square < sector.nearest) {
            sector.nearest = square;
            sector.nearest_index = static_cast<std::uint32_t>(i);
        }
        if (!sector.occupied || square > sector.farthest) {
            sector.farthest = square;
            sector.farthest_index = static_cast<std::uint32_t>(i);
        }
        sector.occupied = true;
    }
    return result;
}

}  // namespace lathelier::form
