// SETUP.json: read, written, refused with line and column.
#include "engine/deflection/setup_file.h"

#include <gtest/gtest.h>

#include "../core/code_of_error.h"
#include "case_a.h"
#include "engine/core/core_codes.h"
#include "engine/deflection/deflection_codes.h"
#include "engine/io/io_codes.h"

namespace lathelier::deflection {
namespace {

const std::string caseAText = R"({"stock": "caseA.txt", "z_zero_mm": 0,
 "material": {"elastic_modulus_MPa": 210150, "poisson_ratio": 0.28, "K_tc_N_mm2": 1748.5, "K_te_N_mm": 99.2,
              "K_rfc_N_mm2": 703, "K_rfe_N_mm": 92.5},
 "tool": {"lead_angle_deg": -5, "corner_radius_mm": 0.8},
 "chuck": {"radial_N_mm": 33000, "axial_N_mm": 1e15, "tilt_N_mm_rad": 6.87e7, "torsion_N_mm_rad": 3e7},
 "tailstock": {"radial_N_mm": 5500, "axial_N_mm": 1e15, "tilt_N_mm_rad": 0, "torsion_N_mm_rad": 0},
 "steady_rests": [], "contact_length": "arc", "feed_moment": false, "shear": "cowper", "step_mm": 0.5})";

TEST(SetupFile, CaseA)
{
    Notes notes;
    TurningSetup expected = caseASetup();
    expected.stock = "caseA.txt";
    EXPECT_EQ(readSetup(caseAText, notes), expected);
    EXPECT_TRUE(contains(notes, notes::springsBesideDiameter));
    EXPECT_EQ(notes.size(), 1U);
    EXPECT_EQ(readSetup(setupText(expected), notes), expected);
}

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
    return text.replace(text.find(from), from.size(), to);
}

TEST(SetupFile, OptionalParts)
{
    Notes notes;
    std::string text =
        replaced(caseAText, R"("steady_rests": [])", R"("steady_rests": [{"z_mm": 90, "radial_N_mm": 8000}],
 "follower_rest": {"offset_mm": -6, "radial_N_mm": 9000}, "tool_post": {"radial_N_mm": 5e4, "tangential_N_mm": 4e4})");
    const std::size_t from = text.find("\"tailstock\""), to = text.find("\"steady_rests\"");
    text.replace(from, to - from, "\"tailstock\": null, ");
    const TurningSetup setup = readSetup(text, notes);
    EXPECT_FALSE(setup.tailstock);
    ASSERT_EQ(setup.steady_rests.size(), 1U);
    EXPECT_EQ(setup.steady_rests[0].z_mm, 90);
    EXPECT_EQ(setup.follower_rest->offset_mm, -6);
    EXPECT_EQ(setup.tool_post->tangential_N_mm, 4e4);
    EXPECT_EQ(readSetup(setupText(setup), notes), setup);
}

Values refusal(const std::string& text, const ErrorCode& code)
{
    Notes notes;
    try {
        readSetup(text, notes);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), code) << error.what();
        return error.values();
    }
    ADD_FAILURE() << "no error";
    return {};
}

TEST(SetupFile, RefusalsNameTheirPlace)
{
    const Values wrong = refusal(replaced(caseAText, "33000", "\"stiff\""), errors::malformed);
    ASSERT_TRUE(find(wrong, "line"));
    EXPECT_EQ(*find(wrong, "line"), Value(std::int64_t{5}));
    EXPECT_TRUE(find(wrong, "column"));
    const Values far = refusal(replaced(caseAText, "0.28", "0.8"), errors::keyOutOfRange);
    EXPECT_EQ(*find(far, "line"), Value(std::int64_t{2}));
    refusal(replaced(caseAText, R"("K_tc_N_mm2": 1748.5, )", ""), errors::keyMissing);
    refusal(replaced(caseAText, R"("arc")", R"("round")"), errors::malformed);
    refusal(replaced(caseAText, R"("tool": {"lead_angle_deg": -5, "corner_radius_mm": 0.8},)", ""), errors::keyMissing);
    refusal("[1]", errors::malformed);
    refusal("{", errors::malformed);
}

TEST(SetupFile, TheEnteringAngleMayBeStatedAsALeadAngle)
{
    Notes notes;
    const TurningSetup former = readSetup(caseAText, notes);
    EXPECT_EQ(former.tool.entering_angle_deg, 95);
    const std::string today = replaced(caseAText, R"("lead_angle_deg": -5)", R"("entering_angle_deg": 95)");
    EXPECT_EQ(readSetup(today, notes), former);
    EXPECT_FALSE(contains(notes, notes::unknownKey));
    EXPECT_EQ(setupText(former).find("lead_angle"), std::string::npos);
    // Stated twice: both keys, and the place of the former one.
    const Values twice =
        refusal(replaced(caseAText, R"("lead_angle_deg": -5)", R"("entering_angle_deg": 95, "lead_angle_deg": -5)"),
                errors::valueStatedTwice);
    EXPECT_EQ(*find(twice, "former"), Value(std::string("tool.lead_angle_deg")));
    EXPECT_EQ(*find(twice, "key"), Value(std::string("tool.entering_angle_deg")));
    EXPECT_EQ(*find(twice, "line"), Value(std::int64_t{4}));
    EXPECT_EQ(*find(twice, "column"), Value(std::int64_t{55}));
    // The range is that of the key that is stated.
    const Values far =
        refusal(replaced(caseAText, R"("lead_angle_deg": -5)", R"("lead_angle_deg": 85)"), errors::keyOutOfRange);
    EXPECT_EQ(*find(far, "key"), Value(std::string("tool.lead_angle_deg")));
    EXPECT_EQ(*find(far, "maximum"), Value(80.0));
    refusal(replaced(caseAText, R"("lead_angle_deg": -5, )", ""), errors::keyMissing);
}

TEST(SetupFile, AKindOfFile)
{
    EXPECT_EQ(setupFiles().sniff("setup.json", caseAText, {}), io::Likeness::Certain);
    EXPECT_EQ(setupFiles().sniff("x.json", R"({"segments": []})", {}), io::Likeness::No);
}

}  // namespace
}  // namespace lathelier::deflection
