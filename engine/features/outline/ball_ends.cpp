#include "engine/features/outline/ball_ends.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/core/statistics.h"
#include "engine/features/model/selection_criterion.h"
#include "engine/features/outline/outline_limits.h"

namespace lathelier::features {
namespace {

/// How near to the pole points are seen.
struct PoleView {
    double on_ball_mm = 0;  ///< smallest distance from the axis of points on the ball
    double any_mm = 0;      ///< the same of all points near the pole
    bool is_flat = false;   ///< within `on_ball_mm` points lie on a plane across the axis: a face
};

class BallEnd {
public:
    BallEnd(const OutlineInput& input, Outline& outline, bool start)
        : input_(input),
          outline_(outline),
          start_(start),
          run_(start ? 0 : outline.model.runs.size() - 1),
          element_(start ? 0 : outline.model.runs[run_].elements.size() - 1),
          plane_(start ? outline.model.runs[run_].left : outline.model.runs[run_].right)
    {
    }

    void close()
    {
        const Model before = outline_.model;
        dropTip();
        const Element& arc = outline_.model.runs[run_].elements[element_];
        if (!arc.arc || !arc.convex || arc.flat || outline_.model.planes[plane_].data_end || isCut() || isShort()) {
            outline_.model = before;
            return;
        }
        const Model without_tip = outline_.model;
        const double free = tied(false);
        outline_.model = without_tip;
        const double on_axis = tied(true);
        const Run& run = outline_.model.runs[run_];
        if (!(on_axis <= free) || run.violation > selectionLimits.largest_violation || !isSeenToPole()) {
            outline_.model = before;
            return;
        }
        outline_.balls[start_ ? 0 : 1] = 2 * viewOf(run.elements[element_]).on_ball_mm;
        outline_.face_seen[start_ ? 0 : 1] = false;
    }

private:
    /// A short element before an arc lies where little of a ball is seen.
    void dropTip()
    {
        Run& run = outline_.model.runs[run_];
        const std::size_t n = run.elements.size();
        if (n < 2 || run.elements[element_].arc || !run.elements[start_ ? 1 : n - 2].arc) return;
        if (run.nodes_mm[element_ + 1] - run.nodes_mm[element_] > ballLimits.highest_cap_mm) return;
        run.elements.erase(run.elements.begin() + static_cast<std::ptrdiff_t>(element_));
        run.nodes_mm.erase(run.nodes_mm.begin() + static_cast<std::ptrdiff_t>(start_ ? 1 : n - 1));
        if (!start_) --element_;
        releaseLostTies(run);
        resolve(outline_.model, run);
    }

    bool isShort() const
    {
        const std::vector<double>& nodes = outline_.model.runs[run_].nodes_mm;
        return nodes[element_ + 1] - nodes[element_] < 2 * ballLimits.highest_cap_mm;
    }

    bool isCut() const
    {
        const double z_mm = outline_.model.planes[plane_].z_mm;
        return std::any_of(outline_.cuts.begin(), outline_.cuts.end(),
                           [&](const Cut& cut) { return cut.isAtLimit(z_mm) || cut.contains(z_mm); });
    }

    /// Misfit and price of the arc and its neighbour, over the walls beyond the cap that need not be seen; of an arc
    /// that is on the axis its pole is the plane then.
    double tied(bool on_axis)
    {
        Model& model = outline_.model;
        Run& run = model.runs[run_];
        const Scope scope = scopeOf(run, run_, element_, element_);
        double from = scope.from_mm, to = scope.to_mm;
        double& limit = start_ ? from : to;
        limit += start_ ? ballLimits.highest_cap_mm : -ballLimits.highest_cap_mm;
        if (on_axis) {
            Element& arc = run.elements[element_];
            (start_ ? arc.start : arc.end) = Tie::Axis;
            model.planes[plane_].pole = true;
            model.planes[plane_].lean = ballLimits.highest_cap_mm;
            resolve(model, run);
        }
        const double chi2 = fitWindow(model, scope.window, from, to, selectionLimits.insert_iterations);
        if (on_axis) model.planes[plane_].z_mm = start_ ? run.nodes_mm.front() : run.nodes_mm.back();
        return chi2 + price(model, slotsOf(model, run_, scope.window.first, scope.window.last).size());
    }

    PoleView viewOf(const Element& ball) const
    {
        const double rho = ball.radius_mm(), side = start_ ? -1 : 1;
        // Near the pole the spot moves readings off the ball by as much as along the axis.
        const double reach_mm = ballLimits.on_ball_sigmas * outline_.model.sigma_mm + ballLimits.on_ball_share * rho +
                                outline_.model.spot_mm / 2;
        std::vector<double> on_ball, any;
        std::vector<std::pair<double, double>> off_ball;  // distance from the axis, z
        for (std::size_t i = 0; i < input_.cloud.z_mm.size(); ++i) {
            const double off = static_cast<double>(input_.cloud.z_mm[i]) - ball.centre_z_mm,
                         r = static_cast<double>(input_.cloud.r_mm[i]);
            if (side * off < rho / 2) continue;
            any.push_back(r);
            if (std::abs(std::hypot(off, r) - rho) < reach_mm)
                on_ball.push_back(r);
            else
                off_ball.emplace_back(r, off);
        }
        PoleView view{innermost(on_ball), innermost(any), false};
        std::vector<double> heights;
        for (const auto& [r, z] : off_ball)
            if (r < view.on_ball_mm) heights.push_back(z);
        if (heights.size() <= ballLimits.stray_points) return view;
        const double middle = upperMedianInPlace(heights);
        for (double& z : heights) z = std::abs(z - middle);
        view.is_flat = madToSigma * upperMedianInPlace(heights) <
                       ballLimits.flat_sigmas * outline_.model.sigma_mm + ballLimits.flat_mm;
        return view;
    }

    static double innermost(std::vector<double>& radii_mm)
    {
        constexpr std::size_t place = ballLimits.stray_points;
        if (radii_mm.size() <= place) return std::numeric_limits<double>::infinity();
        std::nth_element(radii_mm.begin(), radii_mm.begin() + place, radii_mm.end());
        return radii_mm[place];
    }

    /// Is what is not seen of the ball no larger than what scanners lose about the axis?
    bool isSeenToPole() const
    {
        const Element& ball = outline_.model.runs[run_].elements[element_];
        const PoleView view = viewOf(ball);
        const double rho = ball.radius_mm();
        if (view.is_flat || !(view.on_ball_mm < ballLimits.largest_cap_share * rho)) return false;
        const double cap_mm = rho - std::sqrt(rho * rho - view.on_ball_mm * view.on_ball_mm);
        return cap_mm < ballLimits.highest_cap_mm &&
               view.any_mm < std::max(ballLimits.lost_radius_mm, ballLimits.grazed_share * rho);
    }

    const OutlineInput& input_;
    Outline& outline_;
    bool start_;
    std::size_t run_, element_, plane_;
};

/// Standard uncertainty of the pole at one end of a run.
double poleSigma_mm(const Outline& outline, std::size_t r, bool start)
{
    Model model = outline.model;
    Run& run = model.runs[r];
    const auto pole = [&] { return start ? run.nodes_mm.front() : run.nodes_mm.back(); };
    resolve(model, run);
    const double base = pole();
    Eigen::VectorXd row(static_cast<Eigen::Index>(outline.fit.slots.size()));
    for (Eigen::Index s = 0; s < row.size(); ++s) {
        double& value = valueOf(model, outline.fit.slots[static_cast<std::size_t>(s)]);
        const double before = value;
        value += dimensionLimits.derivative_step;
        resolve(model, run);
        row[s] = (pole() - base) / dimensionLimits.derivative_step;
        value = before;
    }
    return std::sqrt(std::max(0.0, row.dot(outline.fit.covariance * row)));
}

}  // namespace

void closeBallEnds(const OutlineInput& input, Outline& outline)
{
    if (input.bore) return;
    for (const bool start : {true, false}) BallEnd(input, outline, start).close();
}

void placePoles(Outline& outline)
{
    Model& model = outline.model;
    for (const bool start : {true, false}) {
        const std::size_t r = start ? 0 : model.runs.size() - 1;
        Run& run = model.runs[r];
        Plane& plane = model.planes[start ? run.left : run.right];
        if (!plane.pole) continue;
        resolve(model, run);
        plane.z_mm = plane.seen_mm = start ? run.nodes_mm.front() : run.nodes_mm.back();
        plane.sigma_mm = poleSigma_mm(outline, r, start);
    }
}

std::vector<ShaftMark> ballMarks(const Outline& outline, const std::vector<RecognizedRow>& rows)
{
    std::vector<ShaftMark> marks;
    for (const bool start : {true, false}) {
        if (!outline.balls[start ? 0 : 1]) continue;
        const RecognizedRow& row = start ? rows.front() : rows.back();
        ShaftMark mark{MarkKind::Sphere};
        mark.z_start_mm = row.z_start_mm;
        mark.z_end_mm = row.z_end_mm;
        mark.diameter_mm = 2 * row.arc_radius_mm.value_or(0);
        if (row.uncertainty.arc_radius_um) mark.uncertainty_mm = 2e-3 * *row.uncertainty.arc_radius_um;
        marks.push_back(mark);
    }
    return marks;
}

}  // namespace lathelier::features
