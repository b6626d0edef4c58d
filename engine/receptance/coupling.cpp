#include "engine/receptance/coupling.h"

#include <Eigen/LU>
#include <numbers>

namespace lathelier::receptance {

ReceptanceMatrix coupled(const FreeReceptances& beam, const ReceptanceMatrix& spindle)
{
    const ReceptanceMatrix joint = beam.jj + spindle;
    return beam.ac - beam.aj * joint.inverse() * beam.jc;
}

ReceptanceMatrix coupled(const ReceptanceMatrix& beam_ac, std::span<const Joint> joints,
                         std::span<const ReceptanceMatrix> beam_jj)
{
    const auto n = static_cast<Eigen::Index>(joints.size());
    Eigen::MatrixXcd aj(2, 2 * n), jc(2 * n, 2), jj(2 * n, 2 * n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const Joint& joint = joints[static_cast<std::size_t>(i)];
        aj.middleCols<2>(2 * i) = joint.aj;
        jc.middleRows<2>(2 * i) = joint.jc;
        for (Eigen::Index k = 0; k < n; ++k)
            jj.block<2, 2>(2 * i, 2 * k) = beam_jj[static_cast<std::size_t>(i * n + k)];
        jj.block<2, 2>(2 * i, 2 * i) += joint.other;
    }
    return beam_ac - aj * jj.fullPivLu().solve(jc);
}

ReceptanceMatrix behindJoint(const ReceptanceMatrix& spindle, const SpindleSprings& joint)
{
    return spindle + SpindleReceptance{joint}.at(0);
}

Complex withMass(const Complex& receptance_mm_N, double mass_kg, double frequency_hz)
{
    constexpr double tonne_per_kg = 1e-3;
    const double omega = 2 * std::numbers::pi * frequency_hz;
    return receptance_mm_N / (1.0 - omega * omega * mass_kg * tonne_per_kg * receptance_mm_N);
}

}  // namespace lathelier::receptance
