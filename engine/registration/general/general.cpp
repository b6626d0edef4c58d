#include "engine/registration/general/general.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "engine/core/statistics.h"
#include "engine/registration/general/coarse_alignment.h"
#include "engine/registration/general/general_solver.h"
#include "engine/registration/neighbours/neighbours_order.h"
#include "engine/registration/registration_codes.h"

namespace lathelier::registration {
namespace {

using Points = std::vector<Eigen::Vector3d>;

constexpr std::array<std::size_t, 3> levelSizes = {3000, 20000, 100000};
constexpr double coarse_cells = 60;  // along the part's size (about 10 000 points on a compact part)
constexpr std::size_t candidates = 6;
constexpr double otherPartResidualShare =
    0.02;  // residuals above this share of the part's size: different parts; a coarse level suffices to decide

class GeneralAlignment {
public:
    GeneralAlignment(const GeneralReference& reference, const Scan& copy, bool point_to_point, const Progress& progress)
        : reference_(reference.points),
          copy_(centrePoints(copy, "copy", progress)),
          surface_(*reference.surface),
          initial_(Eigen::Translation3d(copy_.middle_mm - reference_.middle_mm)),
          size_mm_(std::max(reference_.size_mm, copy_.size_mm)),
          pointToPoint_(point_to_point)
    {
        copyOrder_ = hilbertOrder(copy_.points_mm, progress);
        Points ordered;
        ordered.reserve(copyOrder_.size());
        for (const std::uint32_t i : copyOrder_) ordered.push_back(copy_.points_mm[i]);
        copy_.points_mm = std::move(ordered);
        points_ = surface_.points();
        if (points_ == nullptr && pointToPoint_) {
            samples_ = std::make_unique<Neighbours>(reference_.points_mm, progress);
            points_ = samples_.get();
        }
    }

    Alignment run(InitialPose initial, const Progress& progress)
    {
        Eigen::Isometry3d pose = initial_;
        double search = 0.25 * size_mm_;
        if (initial == InitialPose::Auto) {
            pose = findPose(progress.part(0, 0.4));
            search = 0.1 * size_mm_;
        }
        return refineLevels(pose, search, progress.part(0.4, 1));
    }

private:
    RefineTarget target() const { return {&surface_, points_}; }

    Points thin(const CentredPoints& cloud, const Progress& progress) const
    {
        const Points some = everyNth(cloud.points_mm, 100000);
        const Points few = thinOut(some, 2 * size_mm_ / coarse_cells, progress);
        return few.size() < 20 ? everyNth(some, 10000) : few;  // a small part beside a large one
    }

    // Align the smaller surface to the larger: unmatched source points bias the fit, unmatched target area does not.
    std::vector<Eigen::Isometry3d> coarsePoses(const Progress& progress) const
    {
        const Points reference = thin(reference_, progress);
        const Points copy = thin(copy_, progress);
        if (copy.size() <= reference.size()) return findCoarsePoses(reference, copy, candidates, progress);
        std::vector<Eigen::Isometry3d> poses = findCoarsePoses(copy, reference, candidates, progress);
        for (Eigen::Isometry3d& pose : poses) pose = pose.inverse();
        return poses;
    }

    // The best of the coarse poses, judged on the surface itself.
    Eigen::Isometry3d findPose(const Progress& progress)
    {
        std::vector<Eigen::Isometry3d> poses = coarsePoses(progress.part(0, 0.8));
        poses.push_back(initial_);  // among equally good poses an already correct initial pose is kept
        const Points sample = everyNth(copy_.points_mm, 2000);
        struct Candidate {
            Eigen::Isometry3d pose;
            double sigma_mm;
            double misfit;
            double turn;
        };
        std::vector<Candidate> fits;
        double sigma = size_mm_;
        for (std::size_t i = 0; i < poses.size(); ++i) {
            RefineOptions options;
            // Point-to-point leaves parts shifted along their faces by this much.
            options.search_mm = 0.25 * size_mm_;
            options.reach_mm = 0.12 * size_mm_;
            options.max_iterations = 10;
            options.tolerance_mm = 1e-4 * size_mm_;
            std::vector<Surface::Trace> traces;
            const RefineResult r = refine(target(), sample, poses[i], poses[i], options, traces);
            fits.push_back({r.reference_T_copy, r.sigma_mm, 0, Eigen::AngleAxisd(r.reference_T_copy.linear()).angle()});
            if (r.sigma_mm > 0) sigma = std::min(sigma, r.sigma_mm);
            progress.report(0.8 + 0.2 * static_cast<double>(i) / static_cast<double>(poses.size()));
        }
        const double limit = std::max(10 * sigma, 2e-3 * size_mm_);
        for (Candidate& c : fits) c.misfit = misfit(surface_, sample, c.pose, limit, progress);
        const Candidate& best = *std::min_element(
            fits.begin(), fits.end(), [](const Candidate& a, const Candidate& b) { return a.misfit < b.misfit; });
        // Points without a counterpart add the same amount in every pose: compare the difference of the misfits, not
        // the ratio.
        const double as_good = best.misfit + 3e-3;
        const Candidate* chosen = &best;
        for (const Candidate& c : fits) {
            if (c.misfit > as_good) continue;
            const double apart = Eigen::AngleAxisd(c.pose.linear().transpose() * best.pose.linear()).angle();
            if (&c == &best || apart > 0.1) ++equalPoses_;
            if (c.turn < chosen->turn - 0.1) chosen = &c;
        }
        return chosen->pose;
    }

    Alignment refineLevels(const Eigen::Isometry3d& start, double search, const Progress& progress)
    {
        Alignment alignment;
        RefineResult fine;
        fine.reference_T_copy = start;
        std::size_t points = 0;
        std::vector<Surface::Trace> traces;
        for (std::size_t level = 0; level < levelSizes.size(); ++level) {
            const bool last = level + 1 == levelSizes.size();
            RefineOptions options;
            options.point_to_point = pointToPoint_;
            options.search_mm = search;
            options.reach_mm = search / 2;
            options.max_iterations = last ? 60 : 40;
            options.keep_residuals = last;
            options.tolerance_mm = (last ? 1e-6 : 1e-5) * size_mm_;
            const double from = static_cast<double>(level) / static_cast<double>(levelSizes.size());
            if (level == 0 || fine.sigma_mm < otherPartResidualShare * size_mm_) {
                points = levelSizes[level];
                traces.clear();
            }
            fine = refine(target(), everyNth(copy_.points_mm, points), fine.reference_T_copy, fine.reference_T_copy,
                          options, traces, progress.part(from, from + 1.0 / static_cast<double>(levelSizes.size())));
            alignment.iterations += fine.iterations;
            if (fine.iterations == 0) break;  // nothing lies near the surface
            search = std::clamp(10 * fine.sigma_mm + (pointToPoint_ ? 4 * surface_.spacing_mm() : 0), 1e-3 * size_mm_,
                                search);
        }
        if (!fine.observability.free_motions.empty()) restoreFreeMotions(fine, points, search, traces, progress);
        alignment.converged = fine.converged;
        snapToSamePoints(fine.reference_T_copy, progress);
        describe(fine, points, alignment);
        return alignment;
    }

    // Along its free motions the part is returned to its initial pose; a motion that loses matched points is not free.
    void restoreFreeMotions(RefineResult& fine, std::size_t points, double search, std::vector<Surface::Trace>& traces,
                            const Progress& progress) const
    {
        RefineOptions options;
        options.search_mm = search;
        options.tolerance_mm = 1e-6 * size_mm_;
        options.keep_residuals = true;
        RefineResult home = refine(target(), everyNth(copy_.points_mm, points), fine.reference_T_copy, initial_,
                                   options, traces, progress);
        if (home.converged && home.used_share > 0.95 * fine.used_share) fine = std::move(home);
    }

    // A copy that contains the points of the reference themselves is aligned exactly, not only within their noise.
    void snapToSamePoints(Eigen::Isometry3d& pose, const Progress& progress) const
    {
        if (points_ == nullptr) return;
        const Points sample = everyNth(copy_.points_mm, 2000);
        std::vector<double> to_reference;
        std::vector<double> spacing;
        std::vector<Neighbours::Found> two;
        for (const auto& p : sample) {
            const Neighbours::Found found = points_->nearest(pose * p);
            to_reference.push_back(found.squared_mm2);
            points_->nearest(points_->point_mm(found.place), 2, std::numeric_limits<double>::infinity(), two);
            spacing.push_back(two.back().squared_mm2);
        }
        const double usual_spacing_mm2 = upperMedianInPlace(spacing);
        if (!(upperMedianInPlace(to_reference) < 0.01 * usual_spacing_mm2)) return;
        RefineOptions options;
        options.point_to_point = true;
        options.search_mm = 0.3 * std::sqrt(usual_spacing_mm2);
        options.tolerance_mm = 1e-12 * size_mm_;
        options.max_iterations = 6;
        std::vector<Surface::Trace> traces;
        const RefineResult exact =
            refine(target(), everyNth(copy_.points_mm, 20000), pose, pose, options, traces, progress);
        if (exact.sigma_mm < 1e-6 * size_mm_) pose = exact.reference_T_copy;
    }

    void describe(RefineResult& fine, std::size_t points, Alignment& alignment) const
    {
        // Noise of the reference's own points adds to that of the copy's points used.
        double share = 1;
        if (surface_.pointCount() > 0) {
            const double used = fine.used_share * static_cast<double>(std::min(points, copy_.points_mm.size()));
            share += used / static_cast<double>(surface_.pointCount());
        }
        const std::size_t all = copyOrder_.size();
        for (MotionResidual& r : fine.residuals)  // from its place in the sample to that in the file
            r.copy_input = copyOrder_[all <= points ? r.copy_input : r.copy_input * all / points];
        alignment.uncertainty =
            clusteredUncertainty(fine.system, fine.observability, fine.sigma_mm * std::sqrt(share), fine.residuals);
        const auto kindText = [](const FreeMotion& m) {
            return m.kind == FreeMotion::Kind::Rotation ? LT_TEXT("Engine", "rotation")
                                                        : LT_TEXT("Engine", "translation");
        };
        for (FreeMotion m : fine.observability.free_motions) {
            m.point_mm += reference_.middle_mm;
            alignment.free_motions.push_back(m);
            alignment.notes.push_back({notes::motionNotDetermined, {{"kind", kindText(m)}}});
        }
        for (const FreeMotion& m : fine.observability.weak_motions)
            alignment.notes.push_back({notes::motionWeak, {{"kind", kindText(m)}}});
        if (equalPoses_ > 1 && alignment.free_motions.empty())
            alignment.notes.push_back({notes::severalPosesFit, {{"count", std::int64_t{equalPoses_}}}});
        alignment.reference_T_copy =
            Eigen::Translation3d(reference_.middle_mm) * fine.reference_T_copy * Eigen::Translation3d(-copy_.middle_mm);
    }

    const CentredPoints& reference_;
    CentredPoints copy_;
    std::vector<std::uint32_t> copyOrder_;  ///< place in the file of each point of copy_
    const Surface& surface_;
    Eigen::Isometry3d initial_;  ///< the poses as they are, between the centred clouds
    double size_mm_;
    bool pointToPoint_;
    const Neighbours* points_ = nullptr;  ///< of the reference; for a mesh nullptr unless point-to-point
    std::unique_ptr<Neighbours> samples_;
    int equalPoses_ = 0;
};

}  // namespace

Alignment alignGeneral(const GeneralReference& reference, const Scan& copy, CompareMethod method, InitialPose initial,
                       const Progress& progress)
{
    GeneralAlignment alignment(reference, copy, method == CompareMethod::Point, progress.part(0, 0.1));
    progress.report(0.1);
    return alignment.run(initial, progress.part(0.1, 1));
}

Alignment alignGeneral(const Scan& reference, const Scan& copy, CompareMethod method, InitialPose initial,
                       const Progress& progress)
{
    return alignGeneral(prepareReference(reference, progress.part(0, 0.4)), copy, method, initial,
                        progress.part(0.4, 1));
}

}  // namespace lathelier::registration
