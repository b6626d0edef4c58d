// Complex product and reciprocal without the checks for infinity and overflow that std::complex makes: several times as
// fast. For values whose squares are finite and not 0. For templates the same of a double.
#pragma once

#include <complex>

namespace lathelier {

inline double reciprocal(double x)
{
    return 1 / x;
}
inline std::complex<double> reciprocal(const std::complex<double>& x)
{
    const double size = 1 / (x.real() * x.real() + x.imag() * x.imag());
    return {x.real() * size, -x.imag() * size};
}
inline double product(double a, double b)
{
    return a * b;
}
inline std::complex<double> product(const std::complex<double>& a, const std::complex<double>& b)
{
    return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

}  // namespace lathelier
