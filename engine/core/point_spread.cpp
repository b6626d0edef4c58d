#include "engine/core/point_spread.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>

#include "engine/core/core_codes.h"
#include "engine/core/error.h"
#include "engine/core/parallel.h"

namespace lathelier {
namespace {

using Eigen::Vector3d;

struct Moments {
    Vector3d sum = Vector3d::Zero();
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    double largest = 0;
};

}  // namespace

PointSpread spreadOf(std::span<const Vector3d> points_mm, std::size_t least, double limit_mm, const Progress& progress)
{
    if (points_mm.size() < least)
        throw Error(errors::tooFewPoints, {{"found", static_cast<std::int64_t>(points_mm.size())},
                                           {"minimum", static_cast<std::int64_t>(least)}});
    const Vector3d origin = points_mm.front();  // squares of differences, not of far coordinates
    const Moments moments = parallelReduce(
        points_mm.size(), 16384, progress, Moments{},
        [&](std::size_t begin, std::size_t end) {
            Moments part;
            double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
            for (std::size_t i = begin; i < end; ++i) {
                const Vector3d p = points_mm[i] - origin;
                part.sum += p;
                xx += p.x() * p.x();
                xy += p.x() * p.y();
                xz += p.x() * p.z();
                yy += p.y() * p.y();
                yz += p.y() * p.z();
                zz += p.z() * p.z();
                const double size = points_mm[i].cwiseAbs().maxCoeff();
                part.largest = std::max(part.largest, size);
            }
            part.squares << xx, xy, xz, xy, yy, yz, xz, yz, zz;
            // A maximum ignores NaN; the sums propagate it.
            if (!part.sum.allFinite()) part.largest = std::numeric_limits<double>::infinity();
            return part;
        },
        [](Moments all, const Moments& part) {
            all.sum += part.sum;
            all.squares += part.squares;
            all.largest = std::max(all.largest, part.largest);
            return all;
        });
    if (!(moments.largest <= limit_mm))
        throw Error(errors::coordinateTooLarge, {{"found", moments.largest}, {"maximum", limit_mm}});
    const auto count = static_cast<double>(points_mm.size());
    const Vector3d mean = moments.sum / count;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(moments.squares / count - mean * mean.transpose());
    return {origin + mean, solver.eigenvectors(), solver.eigenvalues().cwiseMax(0).cwiseSqrt(), moments.largest};
}

void refuseDegenerate(const PointSpread& spread, double place_mm, double flat_mm)
{
    const auto refuse = [](Text where) { throw Error(errors::pointsDegenerate, {{"found", where}}); };
    if (!(spread.extent_mm[2] > place_mm)) refuse(LT_TEXT("Engine", "in one place"));
    if (!(spread.extent_mm[1] > flat_mm)) refuse(LT_TEXT("Engine", "on a line"));
    if (!(spread.extent_mm[0] > flat_mm)) refuse(LT_TEXT("Engine", "in a plane"));
}

}  // namespace lathelier
