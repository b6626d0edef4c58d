// Nominal sizes that are put in place without a person: within U, or within the limits that go with them.
#include "engine/features/nominal/agreeing_sizes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/features/features_codes.h"
#include "engine/features/nominal/roles.h"
#include "engine/features/nominal/snap.h"
#include "engine/shaft/shaft_rules.h"
#include "made_recognition.h"

namespace lathelier::features {
namespace {

using testing::Contains;
using testing::Not;

/// A seat of 25.009 mm with a circlip groove between planes, a chamfer of 0.697 mm; U as in the finding.
Recognition motor()
{
    Recognition part = recognitionOf(cone(23.606, 25.0, 0.697) + cylinder(25.009, 44.401) + cylinder(23.85, 1.299) +
                                     cylinder(25.009, 10.003) + cylinder(35.0005, 40));
    part.segments[0].end_diameter_mm = 25.009;
    for (RecognizedRow& row : part.segments) {
        row.uncertainty.start_diameter_um = row.uncertainty.end_diameter_um = 1;
        row.uncertainty.z_start_um = row.uncertainty.z_end_um = 6;
        row.uncertainty.length_um = 8;
        row.uncertainty.angle_deg = 0.5;
    }
    part.segments[0].uncertainty.length_um = 36;
    part.parameters.snap = Snap::Apply;
    describeRows(part);
    return part;
}

TEST(AgreeingSizes, AGrooveKeepsThePlayOfItsRing)
{
    const Recognition part = motor();
    const AgreeingShaft made = agreeingNominal(part, {});
    const ShaftSegment& groove = made.shaft.segments.at(2);
    // 1.3 mm H13 of DIN 471 is 0.001 mm away; the wall at z 45.098 mm is not moved to 45 mm.
    EXPECT_NEAR(groove.length_mm, 1.3, 1e-9);
    EXPECT_NEAR(made.shaft.segments[0].length_mm + made.shaft.segments[1].length_mm, 45.098, 1e-9);
    EXPECT_NEAR(groove.start_diameter_mm, 23.9, 1e-9);
    EXPECT_EQ(groove.tolerance->iso_class, "h12");
    EXPECT_NEAR(made.shaft.segments[0].length_mm, 0.697, 1e-9);  // the chamfer
    EXPECT_THAT(made.left_out, Contains(AcceptedSize{1, "leg_mm"}));
    EXPECT_THAT(made.left_out, Contains(AcceptedSize{2, "z_mm"}));
    EXPECT_NO_THROW(checkShaft(made.shaft));
}

TEST(AgreeingSizes, TheFitGoesWithTheDiameter)
{
    const AgreeingShaft made = agreeingNominal(motor(), {});
    const ShaftSegment& seat = made.shaft.segments.at(1);
    EXPECT_NEAR(seat.start_diameter_mm, 25, 1e-12);
    EXPECT_EQ(seat.tolerance, (SizeTolerance{"k5", 2.0, 11.0}));  // ISO 286-1, 18 to 30 mm
    EXPECT_EQ(seat.measured->start_diameter_mm, 25.009);
    EXPECT_THAT(made.left_out, Not(Contains(AcceptedSize{2, "diameter_mm"})));
    for (const ShaftSegment& row : made.shaft.segments)
        if (row.role.empty()) {
            EXPECT_TRUE(row.tolerance) << row.start_diameter_mm;
        }
}

TEST(AgreeingSizes, APersonConfirmsTheOthersOneByOne)
{
    const Recognition part = motor();
    const AgreeingShaft made = agreeingNominal(part, {{1, "leg_mm"}});
    EXPECT_NEAR(made.shaft.segments.at(0).length_mm, 0.8, 1e-9);
    EXPECT_THAT(made.left_out, Not(Contains(AcceptedSize{1, "leg_mm"})));
    EXPECT_EQ(withAccepted(part, {{1, "leg_mm"}}), made.shaft);
    const Notes notes = notesOfSizes(part, {{1, "leg_mm"}});
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_EQ(notes[0].code, notes::nominalNotApplied);
    EXPECT_EQ(std::get<std::int64_t>(*find(notes[0].values, "count")), static_cast<std::int64_t>(made.left_out.size()));
}

TEST(AgreeingSizes, NoLengthMovesBeyondItsU)
{
    // A taper 1:10 between two seats: both nominal diameters would lengthen it by 0.09 mm.
    Recognition part = recognitionOf(cylinder(24.991, 30) + cone(24.991, 29.0, 40.09) + cylinder(29.0, 30));
    for (RecognizedRow& row : part.segments) {
        row.uncertainty.start_diameter_um = row.uncertainty.end_diameter_um = 1;
        row.uncertainty.z_start_um = row.uncertainty.z_end_um = 10;
        row.uncertainty.angle_deg = 0.002;
    }
    part.parameters.snap = Snap::Apply;
    describeRows(part);
    const Shaft shaft = agreeingNominal(part, {}).shaft;
    for (std::size_t i = 0; i < shaft.segments.size(); ++i) {
        const RecognizedRow& row = part.segments[i];
        EXPECT_LE(std::abs(shaft.segments[i].length_mm - (row.z_end_mm - row.z_start_mm)), 0.020 + 1e-9) << i;
    }
    EXPECT_NO_THROW(checkShaft(shaft));
}

}  // namespace
}  // namespace lathelier::features
