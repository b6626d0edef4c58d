// STEP files of other programs: what is cut out of a turned part is a mark of its kind with the sizes that the file was
// made with; what is not turned is refused by name. The files were made with OpenCASCADE's solids (cylinders, boxes,
// prisms, and their differences), their volumes are closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>

#include "../core/code_of_error.h"
#include "engine/cad/cad_codes.h"
#include "engine/cad/step_reader.h"
#include "engine/core/texts.h"
#include "engine/registration/registration_codes.h"
#include "engine/shaft/shaft_contour.h"
#include "foreign_step.h"

namespace lathelier::cad {
namespace {

std::string bytesOf(const std::string& name)
{
    std::ifstream file(LATHELIER_SOURCE_DIR "/tests/data/step/" + name + ".step", std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

StepPart partOf(const std::string& name)
{
    Notes notes;
    const StepPart part = readStep(bytesOf(name), notes);
    // Every named cut explains the volume that the solid lacks.
    EXPECT_NEAR(part.named_mm3, part.cut_mm3, 5e-3 * part.cut_mm3 + 1e-6) << name;
    EXPECT_EQ(contains(notes, notes::notOfRevolution), !part.other_faces.empty()) << name;
    return part;
}

/// The reason of a refusal and the kinds of the faces that it names.
std::pair<std::string, std::vector<std::string>> refused(const std::string& bytes)
{
    try {
        Notes notes;
        readStep(bytes, notes);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), errors::notABodyOfRevolution);
        std::vector<std::string> kinds;
        for (const Row& row : std::get<Rows>(*find(error.values(), "faces")).rows)
            kinds.push_back(text(std::get<Text>(*find(row.cells, "kind"))));
        return {std::get<std::string>(*find(error.values(), "reason")), kinds};
    }
    return {};
}

/// Ø20 × 30, Ø30 × 10, Ø16 × 25: the shaft that most files are cut from.
const double shaft_mm3 = std::numbers::pi * (100 * 30 + 225 * 10 + 64 * 25);

void expectShaft(const StepPart& part)
{
    ASSERT_EQ(part.shaft.segments.size(), 3U);
    const double lengths[] = {30, 10, 25}, diameters[] = {20, 30, 16};
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(part.shaft.segments[i].length_mm, lengths[i], 1e-9);
        EXPECT_NEAR(part.shaft.segments[i].start_diameter_mm, diameters[i], 1e-9);
        EXPECT_NEAR(part.shaft.segments[i].end_diameter_mm, diameters[i], 1e-9);
    }
}

TEST(ForeignPart, KeywayWithRoundEndsBesideACrossHole)
{
    const StepPart part = partOf("key_and_hole");
    expectShaft(part);
    ASSERT_EQ(part.shaft.marks.size(), 2U);
    const ShaftMark& key = part.shaft.marks[0];
    EXPECT_EQ(key.kind, MarkKind::Keyway);
    EXPECT_NEAR(*key.width_mm, 6, 1e-9);
    EXPECT_NEAR(*key.floor_mm, 6.5, 1e-9);
    EXPECT_NEAR(*key.depth_mm, 3.5, 1e-9);
    EXPECT_NEAR(*key.z_start_mm, 4, 1e-9);
    EXPECT_NEAR(*key.z_end_mm, 26, 1e-9);
    EXPECT_NEAR(*key.angle_deg, 0, 1e-9);
    const ShaftMark& hole = part.shaft.marks[1];
    EXPECT_EQ(hole.kind, MarkKind::CrossHole);
    EXPECT_NEAR(*hole.diameter_mm, 4, 1e-9);
    EXPECT_EQ(hole.through, 1);
    EXPECT_NEAR((*hole.z_start_mm + *hole.z_end_mm) / 2, 35, 1e-9);
}

TEST(ForeignPart, BlindCrossHolesWithTheirDepth)
{
    const StepPart drilled = partOf("cross_drilled");
    expectShaft(drilled);
    ASSERT_EQ(drilled.shaft.marks.size(), 1U);
    EXPECT_EQ(drilled.shaft.marks[0].kind, MarkKind::CrossHole);
    EXPECT_NEAR(*drilled.shaft.marks[0].diameter_mm, 6, 1e-9);
    EXPECT_EQ(drilled.shaft.marks[0].through, 0);
    EXPECT_NEAR(*drilled.shaft.marks[0].depth_mm, 7, 1e-9);  // of the cylinder; its point lies deeper
    // Into the bore of a tube: Ø5 meets Ø8 at √(16 - 6.25) at the least.
    const StepPart tube = partOf("cross_tube_one");
    ASSERT_EQ(tube.shaft.marks.size(), 1U);
    EXPECT_EQ(tube.shaft.marks[0].through, 0);
    EXPECT_NEAR(*tube.shaft.marks[0].angle_deg, 90, 1e-9);
    EXPECT_NEAR(*tube.shaft.marks[0].depth_mm, 10 - std::sqrt(16 - 6.25), 1e-4);
    ASSERT_EQ(tube.shaft.bores.size(), 1U);
}

TEST(ForeignPart, BoltCircleInABoredFlange)
{
    const StepPart part = partOf("bolts6_bored");
    ASSERT_EQ(part.shaft.marks.size(), 1U);
    const ShaftMark& circle = part.shaft.marks[0];
    EXPECT_EQ(circle.kind, MarkKind::BoltCircle);
    EXPECT_EQ(circle.count, 6);
    EXPECT_EQ(circle.through, 1);
    EXPECT_NEAR(*circle.diameter_mm, 9, 1e-9);
    EXPECT_NEAR(*circle.pitch_circle_mm, 56, 1e-9);
    EXPECT_NEAR(*circle.angle_deg, 0.2 * 180 / std::numbers::pi, 1e-9);
    EXPECT_NEAR(volume_mm3(part.shaft), std::numbers::pi * (225 * 30 + 1600 * 12 - 64 * 42), 1e-6);
    EXPECT_NEAR(part.cut_mm3, 6 * std::numbers::pi * 4.5 * 4.5 * 12, 1e-6);
}

TEST(ForeignPart, SquareHexagonAndWoodruffKeyway)
{
    const StepPart square = partOf("square_end");
    expectShaft(square);
    ASSERT_EQ(square.shaft.marks.size(), 1U);
    EXPECT_EQ(square.shaft.marks[0].kind, MarkKind::Square);
    EXPECT_NEAR(*square.shaft.marks[0].across_flats_mm, 12, 1e-9);
    EXPECT_NEAR(*square.shaft.marks[0].z_start_mm, 50, 1e-9);
    // A sharp hexagon has no turned face: its row is the circle through its corners.
    const StepPart hexagon = partOf("hex_head");
    ASSERT_EQ(hexagon.shaft.segments.size(), 2U);
    EXPECT_NEAR(hexagon.shaft.segments[1].start_diameter_mm, 48 / std::sqrt(3.0), 1e-9);
    ASSERT_EQ(hexagon.shaft.marks.size(), 1U);
    EXPECT_EQ(hexagon.shaft.marks[0].kind, MarkKind::Hexagon);
    EXPECT_NEAR(*hexagon.shaft.marks[0].across_flats_mm, 24, 1e-9);
    EXPECT_NEAR(hexagon.volume_mm3, std::numbers::pi * 64 * 40 + 10 * 24 * 24 * std::sqrt(3.0) / 2, 1e-6);
    const StepPart woodruff = partOf("woodruff");
    ASSERT_EQ(woodruff.shaft.marks.size(), 1U);
    EXPECT_EQ(woodruff.shaft.marks[0].kind, MarkKind::Keyway);
    EXPECT_NEAR(*woodruff.shaft.marks[0].width_mm, 5, 1e-9);
    EXPECT_NEAR(*woodruff.shaft.marks[0].floor_mm, 2, 1e-9);
}

TEST(ForeignPart, SlotAcrossAnEnd)
{
    const StepPart part = partOf("slot_end");
    expectShaft(part);
    ASSERT_EQ(part.shaft.marks.size(), 1U);
    EXPECT_EQ(key(part.shaft.marks[0]), "slot");
    EXPECT_NEAR(*part.shaft.marks[0].width_mm, 3, 1e-9);
    EXPECT_NEAR(*part.shaft.marks[0].depth_mm, 5, 1e-9);
    EXPECT_NEAR(*part.shaft.marks[0].angle_deg, 0, 1e-9);
    const double half = std::asin(1.5 / 8);
    EXPECT_NEAR(part.cut_mm3, 5 * (2 * 64 * half + 2 * 1.5 * 8 * std::cos(half)), 1e-6);
}

TEST(ForeignPart, SphericalEnd)
{
    const StepPart part = partOf("ball_small");
    ASSERT_EQ(part.shaft.marks.size(), 1U);
    EXPECT_EQ(part.shaft.marks[0].kind, MarkKind::Sphere);
    EXPECT_NEAR(*part.shaft.marks[0].diameter_mm, 18, 1e-9);
    EXPECT_NEAR(part.volume_mm3 / volume_mm3(part.shaft), 1, 1e-9);
    EXPECT_TRUE(part.other_faces.empty());
}

TEST(ForeignPart, InchesAndSplines)
{
    const StepPart inch = partOf("plain_inch");
    expectShaft(inch);
    EXPECT_NEAR(inch.volume_mm3, shaft_mm3, 1e-9 * shaft_mm3);
    const StepPart spline = partOf("nurbs");
    expectShaft(spline);
    EXPECT_TRUE(spline.other_faces.empty());
    EXPECT_NEAR(volume_mm3(spline.shaft), shaft_mm3, 1e-9 * shaft_mm3);
    EXPECT_NEAR(spline.volume_mm3, shaft_mm3, 1e-9 * shaft_mm3);
}

TEST(ForeignPart, WhatIsNotTurnedIsRefusedByName)
{
    const auto eccentric = refused(bytesOf("ecc_mid"));
    EXPECT_EQ(eccentric.first, "eccentric");
    EXPECT_EQ(eccentric.second, std::vector<std::string>{"cylinder"});
    const auto plate = refused(bytesOf("plate_holes"));
    EXPECT_EQ(plate.first, "prismatic");
    EXPECT_EQ(plate.second, std::vector<std::string>(4, "plane"));
    ForeignStep bar;
    bar.extrude(polygon(6, 10), 0, 50);
    EXPECT_EQ(refused(bar.text()).first, "prismatic");
}

TEST(ForeignPart, SpoiledFilesEndWithAnErrorOrAnAnswer)
{
    std::uint32_t random = 46;
    for (const char* name : {"key_and_hole", "bolts6_bored", "hex_head", "nurbs"}) {
        const std::string whole = bytesOf(name);
        for (int run = 0; run < 40; ++run) {
            std::string spoiled = whole;
            for (int change = 0; change < 3; ++change) {
                random = random * 1664525 + 1013904223;
                const std::size_t at = 600 + random % (whole.size() - 700);
                spoiled[at] = "0123456789#$*(),.TF'"[(random >> 8) % 20];
            }
            try {
                Notes notes;
                readStep(spoiled, notes);
            } catch (const Error& error) {
                EXPECT_FALSE(text(error).empty());
            }
        }
    }
}

}  // namespace
}  // namespace lathelier::cad
