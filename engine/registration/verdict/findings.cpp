// g++ 12 at -O3 takes Eigen's zero-sized temporaries for values without initialisation.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#include "engine/registration/verdict/findings.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "engine/core/statistics.h"
#include "engine/registration/verdict/surface_cells.h"

namespace lathelier::registration {
namespace {

/// Which differences are reported (registration/README.md, "Thresholds").
struct FindingThresholds {
    std::size_t most_findings = 8;
    std::size_t most_bumps = 3;
    double significance_sigmas = 4;     ///< of a step, a taper, a barrel
    double smallest_mm = 0.002;         ///< upper bound of the systematic errors of the method
    double least_limit_share = 0.1;     ///< of the half-width of the limits: smaller differences are not reported
    std::size_t taper_rings = 4;        ///< least number of rings for a taper,
    std::size_t barrel_rings = 8;       ///< and for a barrel
    double ring_window_mm = 10;         ///< size whose variance inflation is that of a ring
    double bump_allowance = 0.5;        ///< added to the factor of the extreme: a false bump is worse than a missed one
    double longest_bump_share = 0.3;    ///< of its stretch
    double bump_height_coverage = 2.5;  ///< of the height without limits: that is selected among a few windows
    double bump_distance = 1.5;         ///< of the sum of two windows' sizes: nearer ones belong to one bump
    double least_bump_part = 10;        ///< 1 / n of the excess of the most significant: lesser ones are left out
    double shortest_missing_mm = 1;     ///< least length of rings without points
    double missing_point_share = 0.02;  ///< of the usual number of points of a ring: fewer count as none
    double least_variance_mm2 = 1e-18;  ///< of the mean of a ring, for exact data
    double limited_first = 1000;        ///< in the order: differences with limits come before those without
};
constexpr FindingThresholds findingThresholds{};

/// The form of one stretch: ends (mean of both), half the change from end to end, middle above the mean of the ends.
struct Form {
    std::size_t stretch = 0;
    double start_mm = 0, end_mm = 0;
    Eigen::Vector3d value = Eigen::Vector3d::Zero(), sigma = Eigen::Vector3d::Zero();

    double at(double z) const
    {
        if (end_mm <= start_mm) return value[0];  // a face
        const double x = 2 * (z - start_mm) / (end_mm - start_mm) - 1;
        return value[0] + value[1] * x + value[2] * (1 - x * x);
    }
};

/// Weighted least squares over the rings, with the first `terms` of (1, x, 1 - x²) but those that are not `wanted`.
void fit(const SurfaceWindows& all, const std::vector<const SurfaceRow*>& rings, double ring_alike,
         const std::array<bool, 3>& wanted, Form& form)
{
    const MeridianStretch& stretch = all.stretches[form.stretch];
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    const auto row = [&](const SurfaceRow& ring) {
        const double x =
            2 * ((ring.z_start_mm + ring.z_end_mm) / 2 - form.start_mm) / (form.end_mm - form.start_mm) - 1;
        return Eigen::Vector3d(1, wanted[1] ? x : 0, wanted[2] ? 1 - x * x : 0);
    };
    const auto varianceOf = [&](const SurfaceRow& ring) {
        const double extent = stretch.isFace() ? stretch.extent_mm() : ring.z_end_mm - ring.z_start_mm;
        const double bins = std::max(1.0, extent / stretch.reference_step_mm);
        return ring_alike * all.scatter_mm * all.scatter_mm / ring.points +
               stretch.reference_sigma_mm * stretch.reference_sigma_mm / bins + findingThresholds.least_variance_mm2;
    };
    for (const SurfaceRow* ring : rings) {
        const Eigen::Vector3d j = row(*ring);
        normal += j * j.transpose() / varianceOf(*ring);
        right += j * ring->mean_mm / varianceOf(*ring);
    }
    for (int k = 1; k < 3; ++k)
        if (!wanted[static_cast<std::size_t>(k)]) normal(k, k) = 1;
    const Eigen::Matrix3d inverse = normal.inverse();
    form.value = inverse * right;
    double chi2 = 0;
    for (const SurfaceRow* ring : rings)
        chi2 += std::pow(ring->mean_mm - row(*ring).dot(form.value), 2) / varianceOf(*ring);
    const double degrees = std::max(1.0, static_cast<double>(rings.size()) - 3);
    const double inflation = std::max(1.0, chi2 / degrees);  // the residual form counts as noise
    form.sigma = (inverse.diagonal() * inflation).cwiseSqrt();
    const Eigen::Vector3d facing =
        stretch.isFace() ? Eigen::Vector3d(stretch.facing * all.axis_T_reference->linear().row(2).transpose())
                         : meanNormal(all, form.start_mm, form.end_mm);
    const double fixed = meanSigma_mm(all, form.start_mm, form.end_mm, std::numeric_limits<double>::infinity(), facing);
    form.sigma[0] = std::hypot(form.sigma[0], fixed);
    for (std::size_t k = 1; k < 3; ++k)
        if (!wanted[k]) form.value[static_cast<int>(k)] = form.sigma[static_cast<int>(k)] = 0;
}

double inflationFor(const SurfaceWindows& all, double size_mm)
{
    double variance_inflation = 1;
    for (const auto& [size, here] : all.variance_inflation)
        if (size <= std::max(size_mm, all.variance_inflation.front().first))
            variance_inflation = std::max(variance_inflation, here);
    return variance_inflation;
}

bool isSignificant(double value, double sigma, const std::optional<DeviationLimits>& limits)
{
    const double of_limits = limits ? findingThresholds.least_limit_share * limits->half_mm() : 0;
    const double least = std::max(findingThresholds.smallest_mm, of_limits);
    return std::abs(value) > findingThresholds.significance_sigmas * sigma && std::abs(value) > least;
}

/// The rings of a stretch that have points, of a face its mean.
std::vector<const SurfaceRow*> ringsWithPoints(const SurfaceWindows& all, std::size_t stretch)
{
    const auto number = static_cast<std::int32_t>(stretch);
    std::vector<const SurfaceRow*> rings;
    double most = 0;
    for (const SurfaceRow& face : all.faces)
        if (face.stretch == number) rings.push_back(&face);
    for (const SurfaceRow& ring : all.rows)
        if (ring.stretch == number) most = std::max(most, ring.points);
    for (const SurfaceRow& ring : all.rows)
        if (ring.stretch == number && ring.points > findingThresholds.missing_point_share * most)
            rings.push_back(&ring);
    return rings;
}

/// Forms of all stretches with enough rings, without the terms that are not significant.
std::vector<Form> formsOf(const SurfaceWindows& all, const LimitsAlong& limits)
{
    std::vector<Form> forms;
    const double variance_inflation = inflationFor(all, findingThresholds.ring_window_mm);
    for (std::size_t s = 0; s < all.stretches.size(); ++s) {
        const std::vector<const SurfaceRow*> rings = ringsWithPoints(all, s);
        if (rings.empty()) continue;
        Form form;
        form.stretch = s;
        form.start_mm = rings.front()->z_start_mm;
        form.end_mm = rings.back()->z_end_mm;
        const auto here = limits.between(form.start_mm, form.end_mm);
        std::array<bool, 3> wanted{true, rings.size() >= findingThresholds.taper_rings,
                                   rings.size() >= findingThresholds.barrel_rings};
        fit(all, rings, variance_inflation, wanted, form);
        if (wanted[2] && !isSignificant(form.value[2], form.sigma[2], here)) {
            wanted[2] = false;
            fit(all, rings, variance_inflation, wanted, form);
        }
        if (wanted[1] && !isSignificant(2 * form.value[1], 2 * form.sigma[1], here)) {
            wanted[1] = false;
            fit(all, rings, variance_inflation, wanted, form);
        }
        forms.push_back(form);
    }
    return forms;
}

/// A mean corrected for the sagitta of the facets.
double withoutFacets(const SurfaceWindows& all, std::size_t stretch, double value)
{
    SurfaceWindow window;
    window.mean_mm = static_cast<float>(value);
    window.stretch = static_cast<std::int32_t>(stretch);
    return judgedMean_mm(all, window);
}

void judgeFinding(const SurfaceWindows& all, Finding& finding, const DeviationLimits& limits, DecisionRule rule)
{
    const bool is_form = finding.kind == Finding::Kind::Taper || finding.kind == Finding::Kind::Barrel;
    const double width = limits.upper_mm - limits.lower_mm;
    const DeviationLimits by = is_form ? DeviationLimits{-width, width} : limits;
    finding.limit_mm = finding.value_mm < 0 ? -by.lower_mm : by.upper_mm;
    finding.verdict = judgeMean(all, finding.value_mm, finding.uncertainty_mm, by, rule);
}

/// `factor`: coverage factor of the uncertainties.
void describeForm(const SurfaceWindows& all, const Form& form, const LimitsAlong& limits, DecisionRule rule,
                  double factor, std::vector<Finding>& findings)
{
    const auto here = limits.between(form.start_mm, form.end_mm);
    const auto add = [&](Finding::Kind kind, double value, double sigma) {
        if (!isSignificant(value, sigma, here)) return;
        Finding finding;
        finding.kind = kind;
        finding.z_start_mm = form.start_mm;
        finding.z_end_mm = form.end_mm;
        finding.value_mm = value;
        finding.uncertainty_mm = factor * sigma;
        if (here) judgeFinding(all, finding, *here, rule);
        findings.push_back(finding);
    };
    add(Finding::Kind::Step, withoutFacets(all, form.stretch, form.value[0]), form.sigma[0]);
    add(Finding::Kind::Taper, 2 * form.value[1], 2 * form.sigma[1]);
    add(Finding::Kind::Barrel, form.value[2], form.sigma[2]);
}

/// A window that differs significantly from the form of its stretch.
struct Bump {
    double excess = 0;  ///< of the difference over its allowance
    double beyond = 0;  ///< the difference
    const SurfaceWindow* window = nullptr;
};

std::vector<Bump> bumpsOf(const SurfaceWindows& all, const std::vector<Form>& forms, const LimitsAlong& limits)
{
    const double allowance = all.factor + findingThresholds.bump_allowance;
    std::vector<const Form*> by_stretch(all.stretches.size(), nullptr);
    for (const Form& form : forms) by_stretch[form.stretch] = &form;
    std::vector<Bump> bumps;
    for (const SurfaceWindow& w : all.windows) {
        const auto start = static_cast<double>(w.z_start_mm);
        const auto end = static_cast<double>(w.z_end_mm);
        double usual = 0;
        if (w.stretch >= 0) {
            const Form* form = by_stretch[static_cast<std::size_t>(w.stretch)];
            if (!form) continue;
            const double extent_mm = all.stretches[form->stretch].extent_mm();
            if (static_cast<double>(w.size_mm) > findingThresholds.longest_bump_share * extent_mm) continue;
            usual = form->at((start + end) / 2);
        }
        const double rest = std::abs(judgedMean_mm(all, w) - usual) - (usual > 0 ? all.facets_mm : 0);
        const double excess = rest - allowance * static_cast<double>(w.sigma_mm);
        if (excess <= findingThresholds.smallest_mm) continue;
        const auto here = limits.between(start, end);
        if (here && rest < findingThresholds.least_limit_share * here->half_mm()) continue;
        bumps.push_back({excess, rest, &w});
    }
    return bumps;
}

/// The most significant window may extend beyond the bump: its height is that of a window no larger that contains its
/// middle.
Bump topOf(const std::vector<Bump>& bumps, const Bump& best, double coverage)
{
    const auto heightOf = [coverage](const Bump& b) {
        return b.beyond - coverage * static_cast<double>(b.window->sigma_mm);
    };
    Bump top = best;
    for (const Bump& b : bumps)
        if ((b.window->place_mm - best.window->place_mm).norm() < best.window->size_mm / 2 &&
            b.window->size_mm <= best.window->size_mm && heightOf(b) > heightOf(top))
            top = b;
    return top;
}

/// The most significant bumps that do not overlap, in order of falling significance.
std::vector<Bump> separateBumps(std::vector<Bump> bumps, double coverage)
{
    std::vector<Bump> kept;
    while (kept.size() < findingThresholds.most_bumps && !bumps.empty()) {
        const Bump best = *std::max_element(bumps.begin(), bumps.end(),
                                            [](const Bump& a, const Bump& b) { return a.excess < b.excess; });
        kept.push_back(topOf(bumps, best, coverage));
        std::erase_if(bumps, [&](const Bump& b) {
            const auto reach = static_cast<double>(b.window->size_mm + best.window->size_mm);
            return static_cast<double>((b.window->place_mm - best.window->place_mm).norm()) <
                       findingThresholds.bump_distance * reach ||
                   b.excess < best.excess / findingThresholds.least_bump_part;
        });
    }
    return kept;
}

void findBumps(const SurfaceWindows& all, const std::vector<Form>& forms, const LimitsAlong& limits, DecisionRule rule,
               double factor, std::vector<Finding>& findings)
{
    if (!all.has_sign && all.axis_T_reference) return;
    const double coverage = limits.any() ? factor : findingThresholds.bump_height_coverage;
    for (const Bump& bump : separateBumps(bumpsOf(all, forms, limits), coverage)) {
        const SurfaceWindow& w = *bump.window;
        const auto start = static_cast<double>(w.z_start_mm);
        const auto end = static_cast<double>(w.z_end_mm);
        Finding finding;
        finding.kind = Finding::Kind::Bump;
        finding.point_mm = w.place_mm.cast<double>();
        if (all.axis_T_reference) {
            finding.z_start_mm = start;
            finding.z_end_mm = end;
        }
        finding.value_mm = judgedMean_mm(all, w);
        finding.uncertainty_mm = coverage * static_cast<double>(w.sigma_mm);
        if (const auto here = limits.between(start, end)) judgeFinding(all, finding, *here, rule);
        findings.push_back(finding);
    }
}

/// Runs of rings without points between rings that have some.
void findMissing(const SurfaceWindows& all, std::vector<Finding>& findings)
{
    std::vector<double> counts;
    for (const SurfaceRow& ring : all.rows) counts.push_back(ring.points / (ring.z_end_mm - ring.z_start_mm));
    if (counts.empty()) return;
    const double least = findingThresholds.missing_point_share * upperMedianInPlace(counts);
    const auto isThere = [&](const SurfaceRow& ring) {
        return ring.points > least * (ring.z_end_mm - ring.z_start_mm);
    };
    double first = std::numeric_limits<double>::infinity();
    double last = -first;
    for (const SurfaceRow& ring : all.rows) {
        if (!isThere(ring)) continue;
        first = std::min(first, ring.z_start_mm);
        last = std::max(last, ring.z_end_mm);
    }
    const SurfaceRow* begin = nullptr;
    const SurfaceRow* end = nullptr;
    const auto finish = [&] {
        if (begin && end->z_end_mm - begin->z_start_mm >= findingThresholds.shortest_missing_mm) {
            Finding finding;
            finding.kind = Finding::Kind::Missing;
            finding.z_start_mm = begin->z_start_mm;
            finding.z_end_mm = end->z_end_mm;
            finding.value_mm = end->z_end_mm - begin->z_start_mm;
            finding.uncertainty_mm = end->z_end_mm - end->z_start_mm;
            findings.push_back(finding);
        }
        begin = end = nullptr;
    };
    for (const SurfaceRow& ring : all.rows) {
        if (begin && ring.stretch != begin->stretch) finish();
        const bool gone = !isThere(ring) && ring.z_start_mm >= first && ring.z_end_mm <= last;
        if (!gone) {
            finish();
            continue;
        }
        if (!begin) begin = &ring;
        end = &ring;
    }
    finish();
}

/// Sort key: the value relative to its limit, or a substitute without limits.
double strengthOf(const Finding& finding)
{
    if (finding.kind == Finding::Kind::Missing) return 0;
    const double size = std::abs(finding.value_mm);
    return finding.limit_mm && *finding.limit_mm > 0 ? findingThresholds.limited_first * size / *finding.limit_mm
                                                     : size;
}

}  // namespace

Eigen::Vector3d meanNormal(const SurfaceWindows& all, double z_start_mm, double z_end_mm)
{
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double points = 0;
    forEachSmallest(all, [&](const SurfaceWindow& w) {
        if (static_cast<double>(w.z_start_mm) < z_start_mm || static_cast<double>(w.z_end_mm) > z_end_mm) return;
        if (w.stretch >= 0 && all.stretches[static_cast<std::size_t>(w.stretch)].isFace()) return;
        sum += static_cast<double>(w.points) * w.normal.cast<double>();
        points += static_cast<double>(w.points);
    });
    return points > 0 ? Eigen::Vector3d(sum / points) : sum;
}

double meanSigma_mm(const SurfaceWindows& all, double z_start_mm, double z_end_mm, double points,
                    const Eigen::Vector3d& mean_normal)
{
    const double length = z_end_mm - z_start_mm;
    double variance = std::isinf(points) ? 0 : inflationFor(all, length) * all.scatter_mm * all.scatter_mm / points;
    if (!std::isinf(points)) {
        double sigma = 0;
        double step = 1;
        for (const MeridianStretch& stretch : all.stretches)
            if (stretch.start_mm < z_end_mm && stretch.end_mm > z_start_mm && !stretch.is_bore && !stretch.isFace()) {
                sigma = std::max(sigma, stretch.reference_sigma_mm);
                step = stretch.reference_step_mm;
            }
        variance += sigma * sigma / std::max(1.0, length / step);
    }
    if (all.axis_T_reference) {
        const Eigen::Vector3d axis = all.axis_T_reference->linear().row(2);
        const double along = mean_normal.dot(axis);
        const double across = (mean_normal - along * axis).norm();
        const double lever = (z_start_mm + z_end_mm) / 2 - (*all.axis_T_reference * all.middle_mm).z();
        variance += std::pow(along * all.axial_sigma_mm, 2) + std::pow(across * all.radial_sigma_mm, 2) +
                    std::pow(across * lever * all.tilt_sigma, 2);
    }
    return std::sqrt(variance);
}

std::vector<Finding> findDifferences(const SurfaceWindows& all, const LimitsAlong& limits, DecisionRule rule,
                                     double factor)
{
    std::vector<Finding> findings;
    if (all.has_sign) {
        const std::vector<Form> forms = formsOf(all, limits);
        // Each form is three values, and all are looked at.
        const double form_factor = coverageFactorOfWorst(3 * std::max<std::size_t>(forms.size(), 1), 1, 2);
        for (const Form& form : forms) describeForm(all, form, limits, rule, form_factor, findings);
        findBumps(all, forms, limits, rule, factor, findings);
    } else {
        findBumps(all, {}, limits, rule, factor, findings);
    }
    findMissing(all, findings);
    std::stable_sort(findings.begin(), findings.end(),
                     [](const Finding& a, const Finding& b) { return strengthOf(a) > strengthOf(b); });
    if (findings.size() > findingThresholds.most_findings) findings.resize(findingThresholds.most_findings);
    return findings;
}

}  // namespace lathelier::registration
