// Shafts as CSV: Table 1 of the paper, round trip of the full table, decimal commas, refusals.
#include "engine/cad/shaft_csv.h"

#include <gtest/gtest.h>

#include "../core/code_of_error.h"
#include "engine/cad/steps_view.h"
#include "engine/io/io_codes.h"
#include "parts.h"

namespace lathelier::cad {
namespace {

constexpr CsvStyle comma{',', ';'};

/// The part of a shaft that a CSV file represents.
Shaft nameless(Shaft shaft)
{
    shaft.name.clear();
    return shaft;
}

Shaft read(const std::string& text)
{
    Notes notes;
    const Shaft shaft = readShaftCsv(text, notes);
    EXPECT_TRUE(notes.empty());
    return shaft;
}

TEST(StepsView, ThePapersTableOne)
{
    const std::vector<ShaftStep> truth{
        {0, 0, 15, 0, 98, 0, 0}, {0, 0, 18.5, 98, 108, 0, 0}, {0, 0, 16.9, 108, 183, 0, 5}};
    EXPECT_EQ(stepsOf(tableOne()), truth);
    EXPECT_TRUE(rowsBesideSteps(tableOne()).empty());
    EXPECT_EQ(stepsCsv(tableOne()),
              "no,x_mm,y_mm,radius_mm,z_start_mm,z_end_mm,chamfer_start_mm,chamfer_end_mm\n"
              "1,0,0,15,0,98,0,0\n2,0,0,18.5,98,108,0,0\n3,0,0,16.9,108,183,0,5\n");
}

TEST(StepsView, ChamfersWithoutARoleAreFoldedTapersAreNot)
{
    Shaft shaft;
    shaft.segments = {row(1, 18, 20),  row(20, 20, 20), row(1, 20, 18), row(20, 30, 30),
                      row(30, 30, 33), row(10, 33, 33), row(2, 33, 29), row(10, 29, 29)};
    const std::vector<ShaftStep> steps = stepsOf(shaft);
    ASSERT_EQ(steps.size(), 4U);
    EXPECT_EQ(steps[0], (ShaftStep{0, 0, 10, 0, 22, 1, 1}));
    EXPECT_EQ(steps[2].chamfer_start_mm, 0);
    EXPECT_EQ(rowsBesideSteps(shaft), (std::vector<std::size_t>{4, 6}));  // a transition is no chamfer
    EXPECT_EQ(rowsBesideSteps(taper()).size(), 8U - 1U);
    EXPECT_NE(stepsCsv(taper()).find("# row 9: length 24 mm, diameters 42 to 42 mm, arc radius -60 mm"),
              std::string::npos);
}

TEST(ShaftCsv, TheFullTableComesBackToTheSameBits)
{
    for (Shaft shaft : allParts()) {
        shaft.segments[0].tolerance = SizeTolerance{"h6", {}, {}};
        shaft.segments[1].tolerance = SizeTolerance{"", -13.0, 0.0};
        shaft.segments[1].measured.emplace();
        shaft.segments[1].measured->start_diameter_mm = 1.0 / 3;
        shaft.segments[1].measured->uncertainty.angle_deg = 0.02;
        EXPECT_EQ(read(shaftCsv(shaft)), nameless(shaft)) << shaft.name;
        EXPECT_EQ(read(shaftCsv(shaft, comma)), nameless(shaft)) << shaft.name;
        EXPECT_EQ(read(shaftCsv(shaft, {'.', '\t'})), nameless(shaft)) << shaft.name;
        EXPECT_EQ(read(shaftCsv(shaft, {',', ','})), nameless(shaft)) << shaft.name;  // quoted numbers
    }
    Shaft marked = tableOne();
    marked.marks = {{MarkKind::Keyway}, {MarkKind::Other}};
    marked.marks[0].z_start_mm = 1.0 / 3;
    marked.marks[0].width_mm = 8;
    marked.marks[0].designation = "DIN 6885, \"A\" 8×7×40";
    marked.marks[1].other_kind = "logo";
    EXPECT_EQ(read(shaftCsv(marked)), nameless(marked));
    EXPECT_EQ(read(shaftCsv(marked, comma)), nameless(marked));
    Shaft bored = tableOne();
    for (ShaftSegment& one : bored.segments) one.bore_diameter_mm = 8.5;
    EXPECT_EQ(read(shaftCsv(bored)), nameless(bored));
}

TEST(ShaftCsv, TableOneComesBack)
{
    for (const CsvStyle& style : {CsvStyle{}, comma}) {
        const Shaft found = read(stepsCsv(tableOne(), style));
        ASSERT_EQ(found.segments.size(), 4U);
        for (std::size_t i = 0; i < 4; ++i) {
            EXPECT_NEAR(found.segments[i].length_mm, tableOne().segments[i].length_mm, 1e-12);
            EXPECT_NEAR(found.segments[i].end_diameter_mm, tableOne().segments[i].end_diameter_mm, 1e-12);
            EXPECT_EQ(found.segments[i].role, tableOne().segments[i].role);
        }
    }
    EXPECT_EQ(read("\xEF\xBB\xBFno;radius_mm;z_start_mm;z_end_mm\r\n1;10,5;0;20,25\r\n").segments[0].length_mm, 20.25);
}

TEST(ShaftCsv, Refusals)
{
    const auto refusal = [](const std::string& text) {
        return codeOfError([&] {
            Notes notes;
            readShaftCsv(text, notes);
        });
    };
    EXPECT_EQ(refusal(""), errors::fileEmpty);
    EXPECT_EQ(refusal("# nothing\n"), errors::fileEmpty);
    EXPECT_EQ(refusal("a,b\n1,2\n"), errors::columnsUnknown);
    const std::string head = "length_mm,start_diameter_mm,end_diameter_mm\n";
    EXPECT_EQ(refusal(head + "1,2,\n"), errors::malformed);
    EXPECT_EQ(refusal(head + "1,2,x\n"), errors::malformed);
    EXPECT_EQ(refusal(head + "1,2,inf\n"), errors::malformed);
    EXPECT_EQ(refusal(head + "1,2,1e999\n"), errors::malformed);
    EXPECT_EQ(refusal(head + "30,5,20,20\n"), errors::malformed);  // a decimal comma among commas
    EXPECT_EQ(refusal("contour," + head + "inside,1,2,2\n"), errors::malformed);
    const std::string steps = "radius_mm,z_start_mm,z_end_mm,chamfer_end_mm\n";
    EXPECT_EQ(refusal(steps + "10,0,20,0\n10,21,30,0\n"), errors::malformed);
    EXPECT_EQ(refusal(steps + "10,0,20,20\n"), errors::malformed);
    Notes notes;
    readShaftCsv("colour," + head + "red,1,2,2\n", notes);
    EXPECT_TRUE(contains(notes, notes::unknownKey));
}

TEST(ShaftCsv, NoCellIsAFormula)
{
    for (const char* role : {"=cmd|'/C calc'!A0", "@SUM(A1)", "+1", "-1"}) {
        Shaft shaft = tableOne();
        shaft.segments[0].role = role;
        const std::string text = shaftCsv(shaft);
        EXPECT_NE(text.find(std::string(",\"'").append(role).append("\"")), std::string::npos) << text;
        EXPECT_EQ(read(text).segments[0].role, role);
    }
    Shaft shaft = tableOne();
    shaft.segments[0].role = "a\u202Eb";
    EXPECT_NE(shaftCsv(shaft).find("a<U+202E>b"), std::string::npos);
}

}  // namespace
}  // namespace lathelier::cad
