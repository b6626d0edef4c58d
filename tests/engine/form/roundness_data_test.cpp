// The practice data with certified answers, through the whole evaluation.
#include <gtest/gtest.h>

#include "engine/form/form_codes.h"
#include "engine/form/roundness/roundness.h"
#include "tests/engine/form/form_data.h"

namespace lathelier::form {
namespace {

class PracticeEvaluation : public testing::TestWithParam<const char*> {};

TEST_P(PracticeEvaluation, HasTheCertifiedDeviations)
{
    const std::string name = GetParam();
    Profile profile;
    profile.points_mm = readPoints(name);
    ASSERT_GE(profile.points_mm.size(), 8u);
    const nlohmann::json answers = readAnswers(name);
    const RoundnessResult result = roundness(profile);
    for (const ReferenceCircle which :
         {ReferenceCircle::LSCI, ReferenceCircle::MZCI, ReferenceCircle::MICI, ReferenceCircle::MCCI}) {
        const std::string key(form::name(which));
        const double expected = answers.at(key).at("RONt").get<double>();
        // p07's MICI has two equal optima on both sides; all its values are the same there.
        EXPECT_NEAR(result.circles.of(which).RONt_um / 1000, expected, 2e-9) << key;
        EXPECT_GE(result.circles.of(which).RONt_um, result.circles.MZCI.RONt_um - 1e-9) << key;
    }
    EXPECT_EQ(result.evaluated_mm.size(), profile.points_mm.size());
    EXPECT_EQ(result.harmonics.size(), std::min<std::size_t>(profile.points_mm.size() / 2, 500));
    EXPECT_EQ(contains(result.notes, notes::gapsInProfile), name == "p19_keyway_n3600");
    EXPECT_EQ(contains(result.notes, notes::inscribedNotUnique), name == "p07_ellipse_n200");
}

INSTANTIATE_TEST_SUITE_P(Form, PracticeEvaluation,
                         testing::Values("p05_lobe5_n200", "p07_ellipse_n200", "p10_turned_n200", "p13_outliers_n200",
                                         "p17_8pts", "p19_keyway_n3600"));

TEST(PracticeEvaluations, TheLobesAreFound)
{
    Profile profile;
    profile.points_mm = readPoints("p05_lobe5_n200");
    const RoundnessResult lobes = roundness(profile);
    EXPECT_NEAR(lobes.harmonics[4].amplitude, 3, 1e-5);
    EXPECT_NEAR(lobes.harmonics[4].phase_rad, 0, 1e-5);
    ASSERT_EQ(lobes.hints.size(), 1u);
    EXPECT_EQ(lobes.hints[0].upr, 5);
    // A peak of 30 µm and a pit of 25 µm lie on p13.
    profile.points_mm = readPoints("p13_outliers_n200");
    RoundnessParameters parameters;
    parameters.outliers = OutlierRule::Hampel;
    const RoundnessResult cleaned = roundness(profile, parameters);
    EXPECT_FALSE(cleaned.used[37]);
    EXPECT_FALSE(cleaned.used[151]);
    EXPECT_LT(cleaned.circles.MZCI.RONt_um, 20);
}

}  // namespace
}  // namespace lathelier::form
