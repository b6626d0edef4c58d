#include "engine/registration/point_checks.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/core/error.h"
#include "engine/core/parallel.h"

namespace lathelier {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kLeastPoints = 50;
constexpr double kLargest_mm = 1e7;  // beyond ten kilometres, squares of differences lose micrometres

}  // namespace

void checkPoints(const std::vector<Vector3d>& points, const char* role, const Progress& progress)
{
    const auto reject = [&](ErrorCode code, Values values) {
        values.emplace_back("role", std::string(role));
        throw Error(code, std::move(values));
    };
    if (points.size() < kLeastPoints)
        reject(ErrorCode::TooFewPoints, {{"found", static_cast<std::int64_t>(points.size())},
                                         {"minimum", static_cast<std::int64_t>(kLeastPoints)}});
    struct Sums {
        Vector3d sum = Vector3d::Zero();
        Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
        double worst = 0;
    };
    const Vector3d origin = points.front();
    const Sums sums = parallelReduce(
        points.size(), 65536, progress, Sums{},
        [&](std::size_t begin, std::size_t end) {
            Sums part;
            for (std::size_t i = begin; i < end; ++i) {
                const double size = points[i].cwiseAbs().maxCoeff();
                if (!(size <= part.worst) || !points[i].allFinite())
                    part.worst = points[i].allFinite() ? size : std::numeric_limits<double>::infinity();
                if (!(size <= kLargest_mm)) break;
                const Vector3d p = points[i] - origin;
                part.sum += p;
                part.squares += p * p.transpose();
            }
            return part;
        },
        [](Sums all, const Sums& part) {
            all.sum += part.sum;
            all.squares += part.squares;
            all.worst = std::max(all.worst, part.worst);
            return all;
        });
    if (!(sums.worst <= kLargest_mm))
        reject(ErrorCode::CoordinateTooLarge, {{"found", sums.worst}, {"maximum", kLargest_mm}});
    const auto n = static_cast<double>(points.size());
    const Vector3d mean = sums.sum / n;
    const Eigen::Matrix3d scatter = sums.squares / n - mean * mean.transpose();
    const Vector3d extent = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter, Eigen::EigenvaluesOnly)
                                .eigenvalues()
                                .cwiseMax(0)
                                .cwiseSqrt();
    // Rounding of the coordinates themselves must not look like a shape.
    const double least = std::max(1e-6 * extent[2], 1e-7 * sums.worst);
    if (extent[2] <= 1e-7 * sums.worst || extent[2] == 0)
        reject(ErrorCode::PointsDegenerate, {{"found", LT_TEXT("Engine", "in one place")}});
    if (extent[1] <= least) reject(ErrorCode::PointsDegenerate, {{"found", LT_TEXT("Engine", "on a line")}});
    if (extent[0] <= least) reject(ErrorCode::PointsDegenerate, {{"found", LT_TEXT("Engine", "in a plane")}});
}

}  // namespace lathelier
