#include "engine/deflection/turning_work.h"

#include <algorithm>
#include <cmath>

#include "engine/deflection/deflection_codes.h"

namespace lathelier::deflection {
namespace {

constexpr double contactTolerance_mm = 1e-6;  ///< change of contact beyond rounding
constexpr double depthTolerance_mm = 1e-10;
constexpr int mostRounds = 12;  ///< fixed-point iterations; each gains one or two digits
constexpr int mostHalvings = 200;

void requireHeld(const TurningSetup& setup)
{
    int radial = setup.chuck.radial_N_mm > 0 ? 1 : 0;
    bool tilt = setup.chuck.tilt_N_mm_rad > 0;
    if (setup.tailstock) {
        radial += setup.tailstock->radial_N_mm > 0 ? 1 : 0;
        tilt = tilt || setup.tailstock->tilt_N_mm_rad > 0;
    }
    for (const SteadyRest& rest : setup.steady_rests) radial += rest.radial_N_mm > 0 ? 1 : 0;
    if (radial == 0 || radial + (tilt ? 1 : 0) < 2) throw Error(errors::notHeld, {});
}

}  // namespace

TurningWork::TurningWork(const WorkPlan& plan, const TurningSetup& setup)
    : plan_(&plan),
      setup_(&setup),
      elasticity_(setup.material.elastic, setup.shear),
      rest_N_mm_(plan.z_mm.size(), 0.0),
      left_(plan.z_mm.size()),
      right_(plan.z_mm.size()),
      compliance_(plan.z_mm.size())
{
    requireHeld(setup);
    for (std::size_t i = 0; i < plan.rest_nodes.size(); ++i)
        rest_N_mm_[plan.rest_nodes[i]] += setup.steady_rests[i].radial_N_mm;
    if (setup.tool_post) {
        tool_mm_N_ = 1 / setup.tool_post->radial_N_mm;
        toolAcross_mm_N_ = 1 / setup.tool_post->tangential_N_mm;
    }
    reset();
}

void TurningWork::reset()
{
    start_mm_ = plan_->outer_start_mm;
    end_mm_ = plan_->outer_end_mm;
    unpredictedStart_.assign(start_mm_.size(), false);
    unpredictedEnd_.assign(end_mm_.size(), false);
}

Symmetric2 TurningWork::flexibilityOf(std::size_t piece) const
{
    return flexibilityOf(piece, plan_->z_mm[piece + 1] - plan_->z_mm[piece]);
}

Symmetric2 TurningWork::flexibilityOf(std::size_t piece, double length_mm) const
{
    return elasticity_.flexibility(length_mm, (start_mm_[piece] + end_mm_[piece]) / 2, plan_->bore_mm[piece]);
}

Symmetric2 TurningWork::withRest(Symmetric2 s, std::size_t node) const
{
    s.ww += rest_N_mm_[node];
    return s;
}

/// Updates right_ down to `node`.
void TurningWork::sweepFromChuck(std::size_t node)
{
    std::size_t i = plan_->pieces();
    right_[i] = {setup_->chuck.radial_N_mm, 0, setup_->chuck.tilt_N_mm_rad};
    while (i-- > node)
        right_[i] = passedDown(withRest(right_[i + 1], i + 1), flexibilityOf(i), plan_->z_mm[i + 1] - plan_->z_mm[i]);
}

/// Updates left_ up to `node`.
void TurningWork::sweepFromFreeEnd(std::size_t node)
{
    left_[0] = {};
    if (setup_->tailstock) left_[0] = {setup_->tailstock->radial_N_mm, 0, setup_->tailstock->tilt_N_mm_rad};
    for (std::size_t i = 0; i < node; ++i)
        left_[i + 1] = passedUp(withRest(left_[i], i), flexibilityOf(i), plan_->z_mm[i + 1] - plan_->z_mm[i]);
}

/// Total stiffness at a node.
Symmetric2 TurningWork::heldAt(std::size_t node) const
{
    return setup_->follower_rest ? followedAt(node) : withRest(left_[node] + right_[node], node);
}

/// The same with the follower rest, which may lie within a piece; without effect beyond the ends of the workpiece.
Symmetric2 TurningWork::followedAt(std::size_t node) const
{
    const FollowerRest& rest = *setup_->follower_rest;
    const double at_mm = plan_->z_mm[node] + rest.offset_mm;
    const Symmetric2 spring{rest.radial_N_mm, 0, 0};
    if (rest.offset_mm == 0) return withRest(left_[node] + right_[node] + spring, node);
    if (at_mm < 0 || at_mm > plan_->length_mm()) return withRest(left_[node] + right_[node], node);
    const auto after = std::upper_bound(plan_->z_mm.begin(), plan_->z_mm.end() - 1, at_mm);
    const auto piece = static_cast<std::size_t>(after - plan_->z_mm.begin()) - 1;
    const double before_mm = at_mm - plan_->z_mm[piece], behind_mm = plan_->z_mm[piece + 1] - at_mm;
    if (rest.offset_mm > 0) {
        Symmetric2 s =
            passedDown(withRest(right_[piece + 1], piece + 1), flexibilityOf(piece, behind_mm), behind_mm) + spring;
        s = passedDown(s, flexibilityOf(piece, before_mm), before_mm);
        for (std::size_t i = piece; i-- > node;)
            s = passedDown(withRest(s, i + 1), flexibilityOf(i), plan_->z_mm[i + 1] - plan_->z_mm[i]);
        return withRest(left_[node] + s, node);
    }
    Symmetric2 s = passedUp(withRest(left_[piece], piece), flexibilityOf(piece, before_mm), before_mm) + spring;
    s = passedUp(s, flexibilityOf(piece, behind_mm), behind_mm);
    for (std::size_t i = piece + 1; i < node; ++i)
        s = passedUp(withRest(s, i), flexibilityOf(i), plan_->z_mm[i + 1] - plan_->z_mm[i]);
    return withRest(s + right_[node], node);
}

void TurningWork::enter(const CutPiece& piece)
{
    const double slope =
        setup_->slope == SlopeModel::Normal ? std::clamp(piece.slope_rad, -steepestSlope_rad, steepestSlope_rad) : 0;
    if (piece.feed_mm_rev == feed_mm_rev_ && slope == slope_rad_) return;
    edge_ = cutting::CuttingEdge(setup_->tool, piece.feed_mm_rev, setup_->contact, slope);
    feed_mm_rev_ = piece.feed_mm_rev;
    slope_rad_ = slope;
    slope_sin_ = std::sin(slope);
    slope_cos_ = std::cos(slope);
}

cutting::CuttingForces TurningWork::forcesAt(double depth_mm) const
{
    const cutting::CuttingForces f = cutting::forcesOf(setup_->material.cutting, edge_.chipAt(depth_mm * slope_cos_));
    if (slope_rad_ == 0) return f;
    return {f.F_t_N, f.F_f_N * slope_cos_ + f.F_ap_N * slope_sin_, f.F_ap_N * slope_cos_ - f.F_f_N * slope_sin_};
}

TurningWork::Pull TurningWork::pulled(const Symmetric2& c, double x_mm, double stock_mm, double depth_mm) const
{
    const cutting::CuttingForces f = forcesAt(depth_mm);
    const double arm_mm = setup_->feed_moment ? stock_mm - depth_mm / 2 : 0;
    const double dx_mm = -f.F_ap_N * (c.ww + tool_mm_N_) - f.F_f_N * arm_mm * c.wt;
    const double dy_mm = f.F_t_N * (c.ww + toolAcross_mm_N_);
    const double x_left_mm = x_mm - dx_mm;
    return {dx_mm, dy_mm, std::sqrt(x_left_mm * x_left_mm + dy_mm * dy_mm), f};
}

/// Fixed-point iteration: contracts, as the deflection changes by a few per cent of a change of depth.
double TurningWork::convergedDepth(const Symmetric2& c, double x_mm, double stock_mm) const
{
    double depth_mm = stock_mm - x_mm - pushed_mm_;
    for (int round = 0; round < mostRounds && depth_mm > edge_.scallop_mm(); ++round) {
        const double next_mm = stock_mm - pulled(c, x_mm, stock_mm, depth_mm).radius_mm;
        const bool is_converged = std::abs(next_mm - depth_mm) <= depthTolerance_mm;
        depth_mm = next_mm;
        if (is_converged && depth_mm > edge_.scallop_mm()) return depth_mm;
    }
    return boundedDepth(c, x_mm, stock_mm);
}

/// Bisection, if the iteration does not converge. If no larger depth is in equilibrium, the edge rubs at the depth of
/// the scallop.
double TurningWork::boundedDepth(const Symmetric2& c, double x_mm, double stock_mm) const
{
    const auto missing = [&](double depth_mm) {
        return stock_mm - pulled(c, x_mm, stock_mm, depth_mm).radius_mm - depth_mm;
    };
    double low_mm = edge_.scallop_mm() * (1 + 1e-9);
    if (!(missing(low_mm) > 0)) return edge_.scallop_mm();
    double high_mm = std::max(stock_mm - x_mm, 2 * low_mm);
    while (missing(high_mm) > 0 && high_mm < stock_mm) high_mm = std::min(stock_mm, 1.5 * high_mm);
    for (int i = 0; i < mostHalvings && high_mm - low_mm > depthTolerance_mm; ++i) {
        const double middle_mm = (low_mm + high_mm) / 2;
        (missing(middle_mm) > 0 ? low_mm : high_mm) = middle_mm;
    }
    return (low_mm + high_mm) / 2;
}

/// False: no material to cut.
bool TurningWork::cutStation(const Symmetric2& c, double contour_mm, double bore_mm, CutTask task, Station& s)
{
    s.x_mm = contour_mm;
    s.radius_mm = s.stock_mm;
    const double nominal_mm = s.stock_mm - contour_mm;
    if (!(nominal_mm > noDepth_mm)) return false;
    if (!(contour_mm > bore_mm))
        throw Error(errors::nothingLeft, {{"z_mm", s.z_mm}, {"radius_mm", contour_mm}, {"least_mm", bore_mm}});
    s.stiffness_N_mm = 1 / (c.ww + tool_mm_N_);
    s.depth_mm = nominal_mm;
    s.radius_mm = contour_mm;
    s.rubs = nominal_mm * slope_cos_ <= edge_.scallop_mm();
    if (s.rubs) return true;
    if (task == CutTask::Predict) s.depth_mm = convergedDepth(c, contour_mm, s.stock_mm);
    const Pull pull = pulled(c, contour_mm, s.stock_mm, s.depth_mm);
    s.forces = pull.forces;
    s.dx_mm = pull.dx_mm;
    s.dy_mm = pull.dy_mm;
    if (!(std::hypot(s.dx_mm, s.dy_mm) < contour_mm))
        throw Error(errors::workGivesWay, {{"z_mm", s.z_mm}, {"deflection_mm", std::hypot(s.dx_mm, s.dy_mm)}});
    if (task == CutTask::Correct) {
        s.x_mm = s.dx_mm + std::sqrt(contour_mm * contour_mm - s.dy_mm * s.dy_mm);
        return true;
    }
    s.rubs = s.depth_mm <= edge_.scallop_mm();
    s.radius_mm = s.rubs ? s.stock_mm - s.depth_mm : pull.radius_mm;
    if (s.rubs) s.dx_mm = s.x_mm - s.radius_mm;
    return true;
}

bool TurningWork::meetsBefore(const CutPlan& cut, std::size_t piece) const
{
    const std::size_t k = cut.first + piece;
    // If a run begins where the last one ended, the workpiece is still deflected there.
    const double contact_limit_mm = k + 1 == lastNode_ ? pushed_mm_ + contactTolerance_mm : noDepth_mm;
    return end_mm_[k] - cut.pieces[piece].end_mm > contact_limit_mm;
}

bool TurningWork::meets(const CutPlan& cut) const
{
    for (std::size_t i = 0; i < cut.pieces.size(); ++i)
        if (start_mm_[cut.first + i] - cut.pieces[i].start_mm > noDepth_mm || meetsBefore(cut, i)) return true;
    return false;
}

void TurningWork::removeContour(const CutPlan& cut)
{
    for (std::size_t i = 0; i < cut.pieces.size(); ++i) {
        const std::size_t k = cut.first + i;
        if (start_mm_[k] - cut.pieces[i].start_mm > noDepth_mm) {
            start_mm_[k] = cut.pieces[i].start_mm;
            unpredictedStart_[k] = true;
        }
        if (meetsBefore(cut, i)) {
            end_mm_[k] = cut.pieces[i].end_mm;
            unpredictedEnd_[k] = true;
        }
    }
    lastNode_ = 0;
}

void TurningWork::take(const CutPlan& cut, CutTask task, std::vector<Station>& stations)
{
    stations.clear();
    if (cut.kind == ToolRun::Kind::TowardFreeEnd) removeContour(cut);
    if (cut.kind != ToolRun::Kind::TowardChuck) return;
    stations.reserve(cut.pieces.size() + 1);
    sweepFromChuck(cut.first);
    sweepFromFreeEnd(cut.first);
    pushed_mm_ = pushedBefore_mm_ = 0;
    lastNode_ = 0;
    wasCut_ = false;
    for (std::size_t i = 0; i <= cut.pieces.size(); ++i) {
        const std::size_t node = cut.first + i;
        double stock_mm = 0;
        if (i > 0) {
            // Radius expected at this node, neglecting changes within one piece.
            stock_mm = end_mm_[node - 1];
            end_mm_[node - 1] = std::min(stock_mm, cut.pieces[i - 1].end_mm + 2 * pushed_mm_ - pushedBefore_mm_);
            left_[node] = passedUp(withRest(left_[node - 1], node - 1), flexibilityOf(node - 1),
                                   plan_->z_mm[node] - plan_->z_mm[node - 1]);
        }
        compliance_[node] = inverse(heldAt(node));
        if (i > 0) {
            end_mm_[node - 1] = stationAt(cut, i - 1, false, stock_mm, task, stations);
            if (wasCut_) unpredictedEnd_[node - 1] = false;
        }
        if (i == cut.pieces.size()) break;
        const bool is_continued =
            i > 0 && cut.pieces[i].start_mm == cut.pieces[i - 1].end_mm && start_mm_[node] == stock_mm &&
            cut.pieces[i].feed_mm_rev == cut.pieces[i - 1].feed_mm_rev &&
            (setup_->slope == SlopeModel::Radial || cut.pieces[i].slope_rad == cut.pieces[i - 1].slope_rad);
        start_mm_[node] = is_continued ? end_mm_[node - 1] : stationAt(cut, i, true, start_mm_[node], task, stations);
        if (wasCut_) unpredictedStart_[node] = false;
    }
}

/// Returns the radius left.
double TurningWork::stationAt(const CutPlan& cut, std::size_t piece, bool at_start, double stock_mm, CutTask task,
                              std::vector<Station>& stations)
{
    const CutPiece& contour = cut.pieces[piece];
    const std::size_t node = cut.first + piece + (at_start ? 0 : 1);
    Station s;
    s.z_mm = plan_->z_mm[node];
    s.stock_mm = stock_mm;
    s.piece = piece;
    s.at_start = at_start;
    enter(contour);
    if (!cutStation(compliance_[node], at_start ? contour.start_mm : contour.end_mm, plan_->bore_mm[cut.first + piece],
                    task, s)) {
        wasCut_ = false;
        return stock_mm;
    }
    // Linear extrapolation from the two previous stations; not across a shoulder or the start of a cut.
    const double pushed_mm = task == CutTask::Predict ? s.radius_mm - s.x_mm : 0;
    pushedBefore_mm_ = wasCut_ && !at_start ? pushed_mm_ : pushed_mm;
    pushed_mm_ = pushed_mm;
    wasCut_ = true;
    lastNode_ = node;
    stations.push_back(s);
    return s.radius_mm;
}

std::vector<Motion2> TurningWork::shapeUnder(std::size_t node, const Motion2& load) const
{
    TurningWork held = *this;
    if (setup_->follower_rest) {
        const double at_mm = plan_->z_mm[node] + setup_->follower_rest->offset_mm;
        const auto after = std::lower_bound(plan_->z_mm.begin(), plan_->z_mm.end() - 1, at_mm);
        if (at_mm >= 0 && at_mm <= plan_->length_mm())
            held.rest_N_mm_[static_cast<std::size_t>(after - plan_->z_mm.begin())] +=
                setup_->follower_rest->radial_N_mm;
    }
    held.sweepFromChuck(node);
    held.sweepFromFreeEnd(node);
    std::vector<Motion2> shape(plan_->z_mm.size());
    shape[node] = times(inverse(held.withRest(held.left_[node] + held.right_[node], node)), load);
    for (std::size_t i = node; i-- > 0;)
        shape[i] = motionBefore(held.left_[i + 1], flexibilityOf(i), plan_->z_mm[i + 1] - plan_->z_mm[i], shape[i + 1]);
    for (std::size_t i = node + 1; i < shape.size(); ++i)
        shape[i] =
            motionAfter(held.right_[i - 1], flexibilityOf(i - 1), plan_->z_mm[i] - plan_->z_mm[i - 1], shape[i - 1]);
    return shape;
}

}  // namespace lathelier::deflection
