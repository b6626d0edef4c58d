#include "engine/registration/revolution/meridian_bins.h"

#include <algorithm>
#include <cmath>

#include "engine/core/statistics.h"
#include "engine/registration/revolution/meridian_walls.h"

namespace lathelier::registration {
namespace {

/// How the meridian is divided into bins, and which of them count (README, "Thresholds").
struct MeridianBinThresholds {
    std::size_t sample_points = 30;    ///< of the sample for each bin along the part, on average
    int least_bins = 5;                ///< along the part
    double grid_margin = 1e-9;         ///< of a step: the last point lies within the last bin
    double least_points = 4;           ///< of a bin, for a median and a scatter
    double least_share = 0.15;         ///< of the median over a wall's bins: with fewer points a bin does not count
    double least_sigma_share = 1e-5;   ///< of the extent: least scatter, for exact meshes
    double slope_noise_sigmas = 4;     ///< standard errors of a median: smaller rises from bin to bin are noise
    double slope_change_share = 0.5;   ///< largest relative change of the rise from one side of a bin to the other
    double edge_scatter_ratio = 2.5;   ///< to the median scatter of the bins: above it a bin contains an edge
    double rough_scatter_ratio = 1.7;  ///< to the scatter of the quiet bins: above it a bin is rough
    double quiet_quantile = 0.2;       ///< of the scatters of the bins: that of quiet ones
    double quiet_margin = 1.1;         ///< the quantile times this has to be a third below the median
    double quiet_bin_points = 20;      ///< least number of points of a bin for that quantile
    std::size_t quiet_bins = 15;       ///< least number of bins for it
    double least_face_share = 0.02;    ///< of all points: a face with fewer adds more systematic error than information
    std::ptrdiff_t long_face_bins = 8;  ///< a longer run beside quiet bins may be rough
    double rough_face_share = 0.2;      ///< of the run's length: with a larger scatter along the axis it is rough
};
constexpr MeridianBinThresholds binThresholds{};

/// Least number of points with which a bin of a wall counts.
double leastPointsOf(const BinOrder& sorted)
{
    std::vector<double> filled;
    for (std::size_t b = 0; b + 1 < sorted.first.size(); ++b)
        if (sorted.first[b + 1] > sorted.first[b])
            filled.push_back(static_cast<double>(sorted.first[b + 1] - sorted.first[b]));
    return std::max(binThresholds.least_points, binThresholds.least_share * upperMedianInPlace(filled));
}

/// Slopes from both neighbours where they agree on one; 0 elsewhere (an edge, a lone bin, or flat within the noise).
void slopesOf(MeridianBin* bins, int count, double step)
{
    for (int i = 0; i < count; ++i) {
        MeridianBin& bin = bins[i];
        bin.slope = 0;
        if (!bin.active) continue;
        const bool before = i > 0 && bins[i - 1].active;
        const bool after = i + 1 < count && bins[i + 1].active;
        if (before && after) {
            const double rise1 = bin.value - bins[i - 1].value;
            const double rise2 = bins[i + 1].value - bin.value;
            const double both = std::abs(rise1 + rise2);
            const double noise = binThresholds.slope_noise_sigmas * bin.sigma / std::sqrt(std::max(1.0, bin.points));
            if (std::abs(rise1 - rise2) < noise + binThresholds.slope_change_share * both / 2 && both > noise)
                bin.slope = (rise1 + rise2) / (2 * step);
        }
        bin.cosine = 1 / std::sqrt(1 + bin.slope * bin.slope);
    }
}

/// Scatter of a bin and the number of points it was found from.
struct Scatter {
    double sigma;
    double points;
};

double typical(const std::vector<Scatter>& scatters)
{
    std::vector<double> values;
    values.reserve(scatters.size());
    for (const Scatter& s : scatters) values.push_back(s.sigma);
    return values.empty() ? 0.0 : upperMedianInPlace(values);
}

/// 20 % quantile of the scatter of the bins when it is lower than the median by a third (then the median is that of a
/// thread or a knurl); else 0. Bins with few points are left out: their scatter is too uncertain.
double quiet(const std::vector<Scatter>& scatters, double middle)
{
    std::vector<double> values;
    for (const Scatter& s : scatters)
        if (s.points >= binThresholds.quiet_bin_points) values.push_back(s.sigma);
    if (values.size() < binThresholds.quiet_bins) return 0;
    const double fifth = quantileInPlace(values, binThresholds.quiet_quantile);
    return binThresholds.quiet_margin * fifth < middle * 2 / 3 ? fifth : 0;
}

/// Median and scatter of each bin; bins without enough points stay inactive.
template <class Along, class Across>
std::vector<Scatter> fillBins(MeridianBin* bins, int count, double start, double step, const BinOrder& sorted,
                              Along along, Across across, double least_points)
{
    std::vector<double> values;
    for (int b = 0; b < count; ++b) {
        MeridianBin& bin = bins[b];
        bin.middle = start + (b + 0.5) * step;
        values.clear();
        const auto bin_index = static_cast<std::size_t>(b);
        for (std::size_t k = sorted.first[bin_index]; k < sorted.first[bin_index + 1]; ++k)
            values.push_back(across(sorted.items[k]));
        bin.points = static_cast<double>(values.size());
        bin.active = bin.points >= least_points;
        if (!values.empty()) bin.value = upperMedianInPlace(values);
    }
    const auto measure = [&] {
        std::vector<Scatter> scatters;
        for (int b = 0; b < count; ++b) {
            MeridianBin& bin = bins[b];
            const auto bin_index = static_cast<std::size_t>(b);
            if (!bin.active) continue;
            values.clear();
            for (std::size_t k = sorted.first[bin_index]; k < sorted.first[bin_index + 1]; ++k) {
                const std::size_t i = sorted.items[k];
                values.push_back(std::abs(across(i) - bin.value - bin.slope * (along(i) - bin.middle)));
            }
            bin.sigma = bin.own_mm = madToSigma * upperMedianInPlace(values) * bin.cosine;
            scatters.push_back({bin.sigma, bin.points});
        }
        return scatters;
    };
    measure();
    slopesOf(bins, count, step);
    return measure();
}

/// Makes the bins of a sample: grid, walls, then faces.
class BinMaker {
public:
    BinMaker(const std::vector<Eigen::Vector3d>& sample, const Eigen::Isometry3d& axis_T_scan, int count)
        : places_(meridianSampleOf(sample, axis_T_scan))
    {
        layOut(count);
        byZ_ = sortInto(sides_, places_.points.size(), [&](std::size_t i) { return sideOf(i); });
        result_.split_mm = findSplits(sample, axis_T_scan, places_, byZ_);
        bored_ = std::any_of(result_.split_mm.begin(), result_.split_mm.end(), [](double s) { return s == s; });
        if (!bored_) result_.split_mm.clear();
    }

    MeridianBins make()
    {
        leaveOutRough(fillWalls());
        const int faces = findFaces();
        const std::size_t walls = result_.bins.size();
        result_.bins.resize(walls + static_cast<std::size_t>(faces * result_.face_columns));
        for (int f = 0; f < faces; ++f)
            fillFace(f, result_.bins.data() + walls + static_cast<std::size_t>(f * result_.face_columns));
        return std::move(result_);
    }

private:
    int sideOf(std::size_t i) const
    {
        return std::min(result_.side_count - 1,
                        static_cast<int>((places_.points[i].z - places_.low_mm) / result_.step_mm));
    }
    bool isInBore(std::size_t i) const
    {
        return bored_ && places_.points[i].r < result_.split_mm[static_cast<std::size_t>(sideOf(i))];
    }
    auto axialPlace() const
    {
        return [this](std::size_t i) { return places_.points[i].z; };
    }
    auto radius() const
    {
        return [this](std::size_t i) { return places_.points[i].r; };
    }
    std::size_t pointsOnSide(std::size_t bin) const { return byZ_.first[bin + 1] - byZ_.first[bin]; }

    /// The grid of bins, for a wished number along the part.
    void layOut(int count)
    {
        count = std::clamp(static_cast<int>(places_.points.size() / binThresholds.sample_points),
                           binThresholds.least_bins, count);
        const double length_mm = places_.high_mm - places_.low_mm;
        const double extent_mm = std::max(length_mm, places_.largest_mm);
        result_.step_mm = extent_mm / count * (1 + binThresholds.grid_margin);
        result_.z_start_mm = places_.low_mm;
        result_.size_mm = extent_mm / 2;
        result_.largest_mm = places_.largest_mm;
        result_.side_count = static_cast<int>(length_mm / result_.step_mm) + 1;
        result_.face_columns = static_cast<int>(places_.largest_mm / result_.step_mm) + 1;
        sides_ = static_cast<std::size_t>(result_.side_count);
        leastSigma_mm_ = binThresholds.least_sigma_share * extent_mm;
    }

    /// The bins of the side and of the bore; gives their scatters.
    std::vector<Scatter> fillWalls()
    {
        const auto wall = [&](MeridianBin* bins, const BinOrder& sorted, double least_points) {
            return fillBins(bins, result_.side_count, places_.low_mm, result_.step_mm, sorted, axialPlace(), radius(),
                            least_points);
        };
        const auto sorted = [&](bool of_bore) {
            return sortInto(sides_, places_.points.size(),
                            [&, of_bore](std::size_t i) { return isInBore(i) == of_bore ? sideOf(i) : -1; });
        };
        result_.wall_count = bored_ ? 2 * result_.side_count : result_.side_count;
        result_.bins.resize(static_cast<std::size_t>(result_.wall_count));
        if (bored_) byZ_ = sorted(false);
        leastPoints_ = leastPointsOf(byZ_);
        std::vector<Scatter> scatters = wall(result_.bins.data(), byZ_, leastPoints_);
        if (bored_) {
            const BinOrder bore = sorted(true);
            const std::vector<Scatter> own = wall(result_.bins.data() + sides_, bore, leastPointsOf(bore));
            scatters.insert(scatters.end(), own.begin(), own.end());
        }
        return scatters;
    }

    /// Bins of side and bore that scatter more than the others contain an edge or a face, or are rough.
    void leaveOutRough(const std::vector<Scatter>& scatters)
    {
        const double middle = typical(scatters);
        quiet_mm_ = quiet(scatters, middle);
        result_.sigma_mm = std::max(leastSigma_mm_, quiet_mm_ > 0 ? quiet_mm_ : middle);
        const double ratio = quiet_mm_ > 0 ? binThresholds.rough_scatter_ratio : binThresholds.edge_scatter_ratio;
        const double most_scatter = ratio * result_.sigma_mm;
        for (MeridianBin& bin : result_.bins) {
            if (bin.active && bin.sigma > most_scatter) bin.active = false;
            bin.sigma = result_.sigma_mm;
        }
    }

    /// Runs of side bins that do not count become faces where they have enough points. Gives the number of faces.
    int findFaces()
    {
        result_.face_of.assign(sides_, -1);
        std::vector<std::size_t> face_points;
        for (std::size_t b = 0; b < sides_; ++b) {
            if (result_.bins[b].active || static_cast<double>(pointsOnSide(b)) < leastPoints_ / 2) continue;
            const bool goes_on = b > 0 && result_.face_of[b - 1] >= 0;
            if (!goes_on) face_points.push_back(0);
            result_.face_of[b] = static_cast<int>(face_points.size()) - 1;
            face_points.back() += pointsOnSide(b);
        }
        std::vector<int> kept(face_points.size(), -1);
        int faces = 0;
        const double least_face = binThresholds.least_face_share * static_cast<double>(places_.points.size());
        for (std::size_t f = 0; f < face_points.size(); ++f)
            if (static_cast<double>(face_points[f]) > least_face) kept[f] = faces++;
        for (int& face : result_.face_of)
            if (face >= 0) face = kept[static_cast<std::size_t>(face)];
        return faces;
    }

    /// The bins of face `f`; none count where the run is rough: long, beside quiet bins, and with points anywhere along
    /// it.
    void fillFace(int f, MeridianBin* own)
    {
        const int columns = result_.face_columns;
        const auto columnOf = [&](std::size_t i) {
            const int column = static_cast<int>(places_.points[i].r / result_.step_mm);
            const bool is_own =
                !isInBore(i) && result_.face_of[static_cast<std::size_t>(sideOf(i))] == f && column < columns;
            return is_own ? column : -1;
        };
        const BinOrder by_r = sortInto(static_cast<std::size_t>(columns), places_.points.size(), columnOf);
        const double scatter =
            std::max(leastSigma_mm_, typical(fillBins(own, columns, 0, result_.step_mm, by_r, radius(), axialPlace(),
                                                      binThresholds.least_points)));
        for (int c = 0; c < columns; ++c) {
            if (own[c].sigma > binThresholds.edge_scatter_ratio * scatter) own[c].active = false;
            own[c].sigma = scatter;
        }
        const auto length = std::count(result_.face_of.begin(), result_.face_of.end(), f);
        if (quiet_mm_ > 0 && length > binThresholds.long_face_bins &&
            scatter > binThresholds.rough_face_share * static_cast<double>(length) * result_.step_mm) {
            for (int c = 0; c < columns; ++c) own[c].active = false;
            std::replace(result_.face_of.begin(), result_.face_of.end(), f, -1);
        }
    }

    MeridianSample places_;
    MeridianBins result_;
    BinOrder byZ_;  ///< points of the side
    std::size_t sides_ = 0;
    double leastPoints_ = 0;  ///< of a side bin that counts
    double leastSigma_mm_ = 0;
    double quiet_mm_ = 0;  ///< scatter of the quiet bins; 0: no rough zones
    bool bored_ = false;
};

}  // namespace

MeridianBins makeBins(const std::vector<Eigen::Vector3d>& sample, const Eigen::Isometry3d& axis_T_scan, int count)
{
    return BinMaker(sample, axis_T_scan, count).make();
}

void refineSlopes(MeridianBins& bins)
{
    slopesOf(bins.bins.data(), bins.side_count, bins.step_mm);
    if (bins.wall_count > bins.side_count) slopesOf(bins.bins.data() + bins.side_count, bins.side_count, bins.step_mm);
    for (std::size_t first = static_cast<std::size_t>(bins.wall_count); first < bins.bins.size();
         first += static_cast<std::size_t>(bins.face_columns))
        slopesOf(bins.bins.data() + first, bins.face_columns, bins.step_mm);
}

}  // namespace lathelier::registration
