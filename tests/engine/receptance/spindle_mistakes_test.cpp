// Mistakes of tap tests: named rightly, never where nothing is wrong. The responses are made by finite elements.
#include <gtest/gtest.h>

#include "engine/core/error.h"
#include "engine/receptance/eirc/identify_spindle.h"
#include "engine/receptance/receptance_codes.h"
#include "tapped_rods.h"

namespace lathelier::receptance {
namespace {

constexpr double step_hz = 5;

/// Both machines with both kinds of noise.
struct Case {
    bool is_stiff;
    bool is_sensor;  ///< noise of the sensor with coherence; else 1 % of each response
};

const SpindleMeasurements& clean(bool is_stiff)
{
    static const SpindleMeasurements stiff = tapTests(stiffMachine(), threeTappedRods, 0, 1500, step_hz);
    static const SpindleMeasurements soft = tapTests(softMachine(), threeTappedRods, 0, 1500, step_hz);
    return is_stiff ? stiff : soft;
}

SpindleMeasurements noisy(const Case& one, std::uint64_t seed)
{
    return one.is_sensor ? withSensorNoise(clean(one.is_stiff), 200, 5, seed)
                         : withProportionalNoise(clean(one.is_stiff), 0.01, seed);
}

class SpindleMistakes : public testing::TestWithParam<Case> {
protected:
    /// The residual with the remedy is that of sound tests, and the note says so.
    static void expectMended(const SpindleIdentification& found, const SpindleIdentification& sound,
                             const NoteCode& code, const char* what)
    {
        ASSERT_TRUE(found.remedy) << what;
        EXPECT_TRUE(contains(found.notes, code)) << what;
        EXPECT_LT(found.remedy->rms_percent, 1.3 * sound.residual_rms_percent) << what;
        EXPECT_GT(found.residual_rms_percent, found.remedy->rms_percent) << what;
    }

    const SpindleMeasurements sound_ = noisy(GetParam(), 1);
    const SpindleIdentification soundFit_ = identifySpindle(sound_);
};

TEST_P(SpindleMistakes, AHammerTurnedRound)
{
    for (const std::size_t frf : {0U, 7U, 16U}) {
        SpindleMeasurements wrong = sound_;
        for (Complex& value : wrong.frfs[frf].frf.value) value = -value;
        const auto found = identifySpindle(wrong);
        expectMended(found, soundFit_, notes::spindleSignTurned, std::to_string(frf).c_str());
        ASSERT_TRUE(found.remedy);
        EXPECT_EQ(found.remedy->remedy.kind, RemedyKind::Sign);
        EXPECT_EQ(found.remedy->remedy.frf, frf);
        EXPECT_TRUE(contains(found.notes, notes::spindleNotExplained));
    }
}

TEST_P(SpindleMistakes, TwoNodesSwapped)
{
    for (std::size_t rod = 0; rod < 3; ++rod)
        for (const auto& [a, b] : {std::pair<std::size_t, std::size_t>{0, 1}, {0, 2}, {1, 2}}) {
            SpindleMeasurements wrong = sound_;
            std::vector<double>& distances_mm = wrong.rods[rod].distance_from_chuck_mm;
            std::swap(distances_mm[a], distances_mm[b]);
            const auto found = identifySpindle(wrong);
            const std::string what = std::to_string(rod) + ": " + std::to_string(a) + " " + std::to_string(b);
            expectMended(found, soundFit_, notes::spindlePointsSwapped, what.c_str());
            ASSERT_TRUE(found.remedy) << what;
            EXPECT_EQ(found.remedy->remedy.kind, RemedyKind::Swap) << what;
            EXPECT_EQ(found.remedy->remedy.rod, rod) << what;
            EXPECT_EQ(found.remedy->remedy.point_a, a) << what;
            EXPECT_EQ(found.remedy->remedy.point_b, b) << what;
        }
}

TEST_P(SpindleMistakes, ADistanceStatedWrongly)
{
    struct Wrong {
        std::size_t rod, point;
        double by_mm;
    };
    for (const Wrong& one : {Wrong{0, 0, 5}, {0, 2, -5}, {1, 1, 5}, {1, 2, -10}, {2, 1, 10}}) {
        SpindleMeasurements wrong = sound_;
        double& distance_mm = wrong.rods[one.rod].distance_from_chuck_mm[one.point];
        const double true_mm = distance_mm;
        distance_mm += one.by_mm;
        const auto found = identifySpindle(wrong);
        const std::string what = std::to_string(one.rod) + ": " + std::to_string(one.point);
        expectMended(found, soundFit_, notes::spindlePointMisplaced, what.c_str());
        ASSERT_TRUE(found.remedy) << what;
        EXPECT_EQ(found.remedy->remedy.kind, RemedyKind::Distance) << what;
        EXPECT_EQ(found.remedy->remedy.rod, one.rod) << what;
        EXPECT_EQ(found.remedy->remedy.point_a, one.point) << what;
        EXPECT_NEAR(found.remedy->remedy.fitted_mm, true_mm, 0.5) << what;
        EXPECT_LE(found.remedy->remedy.fitted_mm, threeTappedRods[one.rod].length_mm) << what;
    }
}

TEST_P(SpindleMistakes, NothingWrongIsNotNamed)
{
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const SpindleMeasurements sound = noisy(GetParam(), 100 + seed);
        SpindleMeasurements shifted = sound, sparse = sound;
        std::uint64_t draw = 0;
        for (MeasuredRod& rod : shifted.rods)
            for (double& distance_mm : rod.distance_from_chuck_mm)
                distance_mm = std::min(distance_mm + randomUniform(5, seed, draw++) - 0.5, rod.shaft.length_mm());
        std::erase_if(sparse.frfs, [&](const RodFrf&) { return randomUniform(6, seed, draw++) < 0.4; });
        for (const SpindleMeasurements* const one :
             std::initializer_list<const SpindleMeasurements*>{&sound, &shifted, &sparse}) {
            const auto found = identifySpindle(*one);
            EXPECT_FALSE(found.remedy) << seed << " " << (found.remedy ? key(found.remedy->remedy.kind) : "");
            if (one == &shifted) continue;
            EXPECT_FALSE(contains(found.notes, notes::spindleNotPassive)) << seed;
            EXPECT_FALSE(contains(found.notes, notes::spindleNotExplained)) << seed;
        }
    }
}

TEST_P(SpindleMistakes, TheNoiseIsWhatTheFitLeaves)
{
    EXPECT_NEAR(*soundFit_.chi2_per_dof, 1, 0.25);
    EXPECT_NEAR(*soundFit_.expected_rms_percent / soundFit_.residual_rms_percent, 1, 0.25);
    EXPECT_EQ(soundFit_.noise_from, GetParam().is_sensor ? NoiseSource::Scaled : NoiseSource::Scatter);
    for (const auto& chi2 : soundFit_.chi2_per_dof_of_frfs) EXPECT_NEAR(chi2.value_or(0), 1, 0.6);
    if (!GetParam().is_sensor) return;
    SpindleMeasurements stated = sound_;
    stated.averages = 5;
    const auto found = identifySpindle(stated);
    EXPECT_EQ(found.noise_from, NoiseSource::Averages);
    EXPECT_NEAR(*found.chi2_per_dof, 1, 0.25);
}

INSTANTIATE_TEST_SUITE_P(MachinesAndNoise, SpindleMistakes,
                         testing::Values(Case{true, false}, Case{true, true}, Case{false, false}, Case{false, true}));

/// 100·rms of the tip's response of a new part D30 x 183 on the found machine against the true one.
double newPartPercent(const Machine& machine, const SpindleReceptance& found)
{
    const FiniteRod part(183, 30, {});
    double sum = 0, count = 0;
    for (double f = 60; f < 1500; f += step_hz) {
        const auto tip = static_cast<Eigen::Index>(part.nodeAt(183));
        const Complex is = part.deflections(f, found.at(f), {183}, 183, 0)(tip, 0);
        const Complex should = part.deflections(f, machine(f), {183}, 183, 0)(tip, 0);
        sum += std::norm(is / should - 1.0);
        ++count;
    }
    return 100 * std::sqrt(sum / count);
}

TEST(SpindleMass, OfAnAccelerometerIsUndone)
{
    for (const Machine& machine : {stiffMachine(), softMachine()}) {
        SpindleMeasurements measured = withSensorNoise(tapTests(machine, threeTappedRods, 5, 1500, step_hz), 200, 5, 3);
        IdentificationParameters parameters;
        parameters.smooth = true;
        EXPECT_GT(newPartPercent(machine, identifySpindle(measured, parameters).spindle), 2.5);
        for (MeasuredRod& rod : measured.rods) rod.accelerometer_mass_g.assign(3, 5);
        EXPECT_LT(newPartPercent(machine, identifySpindle(measured, parameters).spindle), 1.5);
    }
}

TEST(SpindleMass, WithoutNoiseIsExact)
{
    SpindleMeasurements measured = tapTests(softMachine(), threeTappedRods, 20, 1500, step_hz);
    for (MeasuredRod& rod : measured.rods) rod.accelerometer_mass_g.assign(3, 20);
    EXPECT_LT(newPartPercent(softMachine(), identifySpindle(measured).spindle), 0.1);
}

TEST(SpindlePassivity, IsJudgedByTheUncertainty)
{
    const Machine active = madeMachine(60000, 6e8, -0.1, {});
    const auto measured = withProportionalNoise(tapTests(active, threeTappedRods, 0, 1500, step_hz), 0.01, 1);
    EXPECT_TRUE(contains(identifySpindle(measured).notes, notes::spindleNotPassive));
}

TEST(SpindleMeasurementsFile, TheNearestMassCounts)
{
    Notes notes;
    const MeasurementFile file = readMeasurements(
        R"({"frf": "a.uff", "averages": 5, "accelerometer_mass_g": 2, "rods": [
            {"length_mm": 150, "diameter_mm": 40, "points": [{"node": 11, "distance_from_chuck_mm": 50}]},
            {"length_mm": 150, "diameter_mm": 40, "accelerometer_mass_g": 3, "points": [
                {"node": 21, "distance_from_chuck_mm": 50, "accelerometer_mass_g": 0.5},
                {"node": 22, "distance_from_chuck_mm": 60}]}]})",
        notes);
    EXPECT_TRUE(notes.empty());
    const std::vector<NodeFrf> frfs{{11, 11, {}}, {21, 22, {}}};
    const SpindleMeasurements all = measurementsOf(file, frfs);
    EXPECT_EQ(all.averages, 5);
    EXPECT_EQ(all.rods[0].massAt(0), 2);
    EXPECT_EQ(all.rods[1].massAt(0), 0.5);
    EXPECT_EQ(all.rods[1].massAt(1), 3);
    EXPECT_EQ(all.rods[1].nodeOf(1), 22);
    EXPECT_EQ(all.frfs[1].point_a, 0U);  // responds
}

}  // namespace
}  // namespace lathelier::receptance
