#include "engine/beam/piece_stiffness.h"

#include <array>
#include <cmath>

namespace lathelier::beam {
namespace {

/// Coefficients of T(y) = tanh(√y)/√y. For |y| < 0.1 the terms left out are below 1e-17.
constexpr std::array<double, 13> series{1.0,
                                        -1.0 / 3,
                                        2.0 / 15,
                                        -17.0 / 315,
                                        62.0 / 2835,
                                        -1382.0 / 155925,
                                        21844.0 / 6081075,
                                        -929569.0 / 638512875,
                                        6404582.0 / 10854718875,
                                        -443861162.0 / 1856156927625,
                                        18888466084.0 / 194896477400625,
                                        -113927491862.0 / 2900518163668125,
                                        58870668456604.0 / 3698160658676859375.0};
constexpr double seriesReach = 0.1;
constexpr double tinyReach = 1e-4;  // four terms of the series are sufficient below this |y|

template <class S>
S tinySeries(const S& y)
{
    return 1.0 + y * (series[1] + y * (series[2] + y * series[3]));
}

double tanhOverRoot(double y)
{
    if (std::abs(y) < tinyReach) return tinySeries(y);
    const double root = std::sqrt(std::abs(y));
    return (y > 0 ? std::tanh(root) : std::tan(root)) / root;
}

double rootOf(double y)
{
    return std::sqrt(y);
}

/// Principal root, without the checks for infinity of std::sqrt.
Complex rootOf(const Complex& y)
{
    const double size = std::sqrt(y.real() * y.real() + y.imag() * y.imag());
    const double large = std::sqrt((size + std::abs(y.real())) / 2);
    if (large == 0) return 0;
    const double small = std::abs(y.imag()) / (2 * large);
    const double sign = std::signbit(y.imag()) ? -1 : 1;
    return y.real() >= 0 ? Complex(large, sign * small) : Complex(small, sign * large);
}

Complex tanhOverRoot(const Complex& y)
{
    if (std::abs(y.real()) + std::abs(y.imag()) < tinyReach) return tinySeries(y);
    const Complex root = rootOf(y);  // real part ≥ 0: the exponential decays
    const double size = std::exp(-2 * root.real());
    const Complex wave(size * std::cos(2 * root.imag()), -size * std::sin(2 * root.imag()));
    return product(1.0 - wave, reciprocal(product(1.0 + wave, root)));
}

double sizeOf(double y)
{
    return std::abs(y);
}
double sizeOf(const Complex& y)
{
    return std::abs(y.real()) + std::abs(y.imag());
}

/// T(y) at the two roots: product, divided difference, and divided difference of y T(y).
template <class S>
struct RootFunctions {
    S product;            ///< T(y₁) T(y₂)
    S difference;         ///< [T(y₁) - T(y₂)]/(y₁ - y₂)
    S difference_of_y_T;  ///< [y₁T(y₁) - y₂T(y₂)]/(y₁ - y₂)
};

/// By symmetric functions of the roots: `sum` = y₁ + y₂, `prod` = y₁y₂, `square` = (y₁ - y₂)².
template <class S>
RootFunctions<S> bySeries(const S& sum, const S& prod, const S& square)
{
    S complete_before{};   // complete homogeneous polynomial of degree k - 1
    S complete = S(1);     // complete homogeneous polynomial of degree k
    S power_before = sum;  // power sums; p₋₁ has zero weight
    S power = S(2);
    S sum_T{}, difference{}, difference_of_y_T{};
    for (std::size_t k = 0; k < series.size(); ++k) {
        sum_T += series[k] * power;
        difference += series[k] * complete_before;
        difference_of_y_T += series[k] * complete;
        const S complete_next = product(sum, complete) - product(prod, complete_before);
        const S power_next = k == 0 ? sum : product(sum, power) - product(prod, power_before);
        complete_before = complete;
        complete = complete_next;
        power_before = power;
        power = power_next;
    }
    const S product_T = 0.25 * (product(sum_T, sum_T) - product(product(difference, difference), square));
    return {product_T, difference, difference_of_y_T};
}

template <class S>
RootFunctions<S> byRoots(const S& sum, const S& prod, const S& square)
{
    const S apart = rootOf(square);        // y₁ - y₂, real part ≥ 0
    const S second = 0.5 * (sum - apart);  // real and imaginary parts have equal signs: no cancellation
    const S first = product(prod, reciprocal(second));
    const S first_T = tanhOverRoot(first);
    const S second_T = tanhOverRoot(second);
    const S scale = reciprocal(apart);
    return {product(first_T, second_T), product(first_T - second_T, scale),
            product(product(first, first_T) - product(second, second_T), scale)};
}

/// Symmetric and antisymmetric 2×2 stiffness, and the blocks of a piece composed of them.
template <class S>
struct Halves {
    S sym_ww, sym_wt, sym_tt;     ///< at the right end, motion symmetric about the middle
    S anti_ww, anti_wt, anti_tt;  ///< motion antisymmetric about the middle

    PieceStiffness<S> blocks() const
    {
        const S wt = 0.5 * (sym_wt + anti_wt);
        const S across_wt = 0.5 * (sym_wt - anti_wt);
        return {{0.5 * (sym_ww + anti_ww), wt, wt, 0.5 * (sym_tt + anti_tt)},
                {0.5 * (sym_ww - anti_ww), across_wt, -across_wt, -0.5 * (sym_tt - anti_tt)}};
    }
};

}  // namespace

template <class S>
PieceConstants<S> pieceConstants(double length_mm, double mass_t_mm, double rotary_t_mm, const S& bending_N_mm2,
                                 const S& shear_N)
{
    return {length_mm / 2,
            mass_t_mm,
            rotary_t_mm,
            bending_N_mm2,
            rotary_t_mm * reciprocal(bending_N_mm2),
            mass_t_mm * reciprocal(shear_N),
            mass_t_mm * reciprocal(bending_N_mm2)};
}

template <class S>
PieceStiffness<S> exactStiffness(const PieceConstants<S>& piece, double omega_rad_s)
{
    const double square_omega = omega_rad_s * omega_rad_s;
    const double h = piece.half_mm;
    const double h2 = h * h;
    const S a = square_omega * piece.a_s2_mm2;
    const S b = square_omega * piece.b_s2_mm2;
    const S p = product(a, piece.b_s2_mm2) - piece.c_s2_mm4;  // (ab - c)/ω²
    const S sum = -h2 * (a + b);
    const S prod = (square_omega * h2 * h2) * p;
    const S square = (h2 * h2) * (product(a - b, a - b) + (4 * square_omega) * piece.c_s2_mm4);
    const bool is_short = sizeOf(sum) < seriesReach / 2 && sizeOf(prod) < seriesReach * seriesReach / 4;
    const RootFunctions<S> f = is_short ? bySeries(sum, prod, square) : byRoots(sum, prod, square);

    const S tau2 = h2 * f.product;
    const S d = (h * h2) * f.difference;
    const S e = h * f.difference_of_y_T;
    const double inertia = square_omega * piece.mass_t_mm;
    const S sym = reciprocal(e + product(b, d));
    const S anti = reciprocal(product(p, d) + product(piece.b_s2_mm2, e));
    Halves<S> halves;
    halves.sym_ww = -inertia * product(tau2, sym);
    halves.sym_wt = -inertia * product(d, sym);
    halves.sym_tt = product(piece.bending_N_mm2, sym);
    halves.anti_ww = piece.mass_t_mm * anti;
    halves.anti_wt = -piece.mass_t_mm * product(e, anti);
    halves.anti_tt = -product(product(piece.bending_N_mm2, p), product(tau2, anti));
    return halves.blocks();
}

template <class S>
PieceStiffness<S> elementStiffness(const PieceConstants<S>& piece, double omega_rad_s)
{
    const double square_omega = omega_rad_s * omega_rad_s;
    const double h = piece.half_mm;
    const double mass = square_omega * piece.mass_t_mm * h;
    const double rotary = square_omega * piece.rotary_t_mm * h;
    const S flexibility = piece.b_s2_mm2 * (1 / piece.mass_t_mm) + (h * h / 3) * reciprocal(piece.bending_N_mm2);
    const S shear = reciprocal(flexibility);
    Halves<S> halves;
    halves.sym_ww = S(-mass);
    halves.sym_wt = S(0);
    halves.sym_tt = (1 / h) * piece.bending_N_mm2 - rotary / 3;
    halves.anti_ww = (1 / h) * shear - mass / 3;
    halves.anti_wt = -shear;
    halves.anti_tt = h * shear - rotary;
    return halves.blocks();
}

template PieceConstants<double> pieceConstants(double, double, double, const double&, const double&);
template PieceConstants<Complex> pieceConstants(double, double, double, const Complex&, const Complex&);
template PieceStiffness<double> exactStiffness(const PieceConstants<double>&, double);
template PieceStiffness<Complex> exactStiffness(const PieceConstants<Complex>&, double);
template PieceStiffness<double> elementStiffness(const PieceConstants<double>&, double);
template PieceStiffness<Complex> elementStiffness(const PieceConstants<Complex>&, double);

}  // namespace lathelier::beam
