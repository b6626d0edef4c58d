// Roles, features and suggestions of the practice parts and of single patterns.
#include "engine/features/nominal/roles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "made_recognition.h"

namespace lathelier::features {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> rolesOf(const std::vector<RecognizedRow>& rows)
{
    std::vector<std::string> roles;
    roles.reserve(rows.size());
    for (const RecognizedRow& row : rows) roles.push_back(row.role);
    return roles;
}

std::vector<std::string> featuresOf(const Recognition& recognition)
{
    std::vector<std::string> all;
    for (const RecognizedFeature& one : recognition.features)
        all.push_back(one.designation.empty() ? one.kind : one.kind + " " + one.designation);
    return all;
}

const Suggestion* suggestionOf(const RecognizedRow& row, std::string_view quantity)
{
    for (const Suggestion& one : row.suggestions)
        if (one.quantity == quantity) return &one;
    return nullptr;
}

double nominalOf(const RecognizedRow& row, std::string_view quantity)
{
    const Suggestion* one = suggestionOf(row, quantity);
    return one ? one->nominal_mm : -1;
}

Recognition described(const Table& table)
{
    Recognition result = recognitionOf(table);
    describeRows(result);
    return result;
}

TEST(Roles, ThePapersShaft)
{
    const Recognition part = described(tableOne());
    EXPECT_THAT(rolesOf(part.segments), ElementsAre("", "", "", "chamfer"));
    EXPECT_THAT(featuresOf(part), ElementsAre("shoulder", "shoulder", "chamfer 5×45°"));
    EXPECT_THAT(part.features[0].rows, ElementsAre(1, 2));
    EXPECT_EQ(nominalOf(part.segments[0], "diameter_mm"), 30);
    EXPECT_EQ(nominalOf(part.segments[2], "diameter_mm"), 33.8);
    EXPECT_EQ(nominalOf(part.segments[0], "z_mm"), 98);
    EXPECT_EQ(nominalOf(part.segments[1], "z_mm"), 108);
    EXPECT_EQ(nominalOf(part.segments[2], "z_mm"), -1);
    EXPECT_EQ(nominalOf(part.segments[3], "z_mm"), 183);
    EXPECT_EQ(nominalOf(part.segments[3], "leg_mm"), 5);
}

TEST(Roles, UndercutsAndGroove)
{
    const Recognition part = described(undercutPart());
    EXPECT_THAT(rolesOf(part.segments),
                ElementsAre("chamfer", "", "groove", "", "undercut", "undercut", "undercut", "", "undercut", "undercut",
                            "undercut", "undercut", "chamfer", "", "chamfer", "fillet", "", "", "chamfer"));
    EXPECT_THAT(featuresOf(part),
                ElementsAre("chamfer 1×45°", "groove DIN 471 - 20", "undercut DIN 509 - E 0.6×0.2", "shoulder",
                            "undercut DIN 509 - F 0.8×0.3", "shoulder", "chamfer 0.5×45°", "chamfer 0.5×45°",
                            "shoulder", "fillet R1", "shoulder", "chamfer 1.5×45°"));
    EXPECT_EQ(nominalOf(part.segments[2], "length_mm"), 1.3);
    EXPECT_EQ(nominalOf(part.segments[2], "z_mm"), -1);  // given by its width
    EXPECT_EQ(nominalOf(part.segments[1], "z_mm"), 12);
    EXPECT_EQ(nominalOf(part.segments[6], "undercut"), 0.6);
    EXPECT_EQ(nominalOf(part.segments[6], "z_mm"), 40);
    EXPECT_THAT(part.segments[5].suggestions, IsEmpty());
    EXPECT_EQ(nominalOf(part.segments[11], "z_mm"), 70);
    EXPECT_NEAR(part.features[4].z_end_mm, 70, 1e-9);
}

/// The same F as rays see it: the arc ends at the face, where it runs out of sight.
TEST(Roles, HiddenUndercut)
{
    Table table = undercutPart();
    table.erase(table.begin() + 11);
    Recognition part = recognitionOf(table);
    RecognizedRow& arc = part.segments[10];
    arc.fully_visible = false;
    arc.uncertainty.arc_radius_um = 200;
    arc.arc_radius_mm = -0.9;
    const double past = arc.z_end_mm - 70;
    for (std::size_t i = 11; i < part.segments.size(); ++i) {
        part.segments[i].z_start_mm -= past;
        part.segments[i].z_end_mm -= past;
    }
    describeRows(part);
    EXPECT_EQ(part.segments[10].role, "undercut");
    EXPECT_EQ(suggestionOf(part.segments[10], "undercut")->designation, "DIN 509 - F 0.8×0.3");
    EXPECT_EQ(nominalOf(part.segments[10], "z_mm"), 70);
    // Cut off at the face.
    arc.z_end_mm = 70;
    arc.end_diameter_mm = 24.4 + 2 * 0.27;
    describeRows(part);
    EXPECT_EQ(suggestionOf(part.segments[10], "undercut")->designation, "DIN 509 - F 0.8×0.3");
    // As a scan gave it: its circle goes 0.18 mm beyond the face that it ends at.
    arc.fully_visible = true;
    arc.uncertainty.arc_radius_um = 30;
    arc.arc_radius_mm = -0.78458;
    arc.z_start_mm = 69.3943;
    arc.end_diameter_mm = 24.9713;
    part.segments[9].z_end_mm = arc.z_start_mm;
    describeRows(part);
    EXPECT_EQ(suggestionOf(part.segments[10], "undercut")->designation, "DIN 509 - F 0.8×0.3");
}

TEST(Roles, TapersRoundsAndSaddle)
{
    const Recognition part = described(taperPart());
    EXPECT_THAT(rolesOf(part.segments), ElementsAre("edge_round", "", "fillet", "", "taper", "", "fillet", "", "saddle",
                                                    "", "edge_round", "taper", "", "chamfer"));
    EXPECT_THAT(featuresOf(part), ElementsAre("fillet R1", "fillet R0.8", "shoulder", "taper 1:10", "fillet R2.5",
                                              "shoulder", "fillet R3", "shoulder", "taper 30°", "chamfer 1×45°"));
    EXPECT_EQ(suggestionOf(part.segments[8], "radius_mm")->designation, "R60");
}

TEST(Roles, UndercutAfterItsFace)
{
    Table table = cylinder(30, 10);
    Table reversed = undercutE(20, 0.6, 0.2, 2);
    for (auto row = reversed.rbegin(); row != reversed.rend(); ++row)
        table.push_back({row->length_mm, row->end_mm, row->start_mm, row->arc_mm});
    const Recognition part = described(table + cylinder(20, 30));
    EXPECT_THAT(rolesOf(part.segments), ElementsAre("", "undercut", "undercut", "undercut", ""));
    EXPECT_THAT(featuresOf(part), ElementsAre("undercut DIN 509 - E 0.6×0.2", "shoulder"));
}

TEST(Roles, GroovesOfOtherForms)
{
    const auto roles = [](const Table& table) { return rolesOf(described(table).segments); };
    const Table bar = cylinder(20, 20);
    EXPECT_THAT(roles(bar + cone(20, 17, 1) + cylinder(17, 2) + cone(17, 20, 1) + bar),
                ElementsAre("", "groove", "groove", "groove", ""));
    EXPECT_THAT(roles(bar + Table{{2, 20, 16, -2.0}, {2, 16, 20, -2.0}} + bar),
                ElementsAre("", "groove", "groove", ""));
    EXPECT_THAT(roles(bar + filletDown(16, 0.4) + cylinder(16, 2) + filletUp(16, 0.4) + bar),
                ElementsAre("", "groove", "groove", "groove", ""));
    // Wide: a neck; its edges broken: chamfers.
    EXPECT_THAT(roles(bar + cylinder(16, 15) + bar), ElementsAre("", "", ""));
    EXPECT_THAT(roles(bar + cone(20, 19, 0.5) + cylinder(16, 3) + cone(19, 20, 0.5) + bar),
                ElementsAre("", "chamfer", "groove", "chamfer", ""));
}

TEST(Roles, SmallEdgesAreBreaks)
{
    const Recognition part = described(cylinder(20, 20) + cone(29.4, 30, 0.3) + cylinder(30, 20));
    EXPECT_THAT(featuresOf(part), ElementsAre("shoulder", "edge_break 0.2…0.4"));
    EXPECT_EQ(nominalOf(part.segments[1], "leg_mm"), -1);
}

TEST(Roles, ThreadsAndKnurls)
{
    Recognition part = recognitionOf(cone(13, 15.96, 1.5) + cylinder(15.96, 26.5) + cylinder(13.2, 4) +
                                     cylinder(18, 22) + cylinder(24, 30) + cone(24, 22, 1));
    part.marks.resize(2);
    part.marks[0].kind = MarkKind::Thread;
    part.marks[0].z_start_mm = 0;
    part.marks[0].z_end_mm = 28;
    part.marks[0].pitch_mm = 2.0001;
    part.marks[0].major_mm = 15.96;
    part.marks[1].kind = MarkKind::Knurl;
    part.marks[1].z_start_mm = 54;
    part.marks[1].z_end_mm = 84;
    describeRows(part);
    EXPECT_THAT(rolesOf(part.segments), ElementsAre("chamfer", "thread", "groove", "", "knurl", "chamfer"));
    EXPECT_EQ(part.marks[0].designation, "M16×2");
    EXPECT_EQ(suggestionOf(part.segments[1], "diameter_mm")->designation, "M16×2");
}

TEST(Roles, AChamferGoesOnInAKnurl)
{
    Recognition part = recognitionOf(cylinder(18, 20) + cylinder(24.02, 30) + cone(24.08, 22.08, 1));
    part.marks.resize(1);
    part.marks[0].kind = MarkKind::Knurl;
    part.marks[0].z_start_mm = 20;
    part.marks[0].z_end_mm = 50;
    describeRows(part);
    EXPECT_THAT(rolesOf(part.segments), ElementsAre("", "knurl", "chamfer"));
    EXPECT_THAT(featuresOf(part), ElementsAre("shoulder", "chamfer 1×45°"));
}

TEST(Roles, Bores)
{
    Recognition part = recognitionOf(cylinder(60, 48));
    part.bores = {rowsOf(cone(42, 40, 1) + cylinder(40.005, 17) + cylinder(32, 21))};
    std::vector<RecognizedRow> chuck = rowsOf(cone(49, 47, 1) + cylinder(47, 8));
    for (RecognizedRow& row : chuck) {
        row.z_start_mm = 48 - row.z_start_mm;
        row.z_end_mm = 48 - row.z_end_mm;
    }
    part.bores.push_back(chuck);
    part.bores[0][0].end_diameter_mm = 40.005;
    describeRows(part);
    EXPECT_THAT(rolesOf(part.bores[0]), ElementsAre("chamfer", "", ""));
    EXPECT_THAT(rolesOf(part.bores[1]), ElementsAre("chamfer", ""));
    EXPECT_THAT(suggestionOf(part.bores[0][1], "diameter_mm")->fits, ElementsAre("H5", "H6", "JS6"));
    EXPECT_EQ(nominalOf(part.bores[0][1], "z_mm"), 18);
    EXPECT_EQ(nominalOf(part.bores[1][1], "z_mm"), 9);
    EXPECT_EQ(suggestionOf(part.bores[1][0], "leg_mm")->designation, "1×45°");
}

TEST(Roles, NothingIsSuggestedUnaskedOrFromAThinArc)
{
    Recognition none = recognitionOf(tableOne());
    none.parameters.snap = Snap::None;
    describeRows(none);
    EXPECT_THAT(featuresOf(none), ElementsAre("shoulder", "shoulder", "chamfer"));
    for (const RecognizedRow& row : none.segments) EXPECT_THAT(row.suggestions, IsEmpty());
    Recognition thin = recognitionOf(tableOne());
    thin.segments[1].coverage_deg = 170;
    describeRows(thin);
    EXPECT_THAT(thin.segments[1].suggestions, IsEmpty());
    EXPECT_EQ(nominalOf(thin.segments[0], "z_mm"), -1);
    EXPECT_EQ(nominalOf(thin.segments[0], "diameter_mm"), 30);
}

TEST(Roles, AnEndOfTheDataIsNoChamfer)
{
    Recognition part = recognitionOf(tableOne());
    part.ends[1].closed_by = "data";
    describeRows(part);
    EXPECT_EQ(part.segments[3].role, "taper");
    EXPECT_EQ(nominalOf(part.segments[3], "z_mm"), -1);
}

}  // namespace
}  // namespace lathelier::features
