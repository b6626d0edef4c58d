// g++ 12 at -O3 takes Eigen's zero-sized temporaries for values without initialisation.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#include "engine/registration/general/general_uncertainty.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

namespace lathelier::registration {
namespace {

constexpr int finestLevel = 6;             // cells of 1/64 of the largest ones
constexpr double largestClusterShare = 1;  // of the radius of gyration
constexpr std::size_t mostClusterRuns = 4096;
constexpr std::size_t leastClusters = 16;
constexpr double leastMeanWeight = 0.4;  // of the mean weight: below it the pose is no minimum of the robust sum
constexpr double growing = 1.2;          // from one size of clusters to the next

// Sum of the score contributions (weight × J × residual) of the points of one cluster.
struct ClusterScore {
    std::uint64_t key = 0;
    Vector6d sum = Vector6d::Zero();
};

Vector6d scoreOf(const MotionSystem& system, const MotionResidual& r)
{
    const Eigen::Vector3d q = (r.point_mm - system.centre_mm) / system.gyration_mm;
    Vector6d j;
    j << q.cross(r.normal), r.normal;
    return r.weight * r.distance_mm * j;
}

// Interleaved bits of three cell indices (Morton code): a cell of twice the size has the same code without its last
// three bits.
std::uint64_t interleave(const std::array<std::uint32_t, 3>& cell)
{
    std::uint64_t key = 0;
    for (int bit = 20; bit >= 0; --bit)
        for (const std::uint32_t c : cell) key = key << 1 | (c >> bit & 1U);
    return key;
}

// For independent residuals the largest of several estimates exceeds the true value by about a seventh by chance: that
// is subtracted, and less of it the larger the excess.
double allowForChance(double independent, double largest)
{
    if (!(largest > independent)) return independent;
    const double excess = largest / independent;
    const double chance = 0.15 * std::clamp((1.6 - excess) / 0.3, 0.0, 1.0);
    return std::max(independent, largest / (1 + chance));
}

class Clusters {
public:
    Clusters(const MotionSystem& system, const Observability& observability, double sigma_mm,
             const std::vector<MotionResidual>& residuals)
        : system_(system), residuals_(residuals), independent_(uncertainty(system, observability, sigma_mm))
    {
        double weights = 0;
        double slopes = 0;
        for (const MotionResidual& r : residuals) {
            weights += r.weight;
            slopes += r.slope;
        }
        bread_ = observability.inverse / std::max(leastMeanWeight, weights > 0 ? slopes / weights : 1);
        scores_.reserve(residuals.size());
        for (const MotionResidual& r : residuals) scores_.push_back(scoreOf(system, r));
    }

    void bySpace()
    {
        const double cell = largestClusterShare * system_.gyration_mm / (1 << finestLevel);
        std::vector<std::pair<std::uint64_t, std::uint32_t>> order;
        for (std::uint32_t i = 0; i < residuals_.size(); ++i) {
            const Eigen::Vector3d t = (residuals_[i].point_mm - system_.centre_mm) / cell;
            std::array<std::uint32_t, 3> place{};
            for (int a = 0; a < 3; ++a)
                place[static_cast<std::size_t>(a)] =
                    static_cast<std::uint32_t>(std::clamp(std::floor(t[a]), -1e6, 1e6 - 1) + (1 << 20));
            order.emplace_back(interleave(place), i);
        }
        std::sort(order.begin(), order.end());
        std::vector<ClusterScore> cells;
        for (const auto& [key, i] : order) {
            if (cells.empty() || cells.back().key != key) cells.push_back({key});
            cells.back().sum += scores_[i];
        }
        grow(std::move(cells), 3);
    }

    template <class Input>
    void byRuns(Input input)
    {
        std::uint32_t last = 0;
        for (const MotionResidual& r : residuals_) last = std::max(last, input(r));
        if (last == 0) return;
        std::vector<ClusterScore> runs(mostClusterRuns);
        for (std::size_t k = 0; k < runs.size(); ++k) runs[k].key = k;
        for (std::size_t i = 0; i < residuals_.size(); ++i)
            runs[std::uint64_t{input(residuals_[i])} * mostClusterRuns / (std::uint64_t{last} + 1)].sum += scores_[i];
        std::erase_if(runs, [](const ClusterScore& run) { return run.sum.isZero(0); });
        grow(std::move(runs), 1);
    }

    AlignmentUncertainty result() const
    {
        return {allowForChance(independent_.axial_um, largest_.axial_um),
                allowForChance(independent_.radial_um, largest_.radial_um),
                allowForChance(independent_.axis_deg, largest_.axis_deg)};
    }

private:
    AlignmentUncertainty of(const std::vector<ClusterScore>& clusters) const
    {
        Matrix6d filling = Matrix6d::Zero();
        for (const ClusterScore& c : clusters) filling += c.sum * c.sum.transpose();
        const auto count = static_cast<double>(clusters.size());
        return uncertaintyOf(system_, count / (count - 6) * bread_ * filling * bread_);
    }

    // Merges clusters whose keys agree but for the last bits, repeatedly.
    void grow(std::vector<ClusterScore> clusters, int bits)
    {
        AlignmentUncertainty before;
        AlignmentUncertainty here;
        for (; clusters.size() >= leastClusters; shorten(clusters, bits)) {
            before = here;
            here = of(clusters);
            largest_.axial_um = std::max(largest_.axial_um, here.axial_um);
            largest_.radial_um = std::max(largest_.radial_um, here.radial_um);
            largest_.axis_deg = std::max(largest_.axis_deg, here.axis_deg);
        }
        // The correlation length may exceed the largest clusters.
        const auto further = [](double& largest, double a, double b) {
            if (a > 0 && b > growing * a) largest = std::max(largest, b * std::min(b / a, 2.0));
        };
        further(largest_.axial_um, before.axial_um, here.axial_um);
        further(largest_.radial_um, before.radial_um, here.radial_um);
        further(largest_.axis_deg, before.axis_deg, here.axis_deg);
    }

    static void shorten(std::vector<ClusterScore>& clusters, int bits)
    {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < clusters.size(); ++i) {
            const ClusterScore next{clusters[i].key >> bits, clusters[i].sum};
            if (kept > 0 && clusters[kept - 1].key == next.key)
                clusters[kept - 1].sum += next.sum;
            else
                clusters[kept++] = next;
        }
        clusters.resize(kept);
    }

    const MotionSystem& system_;
    const std::vector<MotionResidual>& residuals_;
    std::vector<Vector6d> scores_;
    Matrix6d bread_;
    AlignmentUncertainty independent_;
    AlignmentUncertainty largest_;
};

}  // namespace

AlignmentUncertainty clusteredUncertainty(const MotionSystem& system, const Observability& observability,
                                          double sigma_mm, const std::vector<MotionResidual>& residuals)
{
    Clusters clusters(system, observability, sigma_mm, residuals);
    clusters.bySpace();
    clusters.byRuns([](const MotionResidual& r) { return r.copy_input; });
    clusters.byRuns([](const MotionResidual& r) { return r.reference_input; });
    return clusters.result();
}

}  // namespace lathelier::registration
