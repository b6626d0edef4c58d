// The certified answers of the practice data, and the NIST reference fits.
#include <gtest/gtest.h>

#include <set>

#include "engine/form/circle/circles.h"
#include "tests/engine/form/form_data.h"

namespace lathelier::form {
namespace {

constexpr double answer_mm = 2e-9;

class PracticeCircles : public testing::TestWithParam<const char*> {};

TEST_P(PracticeCircles, AgreesWithItsCertifiedAnswers)
{
    const auto points = readPoints(GetParam());
    const auto answers = readAnswers(GetParam());
    const ReferenceCircles circles = fitCircles(points);
    const bool two_inscribed = std::string(GetParam()) == "p07_ellipse_n200";  // values only
    for (const auto kind :
         {ReferenceCircle::LSCI, ReferenceCircle::MZCI, ReferenceCircle::MICI, ReferenceCircle::MCCI}) {
        const auto& answer = answers.at(std::string(name(kind)));
        const FittedCircle& circle = circles.of(kind);
        SCOPED_TRACE(std::string(name(kind)));
        EXPECT_NEAR(circle.RONt_um / 1000, answer.at("RONt").get<double>(), answer_mm);
        EXPECT_NEAR(circle.radius_mm, answer.at("R").get<double>(), answer_mm);
        if (!two_inscribed || kind != ReferenceCircle::MICI) {
            EXPECT_NEAR(circle.centre_mm.x(), answer.at("cx").get<double>(), 1e-8);
            EXPECT_NEAR(circle.centre_mm.y(), answer.at("cy").get<double>(), 1e-8);
        }
    }
    EXPECT_NEAR(circles.LSCI.RONq_um / 1000, answers.at("LSCI").at("RONq").get<double>(), answer_mm);
    EXPECT_NEAR(circles.LSCI.RONp_um / 1000, answers.at("LSCI").at("RONp").get<double>(), answer_mm);
    EXPECT_NEAR(circles.LSCI.RONv_um / 1000, answers.at("LSCI").at("RONv").get<double>(), answer_mm);
    EXPECT_NEAR(circles.MZCI.outer_radius_mm, answers.at("MZCI").at("Ro").get<double>(), answer_mm);
    EXPECT_NEAR(circles.MZCI.inner_radius_mm, answers.at("MZCI").at("Ri").get<double>(), answer_mm);
    EXPECT_TRUE(circles.MZCI.unique);
    EXPECT_EQ(circles.MICI.unique, !two_inscribed);
    EXPECT_LE(*circles.MZCI.certified_gap_um, 1.001e-6);
    EXPECT_LE(*circles.MICI.certified_gap_um, 1.001e-6);
}

INSTANTIATE_TEST_SUITE_P(Form, PracticeCircles,
                         testing::Values("p05_lobe5_n200", "p07_ellipse_n200", "p10_turned_n200", "p13_outliers_n200",
                                         "p17_8pts", "p19_keyway_n3600"));

TEST(PracticeCirclesContacts, AreThoseOfTheAnswer)
{
    for (const char* name : {"p10_turned_n200", "p13_outliers_n200", "p19_keyway_n3600"}) {
        const auto support = readAnswers(name).at("MZCI").at("support");
        std::set<std::size_t> outer, inner;
        for (const CircleContact& contact : fitCircles(readPoints(name)).MZCI.contacts)
            (contact.side == CircleContact::Side::Outer ? outer : inner).insert(contact.index);
        EXPECT_EQ(outer, support[0].get<std::set<std::size_t>>()) << name;
        EXPECT_EQ(inner, support[1].get<std::set<std::size_t>>()) << name;
    }
}

TEST(NistCircles, LeastSquaresAgreesToABillionth)
{
    int sets = 0;
    for (const auto& entry : std::filesystem::directory_iterator(nistLikeData())) {
        if (entry.path().extension() != ".ds") continue;
        ++sets;
        SCOPED_TRACE(entry.path().filename().string());
        std::ifstream fit(std::filesystem::path(entry.path()).replace_extension(".fit"));
        Eigen::Vector3d centre, normal;
        double diameter = 0;
        fit >> centre[0] >> centre[1] >> centre[2] >> normal[0] >> normal[1] >> normal[2] >> diameter;
        ASSERT_TRUE(fit);
        Eigen::Index across = 0;  // the circles lie in coordinate planes
        normal.cwiseAbs().maxCoeff(&across);
        const Eigen::Index u = (across + 1) % 3, v = (across + 2) % 3;
        std::ifstream data(entry.path());
        std::size_t count = 0;
        data >> count;
        std::vector<Eigen::Vector2d> points;
        for (Eigen::Vector3d p; data >> p[0] >> p[1] >> p[2];) points.emplace_back(p[u], p[v]);
        ASSERT_EQ(points.size(), count);
        const FittedCircle circle = fitLeastSquaresCircle(points);
        EXPECT_NEAR(2 * circle.radius_mm, diameter, 1e-9 * diameter);
        EXPECT_NEAR(circle.centre_mm.x(), centre[u], 1e-9 * diameter);
        EXPECT_NEAR(circle.centre_mm.y(), centre[v], 1e-9 * diameter);
    }
    EXPECT_EQ(sets, 10);
}

}  // namespace
}  // namespace lathelier::form
