#include "engine/registration/general/general_solver.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/core/parallel.h"
#include "engine/core/statistics.h"
#include "engine/core/units.h"

namespace lathelier::registration {
namespace {

constexpr std::size_t residualsPerTask = 1024;
constexpr double tukey = 4.685;

// One point's offset from the target.
struct SurfaceResidual {
    Eigen::Vector3d point_mm;  // of the copy, in the reference's frame
    Eigen::Vector3d normal;    // or for point-to-point the unit offset
    double distance_mm;        // NaN where it does not take part
    double slope_variance;
};

std::vector<SurfaceResidual> residuals(const RefineTarget& target, const std::vector<Eigen::Vector3d>& copy_mm,
                                       const Eigen::Isometry3d& pose, const RefineOptions& options,
                                       std::vector<Surface::Trace>& traces, const Progress& progress)
{
    traces.resize(copy_mm.size());
    std::vector<SurfaceResidual> result(copy_mm.size());
    parallelFor(copy_mm.size(), residualsPerTask, progress, [&](std::size_t begin, std::size_t end) {
        constexpr std::size_t bundle = 64;
        std::array<Eigen::Vector3d, bundle> queries;
        std::array<SurfacePlace, bundle> places;
        std::array<Neighbours::Found, bundle> found;
        for (std::size_t i = begin; i < end; i += bundle) {
            const std::size_t count = std::min(bundle, end - i);
            for (std::size_t q = 0; q < count; ++q) queries[q] = pose * copy_mm[i + q];
            if (options.point_to_point) {
                target.points->nearest(std::span(queries).first(count), options.search_mm * options.search_mm,
                                       std::span(traces).subspan(i, count), found);
                for (std::size_t q = 0; q < count; ++q) {
                    places[q] = SurfacePlace();
                    if (found[q].place == Neighbours::Found::none) continue;
                    const Eigen::Vector3d offset = queries[q] - target.points->point_mm(found[q].place);
                    places[q].distance_mm = offset.norm();
                    if (places[q].distance_mm > 0) places[q].normal = offset / places[q].distance_mm;
                }
            } else {
                target.surface->place(std::span(queries).first(count), options.search_mm, places,
                                      std::span(traces).subspan(i, count));
            }
            for (std::size_t q = 0; q < count; ++q)
                result[i + q] = {queries[q], places[q].normal, places[q].border ? notANumber : places[q].distance_mm,
                                 places[q].slope_variance};
        }
    });
    return result;
}

double residualSigma(const std::vector<SurfaceResidual>& residuals)
{
    std::vector<double> sizes;
    for (const SurfaceResidual& r : residuals)
        if (!std::isnan(r.distance_mm)) sizes.push_back(std::abs(r.distance_mm));
    if (sizes.empty()) return 0;
    const double middle = upperMedianInPlace(sizes);
    return madToSigma * middle;
}

double weightOf(const SurfaceResidual& r, double reach_mm)
{
    if (std::isnan(r.distance_mm)) return 0;
    const double t = r.distance_mm / reach_mm;
    return t * t < 1 ? (1 - t * t) * (1 - t * t) : 0;
}

// Residuals for clusteredUncertainty().
std::vector<MotionResidual> keep(const std::vector<SurfaceResidual>& all, double reach_mm,
                                 const std::vector<Surface::Trace>& traces, const Neighbours* reference)
{
    std::vector<MotionResidual> result;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const double w = weightOf(all[i], reach_mm);
        if (w == 0) continue;
        const double t = all[i].distance_mm / reach_mm;
        MotionResidual r{all[i].point_mm, all[i].normal, all[i].distance_mm, w, (1 - t * t) * (1 - 5 * t * t)};
        r.copy_input = static_cast<std::uint32_t>(i);
        if (reference != nullptr) r.reference_input = reference->input(traces[i].place);
        result.push_back(r);
    }
    return result;
}

struct ResidualFrame {
    double weight = 0;
    double weighted_squares = 0;
    std::size_t used = 0;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double spread = 0;
    double extent2 = 0;
};

// Weighted centre, radius of gyration and largest distance of the points that take part.
ResidualFrame frameOf(const std::vector<SurfaceResidual>& all, double reach_mm, const Progress& progress)
{
    const Eigen::Vector3d origin = all[0].point_mm;
    const auto add = [](ResidualFrame a, const ResidualFrame& b) {
        a.weight += b.weight;
        a.weighted_squares += b.weighted_squares;
        a.used += b.used;
        a.sum += b.sum;
        a.spread += b.spread;
        a.extent2 = std::max(a.extent2, b.extent2);
        return a;
    };
    ResidualFrame f = parallelReduce(
        all.size(), residualsPerTask, progress, ResidualFrame(),
        [&](std::size_t begin, std::size_t end) {
            ResidualFrame here;
            for (std::size_t i = begin; i < end; ++i) {
                const double w = weightOf(all[i], reach_mm);
                if (w == 0) continue;
                const Eigen::Vector3d p = all[i].point_mm - origin;
                here.weight += w;
                here.used += 1;
                here.weighted_squares += w * all[i].distance_mm * all[i].distance_mm;
                here.sum += w * p;
                here.spread += w * p.squaredNorm();
                here.extent2 = std::max(here.extent2, p.squaredNorm());
            }
            return here;
        },
        add);
    if (!(f.weight > 0)) return f;
    const Eigen::Vector3d mean = f.sum / f.weight;
    f.spread = std::sqrt(std::max(0.0, f.spread / f.weight - mean.squaredNorm()));
    f.sum = origin + mean;
    f.extent2 = std::pow(std::sqrt(f.extent2) + mean.norm(), 2);
    return f;
}

struct SystemSums {
    Matrix6d information = Matrix6d::Zero();
    Vector6d gradient = Vector6d::Zero();
    double noise = 0;  // sums of weight × slope variance × 1, q, q qᵀ
    Eigen::Vector3d noise_q = Eigen::Vector3d::Zero();
    Eigen::Matrix3d noise_qq = Eigen::Matrix3d::Zero();
};

Eigen::Matrix3d cross(const Eigen::Vector3d& v)
{
    Eigen::Matrix3d m;
    m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return m;
}

// Sum over the three axes e of J(e) J(e)ᵀ, J(e) = (q × e, e), from the moments of q.
Matrix6d allDirections(double count, const Eigen::Vector3d& q, const Eigen::Matrix3d& qq)
{
    Matrix6d m;
    m.topLeftCorner<3, 3>() = qq.trace() * Eigen::Matrix3d::Identity() - qq;
    m.topRightCorner<3, 3>() = cross(q);
    m.bottomLeftCorner<3, 3>() = cross(q).transpose();
    m.bottomRightCorner<3, 3>() = count * Eigen::Matrix3d::Identity();
    return m;
}

MotionSystem assemble(const std::vector<SurfaceResidual>& all, double reach_mm, const ResidualFrame& frame,
                      bool point_to_point, const Progress& progress)
{
    MotionSystem system;
    system.centre_mm = frame.sum;
    system.gyration_mm = frame.spread > 0 ? frame.spread : 1;
    system.weight = frame.weight;
    const SystemSums sums = parallelReduce(
        all.size(), residualsPerTask, progress, SystemSums(),
        [&](std::size_t begin, std::size_t end) {
            SystemSums here;
            for (std::size_t i = begin; i < end; ++i) {
                const SurfaceResidual& r = all[i];
                const double w = weightOf(r, reach_mm);
                if (w == 0) continue;
                const Eigen::Vector3d q = (r.point_mm - system.centre_mm) / system.gyration_mm;
                Vector6d j;
                j << q.cross(r.normal), r.normal;
                here.gradient += w * r.distance_mm * j;
                // Point-to-point: the residual counts in all directions.
                const double noise = point_to_point ? w : w * r.slope_variance;
                if (!point_to_point) here.information += (w * j) * j.transpose();
                here.noise += noise;
                here.noise_q += noise * q;
                here.noise_qq += (noise * q) * q.transpose();
            }
            return here;
        },
        [](SystemSums a, const SystemSums& b) {
            a.information += b.information;
            a.gradient += b.gradient;
            a.noise += b.noise;
            a.noise_q += b.noise_q;
            a.noise_qq += b.noise_qq;
            return a;
        });
    system.information = sums.information;
    system.gradient = sums.gradient;
    const Matrix6d spread = allDirections(sums.noise, sums.noise_q, sums.noise_qq);
    (point_to_point ? system.information : system.noise) = spread;
    return system;
}

}  // namespace

RefineResult refine(const RefineTarget& target, const std::vector<Eigen::Vector3d>& copy_mm,
                    const Eigen::Isometry3d& start, const Eigen::Isometry3d& initial, const RefineOptions& options,
                    std::vector<Surface::Trace>& traces, const Progress& progress)
{
    RefineResult result;
    result.reference_T_copy = start;
    if (copy_mm.empty()) return result;
    double widest = options.reach_mm;
    std::vector<SurfaceResidual> all;
    double reach = 0;
    while (result.iterations < options.max_iterations) {
        progress.report(static_cast<double>(result.iterations) / options.max_iterations);
        all = residuals(target, copy_mm, result.reference_T_copy, options, traces, progress);
        // Bounded below by rounding: with exact data the scatter would be 0 and every weight vanish.
        const double floor = 1e-9 * (1 + all[0].point_mm.norm()) + 1e-3 * options.tolerance_mm;
        const double sigma = std::max(residualSigma(all), floor);
        // Narrowed gradually: most points may already fit while the few that determine one motion are still far off.
        reach = std::max(tukey * sigma, widest);
        const bool is_narrow = reach > widest;
        widest /= 2;
        const ResidualFrame frame = frameOf(all, reach, progress);
        if (frame.used < 6) return result;
        ++result.iterations;
        result.sigma_mm = sigma;
        result.used_share = static_cast<double>(frame.used) / static_cast<double>(copy_mm.size());
        result.system = assemble(all, reach, frame, options.point_to_point, progress);
        result.observability = analyse(result.system);
        const Matrix6d& determined = result.observability.determined;
        const Vector6d home = difference(result.system, result.reference_T_copy, initial);
        const Vector6d step = -(result.observability.inverse * result.system.gradient) + home - determined * home;
        const Eigen::Isometry3d before = result.reference_T_copy;
        result.reference_T_copy = motion(result.system, step) * result.reference_T_copy;
        // Re-orthonormalise after many products.
        result.reference_T_copy.linear() =
            Eigen::Quaterniond(result.reference_T_copy.linear()).normalized().toRotationMatrix();
        const Vector6d moved = difference(result.system, before, result.reference_T_copy);
        const double furthest =
            moved.tail<3>().norm() + moved.head<3>().norm() / result.system.gyration_mm * std::sqrt(frame.extent2);
        const AlignmentUncertainty u = uncertainty(result.system, result.observability, sigma);
        if (is_narrow && furthest <= std::max(options.tolerance_mm, 0.05 * u.axial_um / 1000)) {
            result.converged = true;
            break;
        }
    }
    if (options.keep_residuals) result.residuals = keep(all, reach, traces, target.points);
    return result;
}

double misfit(const Surface& surface, const std::vector<Eigen::Vector3d>& copy_mm,
              const Eigen::Isometry3d& reference_T_copy, double limit_mm, const Progress& progress)
{
    RefineOptions options;
    options.search_mm = limit_mm;
    std::vector<Surface::Trace> traces;
    const std::vector<SurfaceResidual> all =
        residuals({&surface, nullptr}, copy_mm, reference_T_copy, options, traces, progress);
    double sum = 0;
    for (const SurfaceResidual& r : all) {
        const double t = r.distance_mm / limit_mm;
        sum += t * t < 1 ? t * t : 1;
    }
    return sum / static_cast<double>(all.size());
}

}  // namespace lathelier::registration
