// Coverage of the stated uncertainty of a general pose.
#include "engine/registration/general/general_uncertainty.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/registration/general/general.h"
#include "engine/registration/general/general_reference.h"
#include "engine/sample/sample.h"
#include "tests/engine/registration/noisy_scan.h"

namespace lathelier::registration {
namespace {

using namespace testing_noise;
using Eigen::Vector3d;

struct Coverage {
    int translation = 0;
    int rotation = 0;
    double stated_um = 0;  ///< root mean square
    double error_um = 0;
    double stated_deg = 0;
    double error_deg = 0;
};

constexpr int cases = 100;

/// Scans of the bracket onto its mesh, or onto 10 other scans of it, all in the same place: what the alignment moves is
/// error.
Coverage coverageOf(Noise kind, bool onto_mesh)
{
    const Scan mesh = sample::bracketMesh();
    GeneralReference reference;
    if (onto_mesh) reference = prepareReference(mesh);
    Coverage c;
    for (int i = 0; i < cases; ++i) {
        const auto seed = static_cast<std::uint64_t>(1000 * static_cast<int>(kind) + i);
        if (!onto_mesh && i % 10 == 0) reference = prepareReference(noisyScan(mesh, kind, 18000, 0.05, 2 * seed + 2));
        const Scan copy = noisyScan(mesh, kind, 1500, 0.05, 2 * seed + 1);
        const Alignment a = alignGeneral(reference, copy, CompareMethod::Plane, InitialPose::Identity);
        Vector3d centre = Vector3d::Zero();
        for (const Vector3d& p : copy.points_mm) centre += p / static_cast<double>(copy.points_mm.size());
        const double shift_um = 1000 * (a.reference_T_copy * centre - centre).norm();
        const double turn_deg = Eigen::AngleAxisd(a.reference_T_copy.linear()).angle() * 180 / std::numbers::pi;
        c.translation += shift_um <= a.uncertainty.axial_um;
        c.rotation += turn_deg <= a.uncertainty.axis_deg;
        c.stated_um += a.uncertainty.axial_um * a.uncertainty.axial_um / cases;
        c.error_um += shift_um * shift_um / cases;
        c.stated_deg += a.uncertainty.axis_deg * a.uncertainty.axis_deg / cases;
        c.error_deg += turn_deg * turn_deg / cases;
    }
    for (double* v : {&c.stated_um, &c.error_um, &c.stated_deg, &c.error_deg}) *v = std::sqrt(*v);
    return c;
}

/// Coverage of k = 2 is 95 % for independent noise. With a correlation length estimated from the data: at least 90 %,
/// and an uncertainty of at most four times the true error.
void expectHonest(const Coverage& c)
{
    EXPECT_GE(c.translation, 90);
    EXPECT_GE(c.rotation, 90);
    EXPECT_LE(c.translation, 99);
    EXPECT_LE(c.rotation, 99);
    EXPECT_LT(c.stated_um, 4 * c.error_um);
    EXPECT_LT(c.stated_deg, 4 * c.error_deg);
}

TEST(GeneralUncertainty, HoldsTheTruthOntoAMeshOverKindsOfNoise)
{
    for (const Noise kind : {Noise::White, Noise::AlongLinesInAnyOrder, Noise::UnevenCoverage, Noise::Spikes}) {
        SCOPED_TRACE(nameOf(kind));
        expectHonest(coverageOf(kind, true));
    }
}

TEST(GeneralUncertainty, HoldsTheTruthOntoAScanWhoseNoiseIsAlikeToo)
{
    expectHonest(coverageOf(Noise::AlongLines, false));
}

}  // namespace
}  // namespace lathelier::registration
