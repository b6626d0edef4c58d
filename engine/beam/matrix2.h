// 2×2 matrices over deflection w and rotation t, real or complex: the algebra of one line of a beam's response.
#pragma once

#include <complex>

#include "engine/core/plain_complex.h"

namespace lathelier::beam {

using Complex = std::complex<double>;

/// Row: response (force or deflection), column: cause.
template <class S>
struct Matrix2 {
    S ww{};  ///< deflection per deflection term
    S wt{};  ///< deflection per rotation term
    S tw{};  ///< rotation per deflection term
    S tt{};  ///< rotation per rotation term

    friend Matrix2 operator+(const Matrix2& a, const Matrix2& b)
    {
        return {a.ww + b.ww, a.wt + b.wt, a.tw + b.tw, a.tt + b.tt};
    }
    friend Matrix2 operator-(const Matrix2& a, const Matrix2& b)
    {
        return {a.ww - b.ww, a.wt - b.wt, a.tw - b.tw, a.tt - b.tt};
    }
    friend Matrix2 operator-(const Matrix2& a) { return {-a.ww, -a.wt, -a.tw, -a.tt}; }
    friend Matrix2 operator*(const Matrix2& a, const Matrix2& b)
    {
        return {product(a.ww, b.ww) + product(a.wt, b.tw), product(a.ww, b.wt) + product(a.wt, b.tt),
                product(a.tw, b.ww) + product(a.tt, b.tw), product(a.tw, b.wt) + product(a.tt, b.tt)};
    }
    Matrix2 transposed() const { return {ww, tw, wt, tt}; }
    /// The matrix for reversed axes: the sign of rotation changes, that of deflection does not.
    Matrix2 mirrored() const { return {ww, -wt, -tw, tt}; }
};

/// Which motions of a node are held rigidly.
struct Held {
    bool w = false;  ///< deflection is held
    bool t = false;  ///< rotation is held
    friend bool operator==(const Held&, const Held&) = default;
};

/// Compliance of stiffness `a`; zero for held motions.
template <class S>
Matrix2<S> compliance(const Matrix2<S>& a, Held held)
{
    if (held.w && held.t) return {};
    if (held.w) return {{}, {}, {}, reciprocal(a.tt)};
    if (held.t) return {reciprocal(a.ww), {}, {}, {}};
    const S size = reciprocal(product(a.ww, a.tt) - product(a.wt, a.tw));
    return {product(a.tt, size), product(-a.wt, size), product(-a.tw, size), product(a.ww, size)};
}

}  // namespace lathelier::beam
