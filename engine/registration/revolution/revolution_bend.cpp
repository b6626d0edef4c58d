#include "engine/registration/revolution/revolution_bend.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/core/statistics.h"

namespace lathelier::registration {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// How the centres of the sections are found (README, "Thresholds").
struct BendFitThresholds {
    std::size_t sections = 24;         ///< over the length of the sides
    std::size_t least_sections = 6;    ///< with a centre
    double least_span = 1;             ///< from the first to the last of them, in halves of the length
    int least_side_bins = 3;           ///< from the first to the last side bin
    double rough_bin_points = 4;       ///< least number of points of a bin that a bend widens
    double rough_scatter_share = 0.1;  ///< of the radius: largest scatter of such a bin
    double steepest_slope = 0.3;       ///< dR/dz of a bin: beside an edge the fitted centre is biased
    double reach_share = 0.15;         ///< of the radius: points with a larger residual are spurious, and so is a bow
    std::size_t section_points = 12;   ///< least number for a circle
    double tukey_sigmas = 6;           ///< where the weights reach 0; efficiency 99 %
    int circle_rounds = 8;             ///< at most
    int curve_rounds = 10;
    double higher_sigmas = 5;           ///< of the terms above the parabola: smaller ones are none
    int chord_steps = 40;               ///< along the length, for the largest distance from the chord
    std::ptrdiff_t long_face_bins = 8;  ///< a longer run of bins with much scatter is bent, and no face
    double settled_share = 0.01;        ///< of the standard error, and of the scatter: a smaller change has settled
    double least_scale_share = 1e-9;    ///< of the reach: least scatter, for exact meshes
};
constexpr BendFitThresholds bendFit{};

constexpr double rayleighMedian = 1.177;  // √(2 ln 2), in standard deviations of each coordinate

struct SectionResidual {
    double cosine, sine, off;
};

struct Centre {
    double z;
    Vector2d place;
    double variance;  ///< of each coordinate, mm²
    double scatter;   ///< of the points about the circle
};

/// Robust circle about the section's own centre: off = c + x cos + y sin.
bool centreOf(const std::vector<SectionResidual>& section, double reach_mm, Centre& centre)
{
    if (section.size() < bendFit.section_points) return false;
    constexpr double tukeySigmas = bendFit.tukey_sigmas;
    Vector3d value = Vector3d::Zero();
    double scale = reach_mm;
    Eigen::Matrix3d normal;
    std::vector<double> sizes;
    for (int round = 0; round < bendFit.circle_rounds; ++round) {
        normal.setZero();
        Vector3d right = Vector3d::Zero();
        sizes.clear();
        for (const SectionResidual& r : section) {
            const Vector3d j(1, r.cosine, r.sine);
            const double e = r.off - j.dot(value);
            sizes.push_back(std::abs(e));
            const double w = tukeyWeight(e / scale);
            if (w == 0) continue;
            normal += w * j * j.transpose();
            right += w * e * j;
        }
        const Vector3d change = normal.ldlt().solve(right);
        if (!change.allFinite()) return false;
        value += change;
        const double middle = upperMedianInPlace(sizes);
        const double before = scale;
        scale = std::clamp(tukeySigmas * madToSigma * middle, bendFit.least_scale_share * reach_mm, reach_mm);
        const double error = scale / tukeySigmas / std::sqrt(static_cast<double>(section.size()));
        if (change.norm() < bendFit.settled_share * error && std::abs(scale - before) < bendFit.settled_share * scale)
            break;
    }
    const Eigen::Matrix3d covariance = normal.inverse() * (scale * scale / (tukeySigmas * tukeySigmas));
    centre.place = value.tail<2>();
    centre.scatter = scale / tukeySigmas;
    centre.variance = (covariance(1, 1) + covariance(2, 2)) / 2;
    return std::isfinite(centre.variance) && centre.variance > 0 && centre.variance < reach_mm * reach_mm;
}

/// Bins that belong to the same face as this one.
std::ptrdiff_t faceLengthOf(const MeridianBins& bins, std::size_t bin)
{
    return std::count(bins.face_of.begin(), bins.face_of.end(), bins.face_of[bin]);
}

/// A strong bend spreads the radii of a bin, which therefore has weight 0 in the axis fit or is taken for part of a
/// face; it is used here.
bool isSide(const MeridianBins& bins, std::size_t bin)
{
    const MeridianBin& b = bins.bins[bin];
    if (b.active) return true;
    if (b.points < bendFit.rough_bin_points || !(b.own_mm < bendFit.rough_scatter_share * bins.largest_mm))
        return false;
    return bins.face_of[bin] < 0 || faceLengthOf(bins, bin) > bendFit.long_face_bins;
}

/// isSide() of each bin.
std::vector<char> sidesOf(const MeridianBins& bins)
{
    std::vector<char> sides(static_cast<std::size_t>(bins.side_count));
    for (std::size_t i = 0; i < sides.size(); ++i) sides[i] = isSide(bins, i) ? 1 : 0;
    return sides;
}

/// The sides from the first bin to the last.
struct SideExtent {
    double start_mm = 0;
    double length_mm = 0;
};

/// nullopt: too short for a bend.
std::optional<SideExtent> sideExtentOf(const MeridianBins& bins, const std::vector<char>& sides)
{
    int from = -1;
    int to = 0;
    for (int i = 0; i < bins.side_count; ++i) {
        if (!sides[static_cast<std::size_t>(i)]) continue;
        if (from < 0) from = i;
        to = i + 1;
    }
    if (to - from < bendFit.least_side_bins) return std::nullopt;
    return SideExtent{bins.z_start_mm + from * bins.step_mm, (to - from) * bins.step_mm};
}

/// The residuals of the sides by section.
std::vector<std::vector<SectionResidual>> sectionsOf(const std::vector<Vector3d>& sample,
                                                     const Eigen::Isometry3d& axis_T_scan, const MeridianBins& bins,
                                                     const std::vector<char>& sides, const SideExtent& extent,
                                                     double reach_mm)
{
    const auto count = static_cast<double>(bendFit.sections);
    std::vector<std::vector<SectionResidual>> sections(bendFit.sections);
    for (const Vector3d& point : sample) {
        const Vector3d p = axis_T_scan * point;
        const double place = (p.z() - extent.start_mm) / extent.length_mm * count;
        const double r = p.head<2>().norm();
        if (!(place >= 0) || place >= count || r == 0) continue;
        const auto side = static_cast<std::size_t>((p.z() - bins.z_start_mm) / bins.step_mm);
        if (side >= static_cast<std::size_t>(bins.side_count)) continue;
        const MeridianBin& bin = bins.bins[side];
        if (!sides[side] || std::abs(bin.slope) > bendFit.steepest_slope) continue;
        const double off = r - bin.value - bin.slope * (p.z() - bin.middle);
        if (std::abs(off) < reach_mm) sections[static_cast<std::size_t>(place)].push_back({p.x() / r, p.y() / r, off});
    }
    return sections;
}

/// The centres that are found, by z from -1 to 1 over the extent.
std::vector<Centre> centresOf(const std::vector<std::vector<SectionResidual>>& sections, double reach_mm)
{
    std::vector<Centre> centres;
    const auto count = static_cast<double>(sections.size());
    for (std::size_t k = 0; k < sections.size(); ++k) {
        Centre centre{(2 * (static_cast<double>(k) + 0.5) / count - 1), Vector2d::Zero(), 1, 0};
        if (centreOf(sections[k], reach_mm, centre)) centres.push_back(centre);
    }
    return centres;
}

/// Curve through the centres: rows of `value` for the powers of z from 0 on, columns for x and y.
struct CentreLine {
    Eigen::MatrixX2d value;
    Eigen::MatrixXd normal;
    double scatter = 1;  ///< of the centres, in their standard uncertainties; at least 1

    Vector2d term(Eigen::Index power) const { return value.row(power).transpose(); }
};

Eigen::VectorXd powersOf(double z, Eigen::Index degree)
{
    Eigen::VectorXd powers(degree + 1);
    powers[0] = 1;
    for (Eigen::Index k = 1; k <= degree; ++k) powers[k] = powers[k - 1] * z;
    return powers;
}

/// Robust over the sections: an eccentric collar is no bend. nullopt: not determined.
std::optional<CentreLine> centreLineOf(const std::vector<Centre>& centres, Eigen::Index degree)
{
    CentreLine line;
    std::vector<double> weights(centres.size(), 1);
    for (int round = 0; round < bendFit.curve_rounds; ++round) {
        line.normal = Eigen::MatrixXd::Zero(degree + 1, degree + 1);
        Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(degree + 1, 2);
        for (std::size_t k = 0; k < centres.size(); ++k) {
            const Centre& c = centres[k];
            const Eigen::VectorXd j = powersOf(c.z, degree);
            const double w = weights[k] / c.variance;
            line.normal += w * j * j.transpose();
            right += w * j * c.place.transpose();
        }
        line.value = line.normal.ldlt().solve(right);
        if (!line.value.allFinite()) return std::nullopt;
        std::vector<double> sizes;
        for (const Centre& c : centres) {
            const Vector2d off = c.place - line.value.transpose() * powersOf(c.z, degree);
            sizes.push_back(off.norm() / std::sqrt(c.variance));
        }
        std::vector<double> sorted = sizes;
        line.scatter = std::max(1.0, upperMedianInPlace(sorted) / rayleighMedian);
        for (std::size_t k = 0; k < centres.size(); ++k)
            weights[k] = tukeyWeight(sizes[k] / (bendFit.tukey_sigmas * line.scatter));
    }
    return line;
}

/// A curve of the fourth degree where its terms above the parabola are significant; else none.
std::optional<CentreLine> quarticOf(const std::vector<Centre>& centres)
{
    constexpr Eigen::Index degree = 4;
    if (centres.size() < bendFit.least_sections + 2) return std::nullopt;
    std::optional<CentreLine> line = centreLineOf(centres, degree);
    if (!line) return std::nullopt;
    const Eigen::MatrixXd covariance = line->normal.inverse();
    for (const Eigen::Index power : {Eigen::Index{3}, degree}) {
        const double sigma = line->scatter * std::sqrt(std::max(0.0, covariance(power, power)));
        if (line->term(power).norm() > bendFit.higher_sigmas * sigma) return line;
    }
    return std::nullopt;
}

/// Largest distance from the chord between the ends.
double largestDistance_mm(const Bend& bend)
{
    double largest = 0;
    for (int k = 0; k <= bendFit.chord_steps; ++k) {
        const double t = 2.0 * k / bendFit.chord_steps - 1, square = t * t;
        const Vector3d off = bend.bow_mm * (1 - square) + bend.cubic_mm * (t * (1 - square)) +
                             bend.quartic_mm * (1.0 / 7 + square * (6.0 / 7 - square));
        largest = std::max(largest, off.norm());
    }
    return largest;
}

}  // namespace

Bend Bend::sum(const Bend& first, const Bend& rest)
{
    Bend both = first;
    const double scale = first.half_mm / rest.half_mm, square = scale * scale;
    both.bow_mm += rest.bow_mm * square;
    both.cubic_mm += rest.cubic_mm * (square * scale);
    both.quartic_mm += rest.quartic_mm * (square * square);
    both.largest_mm = largestDistance_mm(both);
    both.sigma_mm = rest.sigma_mm;
    both.scatter_mm = rest.scatter_mm;
    return both;
}

Bend findBend(const std::vector<Vector3d>& sample, const Eigen::Isometry3d& axis_T_scan, const MeridianBins& bins,
              BendShape shape)
{
    Bend bend;
    const std::vector<char> sides = sidesOf(bins);
    const std::optional<SideExtent> extent = sideExtentOf(bins, sides);
    if (!extent) return bend;
    const double reach_mm = bendFit.reach_share * bins.largest_mm;
    const std::vector<Centre> centres =
        centresOf(sectionsOf(sample, axis_T_scan, bins, sides, *extent, reach_mm), reach_mm);
    if (centres.size() < bendFit.least_sections || centres.back().z - centres.front().z < bendFit.least_span)
        return bend;
    std::vector<double> scatters;
    scatters.reserve(centres.size());
    for (const Centre& centre : centres) scatters.push_back(centre.scatter);
    bend.scatter_mm = upperMedianInPlace(scatters);
    std::optional<CentreLine> line;
    if (shape == BendShape::Quartic) line = quarticOf(centres);
    const bool is_quartic = line.has_value();
    if (!line) line = centreLineOf(centres, 2);
    if (!line) return bend;
    const auto inScan = [&](const Vector2d& term) {
        return Vector3d(axis_T_scan.linear().transpose() * Vector3d(term.x(), term.y(), 0));
    };
    bend.along = axis_T_scan.linear().row(2);
    bend.half_mm = extent->length_mm / 2;
    bend.middle_mm = extent->start_mm + extent->length_mm / 2 - axis_T_scan.translation().z();
    bend.bow_mm = inScan(line->term(2));
    if (is_quartic) {
        bend.cubic_mm = inScan(line->term(3));
        bend.quartic_mm = inScan(line->term(4));
        bend.bow_mm += 6.0 / 7 * bend.quartic_mm;  // t⁴ in terms of the polynomials of Bend
    }
    // At mid length the distance from the chord is the sum of the even terms above the constant.
    Eigen::VectorXd middle = Eigen::VectorXd::Zero(line->normal.rows());
    for (Eigen::Index power = 2; power < middle.size(); power += 2) middle[power] = 1;
    bend.sigma_mm = line->scatter * std::sqrt(std::max(0.0, middle.dot(line->normal.ldlt().solve(middle))));
    bend.largest_mm = largestDistance_mm(bend);
    return bend;
}

}  // namespace lathelier::registration
