#include "engine/registration/general/coarse_alignment.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "engine/core/parallel.h"
#include "engine/registration/general/general_reference.h"
#include "engine/registration/neighbours/neighbours.h"
#include "engine/registration/neighbours/neighbours_order.h"

namespace lathelier::registration {
namespace {

using Points = std::vector<Eigen::Vector3d>;

constexpr int evenRotations = 500;           // about 30° apart
constexpr std::size_t fewPoints = 160;       // points used for all starts
constexpr std::size_t severalPoints = 1200;  // points used to improve the best starts
constexpr std::size_t keptStarts = 20;
constexpr int field_cells = 48;  // cells along the longest side of the grid

struct Pose {
    Eigen::Isometry3d reference_T_copy;
    double score;
};

struct Extent {
    Eigen::Vector3d centre_mm;
    Eigen::Matrix3d axes;  // principal, right-handed
    double size_mm;        // twice the root mean square distance from the centre
};

Extent extentOf(const Points& points)
{
    Extent e;
    e.centre_mm.setZero();
    for (const auto& p : points) e.centre_mm += p / static_cast<double>(points.size());
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const auto& p : points) spread += (p - e.centre_mm) * (p - e.centre_mm).transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
    e.axes = solver.eigenvectors();
    if (e.axes.determinant() < 0) e.axes.col(0) *= -1;
    e.size_mm = 2 * std::sqrt(spread.trace() / static_cast<double>(points.size()));
    return e;
}

// The nearest reference point of each cell of a grid: a quick, rough answer.
class NearestGrid {
public:
    NearestGrid(const Points& reference, const Neighbours& index, const Progress& progress)
    {
        Box box;
        for (const auto& p : reference) box.add(p);
        const double longest = std::max((box.high_mm - box.low_mm).maxCoeff(), 1e-9);
        cell_mm_ = 1.3 * longest / field_cells;
        low_mm_ = box.low_mm.array() - 0.15 * longest;
        for (int a = 0; a < 3; ++a)
            cells_[a] = static_cast<int>((box.high_mm[a] - box.low_mm[a] + 0.3 * longest) / cell_mm_) + 1;
        nearest_.resize(static_cast<std::size_t>(cells_.prod()));
        parallelFor(nearest_.size(), 512, progress, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const int x = static_cast<int>(i) % cells_[0];
                const int y = static_cast<int>(i) / cells_[0] % cells_[1];
                const int z = static_cast<int>(i) / (cells_[0] * cells_[1]);
                const Eigen::Vector3d centre = low_mm_ + cell_mm_ * Eigen::Vector3d(x + 0.5, y + 0.5, z + 0.5);
                nearest_[i] = index.point_mm(index.nearest(centre).place);
            }
        });
    }

    const Eigen::Vector3d& nearest(const Eigen::Vector3d& query_mm) const
    {
        Eigen::Vector3i cell;
        for (int a = 0; a < 3; ++a)
            cell[a] = static_cast<int>(std::clamp((query_mm[a] - low_mm_[a]) / cell_mm_, 0.0, cells_[a] - 1.0));
        const Eigen::Matrix<std::size_t, 3, 1> at = cell.cast<std::size_t>();
        const Eigen::Matrix<std::size_t, 3, 1> all = cells_.cast<std::size_t>();
        return nearest_[(at[2] * all[1] + at[1]) * all[0] + at[0]];
    }

private:
    Eigen::Vector3d low_mm_;
    Eigen::Vector3i cells_;
    double cell_mm_;
    Points nearest_;
};

// The rotation and translation that bring weighted pairs together best (Kabsch).
Eigen::Isometry3d bringTogether(const Points& from, const Points& to, const std::vector<double>& weights)
{
    double total = 0;
    Eigen::Vector3d from_mean = Eigen::Vector3d::Zero();
    Eigen::Vector3d to_mean = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < from.size(); ++i) {
        total += weights[i];
        from_mean += weights[i] * from[i];
        to_mean += weights[i] * to[i];
    }
    from_mean /= total;
    to_mean /= total;
    Eigen::Matrix3d product = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < from.size(); ++i)
        product += weights[i] * (to[i] - to_mean) * (from[i] - from_mean).transpose();
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(product, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Eigen::Vector3d signs = Eigen::Vector3d::Ones();
    if ((svd.matrixU() * svd.matrixV().transpose()).determinant() < 0) signs[2] = -1;
    Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
    result.linear() = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
    result.translation() = to_mean - result.linear() * from_mean;
    return result;
}

// Iterative closest points with weights that decrease beyond a distance, which shrinks from step to step.
template <class Nearest>
void improvePose(Eigen::Isometry3d& pose, const Points& copy, const Nearest& nearest, int rounds, double from_mm,
                 double to_mm)
{
    Points moved(copy.size());
    Points targets(copy.size());
    std::vector<double> weights(copy.size());
    for (int round = 0; round < rounds; ++round) {
        const double reach = from_mm * std::pow(to_mm / from_mm, round / std::max(1.0, rounds - 1.0));
        for (std::size_t i = 0; i < copy.size(); ++i) {
            moved[i] = pose * copy[i];
            targets[i] = nearest(moved[i]);
            const double t = (targets[i] - moved[i]).squaredNorm() / (reach * reach);
            weights[i] = 1 / ((1 + t) * (1 + t));
        }
        pose = bringTogether(moved, targets, weights) * pose;
    }
}

template <class Nearest>
double roughMisfit(const Eigen::Isometry3d& pose, const Points& points, const Nearest& nearest, double limit_mm)
{
    double sum = 0;
    for (const auto& p : points) {
        const Eigen::Vector3d q = pose * p;
        sum += std::min(1.0, (nearest(q) - q).squaredNorm() / (limit_mm * limit_mm));
    }
    return sum / static_cast<double>(points.size());
}

std::vector<Eigen::Matrix3d> startRotations(const Extent& reference, const Extent& copy)
{
    std::vector<Eigen::Matrix3d> result{Eigen::Matrix3d::Identity()};
    // All 24 right-handed assignments of the principal axes.
    for (int first = 0; first < 3; ++first)
        for (int second = 0; second < 3; ++second)
            for (int signs = 0; signs < 4 && first != second; ++signs) {
                Eigen::Matrix3d turn = Eigen::Matrix3d::Zero();
                turn(first, 0) = (signs & 1) != 0 ? -1 : 1;
                turn(second, 1) = (signs & 2) != 0 ? -1 : 1;
                turn.col(2) = turn.col(0).cross(turn.col(1));
                result.push_back(reference.axes * turn * copy.axes.transpose());
            }
    for (int i = 0; i < evenRotations; ++i) {
        const double s = i + 0.5;
        const double t = s / evenRotations;
        const double a = 2 * std::numbers::pi * s / std::numbers::sqrt2;
        const double b = 2 * std::numbers::pi * s / 1.533751168755204288118041;
        result.push_back(Eigen::Quaterniond(std::sqrt(1 - t) * std::cos(b), std::sqrt(t) * std::sin(a),
                                            std::sqrt(t) * std::cos(a), std::sqrt(1 - t) * std::sin(b))
                             .toRotationMatrix());
    }
    return result;
}

bool differ(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b, const Extent& copy)
{
    return Eigen::AngleAxisd(a.linear().transpose() * b.linear()).angle() > 0.15 ||
           (a * copy.centre_mm - b * copy.centre_mm).norm() > 0.08 * copy.size_mm;
}

void keepBest(std::vector<Pose>& poses, std::size_t count, const Extent& copy)
{
    std::stable_sort(poses.begin(), poses.end(), [](const Pose& a, const Pose& b) { return a.score < b.score; });
    std::vector<Pose> kept;
    for (const Pose& pose : poses) {
        if (kept.size() == count) break;
        if (std::all_of(kept.begin(), kept.end(),
                        [&](const Pose& other) { return differ(pose.reference_T_copy, other.reference_T_copy, copy); }))
            kept.push_back(pose);
    }
    poses = std::move(kept);
}

}  // namespace

std::vector<Eigen::Vector3d> thinOut(const std::vector<Eigen::Vector3d>& points_mm, double cell_mm,
                                     const Progress& progress)
{
    Box box;
    for (const auto& p : points_mm) box.add(p);
    const std::vector<std::uint32_t> order = hilbertOrder(points_mm, progress);
    struct Entry {
        std::array<std::int64_t, 3> cell;
        std::uint32_t rank;
    };
    std::vector<Entry> entries(order.size());
    parallelFor(order.size(), 1 << 15, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Eigen::Vector3d t = (points_mm[order[i]] - box.low_mm) / cell_mm;
            for (int a = 0; a < 3; ++a)
                entries[i].cell[static_cast<std::size_t>(a)] = static_cast<std::int64_t>(std::min(t[a], 1e15));
            entries[i].rank = static_cast<std::uint32_t>(i);
        }
    });
    std::sort(entries.begin(), entries.end(),
              [](const Entry& a, const Entry& b) { return a.cell != b.cell ? a.cell < b.cell : a.rank < b.rank; });
    progress.check();
    std::vector<std::uint32_t> kept;
    for (std::size_t i = 0; i < entries.size();) {
        std::size_t j = i;
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (; j < entries.size() && entries[j].cell == entries[i].cell; ++j) sum += points_mm[order[entries[j].rank]];
        const Eigen::Vector3d mean = sum / static_cast<double>(j - i);
        std::uint32_t best = entries[i].rank;
        for (std::size_t k = i; k < j; ++k)
            if ((points_mm[order[entries[k].rank]] - mean).squaredNorm() <
                (points_mm[order[best]] - mean).squaredNorm())
                best = entries[k].rank;
        kept.push_back(best);
        i = j;
    }
    std::sort(kept.begin(), kept.end());
    std::vector<Eigen::Vector3d> result;
    result.reserve(kept.size());
    for (std::uint32_t rank : kept) result.push_back(points_mm[order[rank]]);
    return result;
}

std::vector<Eigen::Isometry3d> findCoarsePoses(const std::vector<Eigen::Vector3d>& reference_mm,
                                               const std::vector<Eigen::Vector3d>& copy_mm, std::size_t count,
                                               const Progress& progress)
{
    const Extent reference = extentOf(reference_mm);
    const Extent copy = extentOf(copy_mm);
    const double size = std::max(reference.size_mm, copy.size_mm);
    const Neighbours reference_index(reference_mm, progress);
    const Neighbours copy_index(copy_mm, progress);
    const auto onReference = [&](const Eigen::Vector3d& q) {
        return reference_index.point_mm(reference_index.nearest(q).place);
    };
    const auto onCopy = [&](const Eigen::Vector3d& q) { return copy_index.point_mm(copy_index.nearest(q).place); };
    const NearestGrid field(reference_mm, reference_index, progress);
    const auto roughly = [&](const Eigen::Vector3d& q) -> const Eigen::Vector3d& { return field.nearest(q); };

    // Where part of a surface is missing the centroids do not coincide: seven translations for each rotation.
    const std::vector<Eigen::Matrix3d> rotations = startRotations(reference, copy);
    constexpr std::size_t places = 7;
    const Points few_points = everyNth(copy_mm, fewPoints);
    std::vector<Pose> poses(rotations.size() * places);
    parallelFor(poses.size(), 16, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const auto place = static_cast<int>(i % places);
            Eigen::Vector3d centre = reference.centre_mm;
            if (place > 0) centre += (place % 2 == 0 ? 0.2 : -0.2) * size * reference.axes.col((place - 1) / 2);
            Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
            pose.linear() = rotations[i / places];
            pose.translation() = centre - pose.linear() * copy.centre_mm;
            improvePose(pose, few_points, roughly, 7, 0.2 * size, 0.06 * size);
            poses[i] = {pose, roughMisfit(pose, few_points, roughly, 0.06 * size)};
        }
    });
    progress.report(0.5);
    keepBest(poses, keptStarts, copy);
    const Points several_points = everyNth(copy_mm, severalPoints);
    const Points several_reference = everyNth(reference_mm, severalPoints);
    parallelFor(poses.size(), 1, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            Eigen::Isometry3d& pose = poses[i].reference_T_copy;
            improvePose(pose, everyNth(copy_mm, 3 * fewPoints), roughly, 12, 0.08 * size, 0.03 * size);
            progress.check();
            improvePose(pose, several_points, onReference, 6, 0.03 * size, 0.015 * size);
            progress.check();
            poses[i].score = roughMisfit(pose, several_points, onReference, 0.03 * size) +
                             roughMisfit(pose.inverse(), several_reference, onCopy, 0.03 * size);
        }
    });
    keepBest(poses, count, copy);
    progress.report(1);
    std::vector<Eigen::Isometry3d> result;
    result.reserve(poses.size());
    for (const Pose& pose : poses) result.push_back(pose.reference_T_copy);
    return result;
}

}  // namespace lathelier::registration
