#include "engine/form/linear_minimax.h"

#include <Eigen/Geometry>

#include <cmath>

namespace lathelier {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// normal · (step / half, value) ≥ bound. Steps are counted in halves of the square, so that all normals are of
/// like size however small it is.
struct Constraint {
    Vector3d normal = Vector3d::Zero();
    double bound = 0;
    std::size_t outer = MinimaxStep::none, inner = MinimaxStep::none;
    bool limit = false;
};

class Program {
public:
    Program(const LinearDistances& distances, MinimaxGoal goal, double half, const std::vector<HalfPlane>& limits)
        : distances_(distances), goal_(goal), half_(half), limits_(limits)
    {
    }

    /// The piece of the goal that is largest at `step`: value ≥ piece.
    Constraint largestPiece(const Vector2d& step) const
    {
        const Vector2d s = half_ * step;
        const std::size_t count = distances_.size();
        double low = std::numeric_limits<double>::infinity(), high = -low;
        std::size_t inner = 0, outer = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const double value = distances_.a[i] - distances_.ux[i] * s.x() - distances_.uy[i] * s.y();
            if (value < low) {
                low = value;
                inner = i;
            }
            if (value > high) {
                high = value;
                outer = i;
            }
        }
        Constraint result;
        result.inner = inner;
        Vector2d gradient = direction(inner);
        result.bound = -distances_.a[inner];
        if (goal_ == MinimaxGoal::Width) {
            result.outer = outer;
            gradient -= direction(outer);
            result.bound += distances_.a[outer];
        }
        result.normal << -half_ * gradient, 1;
        return result;
    }

    /// A side of the square or a limit that `step` oversteps; false when there is none.
    bool oversteps(const Vector2d& step, Constraint& found) const
    {
        constexpr double slack = 1e-12;
        double worst = slack;
        for (int axis = 0; axis < 2; ++axis)
            if (const double over = std::abs(step[axis]) - 1; over > worst) {
                worst = over;
                found = {};
                found.normal[axis] = step[axis] > 0 ? -1 : 1;
                found.bound = -1;
            }
        for (const HalfPlane& limit : limits_) {
            const double bound = -limit.offset / half_;
            if (const double over = limit.normal.dot(step) + bound; over > worst) {
                worst = over;
                found = {};
                found.normal << -limit.normal, 0;
                found.bound = bound;
                found.limit = true;
            }
        }
        return worst > slack;
    }

private:
    Vector2d direction(std::size_t i) const { return {distances_.ux[i], distances_.uy[i]}; }

    const LinearDistances& distances_;
    MinimaxGoal goal_;
    double half_;
    const std::vector<HalfPlane>& limits_;
};

/// Three constraints with their normals as rows, and the inverse.
struct Basis {
    std::array<Constraint, 3> constraints;
    Eigen::Matrix3d inverse = Eigen::Matrix3d::Identity();

    bool invert()
    {
        const Vector3d &a = constraints[0].normal, &b = constraints[1].normal, &c = constraints[2].normal;
        const double determinant = a.dot(b.cross(c));
        if (!(std::abs(determinant) > 1e-300)) return false;
        inverse.col(0) = b.cross(c) / determinant;
        inverse.col(1) = c.cross(a) / determinant;
        inverse.col(2) = a.cross(b) / determinant;
        return true;
    }
    Vector3d point() const
    {
        return inverse * Vector3d(constraints[0].bound, constraints[1].bound, constraints[2].bound);
    }
    /// How `normal` is made of the three.
    Vector3d weightsOf(const Vector3d& normal) const { return inverse.transpose() * normal; }
};

}  // namespace

void LinearDistances::clear()
{
    a.clear();
    ux.clear();
    uy.clear();
}

void LinearDistances::push(double distance, const Vector2d& direction)
{
    a.push_back(distance);
    ux.push_back(direction.x());
    uy.push_back(direction.y());
}

MinimaxStep minimax(const LinearDistances& distances, MinimaxGoal goal, double half,
                    const std::vector<HalfPlane>& limits, double enough)
{
    const Program program(distances, goal, half, limits);
    MinimaxStep result;
    Basis basis;
    // Start in the corner of the square to which the largest piece falls.
    basis.constraints[0] = program.largestPiece(Vector2d::Zero());
    for (int axis = 0; axis < 2; ++axis) {
        Constraint& side = basis.constraints[static_cast<std::size_t>(axis) + 1];
        side.normal[axis] = basis.constraints[0].normal[axis] > 0 ? -1 : 1;
        side.bound = -1;
    }
    basis.invert();
    Vector3d weights = basis.weightsOf(Vector3d::UnitZ()).cwiseMax(0);
    constexpr int mostExchanges = 200;
    for (int exchange = 0; exchange < mostExchanges; ++exchange) {
        const Vector3d point = basis.point();
        const Vector2d step = point.head<2>();
        result.value = point[2];
        result.step = half * step;
        if (result.value > enough) break;
        Constraint entering;
        if (!program.oversteps(step, entering)) {
            entering = program.largestPiece(step);
            const double violation = entering.bound - entering.normal.dot(point);
            if (violation <= 2e-16 * (1 + std::abs(entering.bound))) {
                result.solved = true;
                break;
            }
        }
        const Vector3d parts = basis.weightsOf(entering.normal);
        int leaving = -1;
        double ratio = std::numeric_limits<double>::infinity();
        for (int k = 0; k < 3; ++k) {
            if (!(parts[k] > 1e-11)) continue;
            const double r = weights[k] / parts[k];
            if (r < ratio || (r == ratio && leaving >= 0 && parts[k] > parts[leaving])) {
                ratio = r;
                leaving = k;
            }
        }
        if (leaving < 0) {
            result.feasible = entering.normal[2] != 0;  // a piece can always be met by a larger value
            break;
        }
        const Basis before = basis;
        basis.constraints[static_cast<std::size_t>(leaving)] = entering;
        if (!basis.invert()) {
            basis = before;
            break;
        }
        weights = basis.weightsOf(Vector3d::UnitZ()).cwiseMax(0);
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const Constraint& c = basis.constraints[k];
        const double weight = weights[static_cast<Eigen::Index>(k)];
        result.active[k] = {c.outer, c.inner, c.limit, c.inner == MinimaxStep::none ? weight / half : weight};
    }
    return result;
}

}  // namespace lathelier
