#include "engine/features/walls/segmentation.h"

#include <Eigen/Dense>
#include <cmath>
#include <limits>

#include "engine/features/walls/wall_limits.h"

namespace lathelier::features {
namespace {

constexpr double infiniteCost = std::numeric_limits<double>::infinity();

/// y = zeroth + first x + second x², and by how much less its squares are than those of the line.
struct Parabola {
    double zeroth = 0, first = 0, second = 0, gain = 0;

    double slopeAt(double x) const { return first + 2 * second * x; }
    /// Of the curve at x, without its sign.
    double curvatureAt(double x) const
    {
        const double q = 1 + slopeAt(x) * slopeAt(x);
        return 2 * std::abs(second) / (q * std::sqrt(q));
    }
    /// Is an arc that ends at x = 0 and begins an extent before it so flat that it is this parabola?
    bool isFlat(double extent_mm) const
    {
        return extent_mm * curvatureAt(-extent_mm / 2) < segmentationLimits.flat_chord_share &&
               std::abs(slopeAt(-extent_mm / 2)) < segmentationLimits.flat_chord_share;
    }
};

/// Sums over walls relative to one place, so that short arcs far from z = 0 lose no digits.
class Sums {
public:
    Sums(double z_mm, double r_mm) : z_(z_mm), r_(r_mm) {}

    void add(const Wall& wall)
    {
        constexpr double floor_mm = segmentationLimits.form_floor_mm;
        const double n = std::max(1.0, wall.points);
        const double w =
            1 / (wall.sigma_mm * wall.sigma_mm / n + floor_mm * floor_mm + wall.shared_mm * wall.shared_mm);
        const double x = wall.z_mm - z_, y = wall.r_mm - r_, q = x * x + y * y;
        s_ += w;
        sx_ += w * x;
        sy_ += w * y;
        sxx_ += w * x * x;
        sxy_ += w * x * y;
        syy_ += w * y * y;
        sq_ += w * q;
        sxq_ += w * x * q;
        syq_ += w * y * q;
        sqq_ += w * q * q;
        sxxx_ += w * x * x * x;
        sxxxx_ += w * x * x * x * x;
        sxxy_ += w * x * x * y;
    }
    /// The parabola of least squares.
    Parabola parabola() const
    {
        Parabola found;
        const double cxx = sxx_ - sx_ * sx_ / s_, cxy = sxy_ - sx_ * sy_ / s_;
        if (!(cxx > 0)) return found;
        const double share = (sxxx_ - sx_ * sxx_ / s_) / cxx;  // of x in x²
        const double square = sxxxx_ - sxx_ * sxx_ / s_ - share * share * cxx;
        if (!(square > 0)) return found;
        const double common = sxxy_ - sxx_ * sy_ / s_ - share * cxy;
        found.second = common / square;
        found.first = cxy / cxx - found.second * share;
        found.zeroth = (sy_ - found.first * sx_ - found.second * sxx_) / s_;
        found.gain = common * common / square;
        return found;
    }
    /// Cost of an arc over `extent_mm`; infinite where there is none.
    double arcOver(double extent_mm) const
    {
        if (extent_mm > segmentationLimits.longest_circle_mm) {
            const Parabola found = parabola();
            if (found.isFlat(extent_mm)) return std::max(0.0, line() - found.gain);
        }
        double a = 0, b = 0, c = 0;
        return arc(a, b, c);
    }
    double line() const
    {
        const double cxx = sxx_ - sx_ * sx_ / s_, cxy = sxy_ - sx_ * sy_ / s_, cyy = syy_ - sy_ * sy_ / s_;
        return cxx > 0 ? std::max(0.0, cyy - cxy * cxy / cxx) : std::max(0.0, cyy);
    }
    /// Solves for A, B, C and gives the cost; infinite where there is no circle.
    double arc(double& a, double& b, double& c) const
    {
        Eigen::Matrix3d m;
        m << sxx_, sxy_, sx_, sxy_, syy_, sy_, sx_, sy_, s_;
        const Eigen::Vector3d rhs(sxq_, syq_, sq_);
        // Scaled, since x and y may be small against 1.
        const Eigen::Vector3d scale = m.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
        const Eigen::Matrix3d scaled = scale.asDiagonal() * m * scale.asDiagonal();
        const Eigen::LDLT<Eigen::Matrix3d> solver(scaled);
        const Eigen::Vector3d found = scale.asDiagonal() * solver.solve(scale.asDiagonal() * rhs);
        a = found[0];
        b = found[1];
        c = found[2];
        const double square = c + (a * a + b * b) / 4;
        if (!(square > 0) || !found.allFinite()) return infiniteCost;
        const double misfit = std::max(0.0, sqq_ - found.dot(rhs));
        // Mean squared cosine: ((y - b/2)/ρ)² over the walls.
        const double cosine = (syy_ - b * sy_ + b * b / 4 * s_) / (square * s_);
        return misfit / (4 * square) / std::max(cosine, segmentationLimits.least_mean_square_cosine);
    }
    void lineOf(Piece& piece) const
    {
        const double cxx = sxx_ - sx_ * sx_ / s_, cxy = sxy_ - sx_ * sy_ / s_;
        piece.at_mm = z_ + sx_ / s_;
        piece.level_mm = r_ + sy_ / s_;
        piece.slope = cxx > 0 ? cxy / cxx : 0;
        piece.slope_error = cxx > 0 ? 1 / std::sqrt(cxx) : infiniteCost;
    }
    void flatArcOf(const Parabola& found, double extent_mm, Piece& piece) const
    {
        const double x = -extent_mm / 2, q = std::sqrt(1 + found.slopeAt(x) * found.slopeAt(x));
        piece.flat = true;
        piece.convex = found.second < 0;
        piece.at_mm = z_ + x;
        piece.level_mm = r_ + found.zeroth + (found.first + found.second * x) * x;
        piece.slope = found.slopeAt(x);
        piece.radius_mm = 1 / found.curvatureAt(x);
        const double toward_axis = piece.convex ? 1 : -1;
        piece.centre_z_mm = piece.at_mm + toward_axis * piece.radius_mm * piece.slope / q;
        piece.centre_r_mm = piece.level_mm - toward_axis * piece.radius_mm / q;
    }
    double meanY() const { return sy_ / s_; }
    double z() const { return z_; }
    double r() const { return r_; }

private:
    double z_, r_;
    double s_ = 0, sx_ = 0, sy_ = 0, sxx_ = 0, sxy_ = 0, syy_ = 0, sq_ = 0, sxq_ = 0, syq_ = 0, sqq_ = 0;
    double sxxx_ = 0, sxxxx_ = 0, sxxy_ = 0;
};

Sums sumsOf(std::span<const Wall> walls)
{
    Sums sums(walls.back().z_mm, walls.back().r_mm);
    for (const Wall& wall : walls) sums.add(wall);
    return sums;
}

Piece pieceOf(std::span<const Wall> walls, std::size_t begin, std::size_t end, bool arc)
{
    Piece piece;
    piece.begin = begin;
    piece.end = end;
    piece.arc = arc;
    const Sums sums = sumsOf(walls.subspan(begin, end - begin));
    sums.lineOf(piece);
    if (!arc) return piece;
    const double extent_mm = walls[end - 1].z_mm - walls[begin].z_mm;
    if (extent_mm > segmentationLimits.longest_circle_mm) {
        const Parabola found = sums.parabola();
        if (found.isFlat(extent_mm)) {
            sums.flatArcOf(found, extent_mm, piece);
            return piece;
        }
    }
    double a = 0, b = 0, c = 0;
    sums.arc(a, b, c);
    piece.centre_z_mm = sums.z() + a / 2;
    piece.centre_r_mm = sums.r() + b / 2;
    piece.radius_mm = std::sqrt(std::max(0.0, c + (a * a + b * b) / 4));
    piece.convex = sums.meanY() > b / 2;
    return piece;
}

}  // namespace

double linePrice(std::size_t walls)
{
    return segmentationLimits.line_price * std::log(static_cast<double>(walls) + 1);
}

double arcPrice(std::size_t walls)
{
    return segmentationLimits.arc_price * std::log(static_cast<double>(walls) + 1);
}

double leftOutPrice(std::size_t walls)
{
    return segmentationLimits.omitted_price * std::log(static_cast<double>(walls) + 1);
}

double lineCost(std::span<const Wall> walls)
{
    return sumsOf(walls).line();
}

double arcCost(std::span<const Wall> walls)
{
    return sumsOf(walls).arcOver(walls.back().z_mm - walls.front().z_mm);
}

std::vector<Piece> cutIntoPieces(std::span<const Wall> walls, const Progress& progress)
{
    const SegmentationLimits& limits = segmentationLimits;
    const std::size_t n = walls.size();
    const double line_price = linePrice(n), arc_price = arcPrice(n), left_out_price = leftOutPrice(n);
    std::vector<double> best(n + 1, infiniteCost);    // of a piece that ends before wall j
    std::vector<double> before(n + 1, infiniteCost);  // of a piece that may start at wall i
    std::vector<std::size_t> left_out(n + 1, 0);
    std::vector<std::size_t> from(n + 1, 0);
    std::vector<char> is_arc(n + 1, 0);
    best[0] = before[0] = 0;
    for (std::size_t j = limits.least_line_walls; j <= n; ++j) {
        if (j % 64 == 0) progress.check();
        Sums sums(walls[j - 1].z_mm, walls[j - 1].r_mm);
        for (std::size_t i = j; i-- > 0;) {
            sums.add(walls[i]);
            const std::size_t length = j - i;
            if (length < limits.least_line_walls || before[i] == infiniteCost) continue;
            const double line = sums.line();
            if (before[i] + line + line_price < best[j]) {
                best[j] = before[i] + line + line_price;
                from[j] = i;
                is_arc[j] = 0;
            }
            if (length < limits.least_arc_walls) continue;
            if (before[i] + arc_price >= best[j] || line < arc_price - line_price) continue;
            const double extent_mm = walls[j - 1].z_mm - walls[i].z_mm;
            if (extent_mm > limits.longest_circle_mm && sums.parabola().gain < arc_price - line_price) continue;
            const double arc = sums.arcOver(extent_mm);
            if (before[i] + arc + arc_price < best[j]) {
                best[j] = before[i] + arc + arc_price;
                from[j] = i;
                is_arc[j] = 1;
            }
        }
        before[j] = best[j];
        for (std::size_t k = 1; k <= limits.most_omitted_walls && k < j; ++k)
            if (const double value = best[j - k] + static_cast<double>(k) * left_out_price; value < before[j]) {
                before[j] = value;
                left_out[j] = k;
            }
    }
    std::vector<Piece> pieces;
    if (n < limits.least_line_walls || best[n] == infiniteCost) return pieces;
    for (std::size_t j = n; j > 0; j = from[j] - left_out[from[j]])
        pieces.push_back(pieceOf(walls, from[j], j, is_arc[j] != 0));
    return {pieces.rbegin(), pieces.rend()};
}

}  // namespace lathelier::features
