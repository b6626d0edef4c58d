// STEP to shafts: round trip in any pose; parts that are not turned are refused; corrupt bytes give a located error.
#include "engine/cad/step_reader.h"

#include <gtest/gtest.h>

#include <numbers>

#include "../core/code_of_error.h"
#include "engine/cad/cad_codes.h"
#include "engine/cad/part21.h"
#include "engine/cad/step_writer.h"
#include "engine/core/texts.h"
#include "engine/io/io_codes.h"
#include "engine/registration/registration_codes.h"
#include "engine/shaft/shaft_contour.h"
#include "fixed_time.h"
#include "foreign_step.h"
#include "parts.h"

namespace lathelier::cad {
namespace {

template <class Row>
void expectSameRows(const std::vector<Row>& found, const std::vector<Row>& truth, double tolerance_mm,
                    const std::string& name)
{
    ASSERT_EQ(found.size(), truth.size()) << name;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        EXPECT_NEAR(found[i].length_mm, truth[i].length_mm, tolerance_mm) << name << " row " << i + 1;
        EXPECT_NEAR(found[i].start_diameter_mm, truth[i].start_diameter_mm, tolerance_mm) << name << " row " << i + 1;
        EXPECT_NEAR(found[i].end_diameter_mm, truth[i].end_diameter_mm, tolerance_mm) << name << " row " << i + 1;
        EXPECT_EQ(found[i].arc_radius_mm.has_value(), truth[i].arc_radius_mm.has_value()) << name << " row " << i + 1;
        if (found[i].arc_radius_mm && truth[i].arc_radius_mm) {
            EXPECT_NEAR(*found[i].arc_radius_mm, *truth[i].arc_radius_mm, tolerance_mm) << name << " row " << i + 1;
        }
    }
}

void expectSame(const Shaft& found, const Shaft& truth, double tolerance_mm)
{
    expectSameRows(found.segments, truth.segments, tolerance_mm, truth.name);
    ASSERT_EQ(found.bores.size(), truth.bores.size()) << truth.name;
    for (std::size_t i = 0; i < truth.bores.size(); ++i) {
        EXPECT_EQ(found.bores[i].from, truth.bores[i].from) << truth.name;
        expectSameRows(found.bores[i].segments, truth.bores[i].segments, tolerance_mm, truth.name + " bore");
    }
}

/// The error that reading ends with; `reason` of it where there is one.
std::pair<std::string, std::string> refusal(const std::string& bytes)
{
    try {
        Notes notes;
        readStep(bytes, notes);
    } catch (const Error& error) {
        EXPECT_FALSE(text(error).empty());
        const Value* reason = find(error.values(), "reason");
        return {error.code().key, reason ? std::get<std::string>(*reason) : ""};
    }
    return {"", ""};
}

using Refusal = std::pair<std::string, std::string>;

Eigen::Isometry3d somewhere()
{
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translate(Eigen::Vector3d(120, -45, 300));
    pose.rotate(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -0.5).normalized()));
    return pose;
}

TEST(StepReader, TheTableOfWhatWasWritten)
{
    for (const Shaft& shaft : allParts()) {
        Notes notes;
        const StepPart part = readStep(stepText(shaft, fixedTime()), notes);
        expectSame(part.shaft, shaft, 1e-9);
        EXPECT_EQ(part.shaft.name, shaft.name);
        EXPECT_NEAR(part.volume_mm3 / volume_mm3(shaft), 1, 1e-9) << shaft.name;
        EXPECT_TRUE(part.other_faces.empty()) << shaft.name;
        EXPECT_TRUE(notes.empty()) << shaft.name << ": " << (notes.empty() ? "" : text(notes.front()));
        EXPECT_TRUE(part.axis.isApprox(Eigen::Vector3d::UnitZ(), 1e-12));
        EXPECT_LT(part.free_end_mm.norm(), 1e-9);
        // And back: the table's own file has the same volume, which the writer checks.
        Notes again;
        EXPECT_NEAR(readStep(stepText(part.shaft, fixedTime()), again).volume_mm3 / part.volume_mm3, 1, 1e-9);
    }
}

TEST(StepReader, AnyPoseAndEndForEnd)
{
    for (const Shaft& shaft : allParts()) {
        Notes notes;
        const StepPart part = readStep(posed(stepText(shaft, fixedTime()), somewhere()), notes);
        expectSame(part.shaft, shaft, 1e-9);
        EXPECT_LT((part.free_end_mm - somewhere().translation()).norm(), 1e-9) << shaft.name;
        EXPECT_LT((part.axis - somewhere().linear().col(2)).norm(), 1e-9) << shaft.name;
    }
    Eigen::Isometry3d turned = Eigen::Isometry3d::Identity();
    turned.rotate(Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX()));
    Notes notes;
    const StepPart part = readStep(posed(stepText(tableOne(), fixedTime()), turned), notes);
    ASSERT_EQ(part.shaft.segments.size(), 4U);
    EXPECT_NEAR(part.shaft.segments[0].start_diameter_mm, 23.8, 1e-9);
    EXPECT_NEAR(part.free_end_mm.z(), -183, 1e-9);
}

TEST(StepReader, NamesComeBack)
{
    StepOptions options = fixedTime();
    options.name = "Wałek 'A' ⌀30";
    Notes notes;
    EXPECT_EQ(readStep(stepText(tableOne(), options), notes).shaft.name, options.name);
}

TEST(StepReader, LengthsAreThoseOfTheFilesUnit)
{
    std::string metres = stepText(tableOne(), fixedTime());
    const std::string unit = "SI_UNIT(.MILLI.,.METRE.)";
    metres.replace(metres.find(unit), unit.size(), "SI_UNIT($,.METRE.)");
    Notes notes;
    const StepPart part = readStep(metres, notes);
    ASSERT_EQ(part.shaft.segments.size(), 4U);
    EXPECT_NEAR(part.shaft.segments[1].start_diameter_mm, 37000, 1e-6);
}

TEST(StepReader, AFlatIsARemark)
{
    ForeignStep file(somewhere());
    file.extrude(flattened(10, 9), 0, 40);
    Notes notes;
    const StepPart part = readStep(file.text(), notes);
    ASSERT_EQ(part.shaft.segments.size(), 1U);
    EXPECT_NEAR(part.shaft.segments[0].start_diameter_mm, 20, 1e-9);
    EXPECT_NEAR(part.shaft.length_mm(), 40, 1e-9);
    EXPECT_TRUE(contains(notes, notes::notOfRevolution));
    ASSERT_EQ(part.other_faces.size(), 1U);
    EXPECT_EQ(text(part.other_faces[0].kind), "plane");
    EXPECT_NEAR(part.other_faces[0].area_mm2, 40 * 2 * std::sqrt(19.0), 1e-6);
    ASSERT_EQ(part.shaft.marks.size(), 1U);
    EXPECT_EQ(part.shaft.marks[0].kind, MarkKind::Flat);
    EXPECT_NEAR(*part.shaft.marks[0].distance_mm, 9, 1e-9);
    EXPECT_NEAR(*part.shaft.marks[0].z_end_mm, 40, 1e-9);
    const double angle = std::acos(0.9);
    EXPECT_NEAR(part.volume_mm3, 40 * (100 * std::numbers::pi - 100 * angle + 9 * std::sqrt(19.0)), 1e-6);
}

TEST(StepReader, WhatIsNoTurnedPartIsRefused)
{
    ForeignStep bar;
    bar.extrude(polygon(64, 10), 0, 50);
    EXPECT_EQ(refusal(bar.text()), (Refusal{"not_a_body_of_revolution", "faceted"}));
    ForeignStep block(somewhere());
    block.extrude(box(20, 30), 0, 40);
    EXPECT_EQ(refusal(block.text()), (Refusal{"not_a_body_of_revolution", "prismatic"}));
    ForeignStep half;
    half.extrude(flattened(10, 1), 0, 40);
    EXPECT_EQ(refusal(half.text()), (Refusal{"not_a_body_of_revolution", "not_round"}));
    // A corner beyond the largest circle.
    ForeignStep cam;
    cam.extrude({{10, 0, true}, {-10, 0, true}, {0, -10, false}, {8, -8, false}}, 0, 40);
    EXPECT_EQ(refusal(cam.text()), (Refusal{"not_a_body_of_revolution", "not_round"}));
    ForeignStep two;
    two.extrude(flattened(10, 9.9), 0, 40);
    two.extrude(flattened(10, 9.9), 0, 40, 50);
    EXPECT_EQ(refusal(two.text()).first, "several_parts");
    EXPECT_EQ(refusal(ForeignStep().text()).first, "no_solid");
    std::string surfaces = stepText(tableOne(), fixedTime());
    const std::size_t solid = surfaces.find("MANIFOLD_SOLID_BREP(");
    surfaces.replace(solid, 19, "SHELL_BASED_SURFACE_MODEL");
    EXPECT_EQ(refusal(surfaces).first, "no_solid");
}

TEST(StepReader, ARefusalNamesTheWorstFaces)
{
    ForeignStep block;
    block.extrude(box(20, 30), 0, 40);
    try {
        Notes notes;
        readStep(block.text(), notes);
        FAIL();
    } catch (const Error& error) {
        const Rows& faces = std::get<Rows>(*find(error.values(), "faces"));
        ASSERT_EQ(faces.rows.size(), 4U);
        EXPECT_NEAR(std::get<double>(*find(faces.rows[0].cells, "area_mm2")), 1200, 1e-6);
    }
}

TEST(StepReader, BrokenBytesEndWithALocatedError)
{
    EXPECT_EQ(refusal("").first, "file_empty");
    EXPECT_EQ(refusal("solid part\nfacet normal 0 0 1").first, "format_unknown");
    const std::string whole = stepText(undercut(), fixedTime());
    for (std::size_t size = 1; size < whole.size() - 1; size += 500) {
        const std::string code = refusal(whole.substr(0, size)).first;
        EXPECT_TRUE(code == "malformed" || code == "format_unknown") << size << " " << code;
    }
    // Bytes changed: an error or an answer, never a crash.
    std::uint32_t random = 7;
    for (int run = 0; run < 150; ++run) {
        std::string spoiled = whole;
        for (int change = 0; change < 3; ++change) {
            random = random * 1664525 + 1013904223;
            const std::size_t at = 600 + random % (whole.size() - 700);
            spoiled[at] = "0123456789#$*(),.TF'"[(random >> 8) % 20];
        }
        refusal(spoiled);
    }
}

// Each of these crashed the kernel.
TEST(StepReader, RecordsOfTheWrongKind)
{
    const std::string whole = stepText(blindBores(), fixedTime());
    const auto changed = [&](const char* pattern, const char* by) {
        return std::regex_replace(whole, std::regex(pattern), by, std::regex_constants::format_first_only);
    };
    Notes notes;  // curves in the parameters of a surface are not used
    expectSame(
        readStep(changed("DEFINITIONAL_REPRESENTATION\\('',\\(#\\d+", "DEFINITIONAL_REPRESENTATION('',(#12"), notes)
            .shaft,
        blindBores(), 1e-9);
    EXPECT_EQ(refusal(changed("TOROIDAL_SURFACE\\('',(#\\d+),[^,]*,", "TOROIDAL_SURFACE('',$1,1.E+99,")).first,
              "malformed");
    std::smatch flat;
    ASSERT_TRUE(std::regex_search(whole, flat, std::regex("#(\\d+) = CARTESIAN_POINT\\('',\\([^,()]+,[^,()]+\\)\\)")));
    EXPECT_EQ(refusal(changed("VERTEX_POINT\\('',#\\d+", ("VERTEX_POINT('',#" + flat[1].str()).c_str())).first,
              "malformed");
    EXPECT_EQ(refusal(changed("CYLINDRICAL_SURFACE\\('',(#\\d+),[^)]*", "CYLINDRICAL_SURFACE('',$1,0.")).first,
              "not_a_body_of_revolution");
    // Directions without numbers, behind the frames that use them.
    EXPECT_EQ(refusal(changed("DIRECTION\\(''(,\\([^)]*\\))", "DIRECTION(''")).first, "malformed");
    EXPECT_EQ(refusal(changed("DIRECTION\\('',\\([^)]*\\)", "DIRECTION('',$$")).first, "malformed");
    std::string cut_name = changed("DIRECTION\\(''", "DIRECTION('?'");
    cut_name[cut_name.find("DIRECTION('?'") + 11] = '\0';
    EXPECT_EQ(refusal(cut_name).first, "malformed");
}

TEST(StepReader, GrammarRings)
{
    const auto file = [](const std::string& records) {
        return "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n" + records + "ENDSEC;\nEND-ISO-10303-21;\n";
    };
    const auto place = [&](const std::string& records) {
        try {
            checkPart21(file(records));
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), errors::malformed);
            return fmt::format("{}:{}", std::get<std::int64_t>(*find(error.values(), "line")),
                               std::get<std::int64_t>(*find(error.values(), "column")));
        }
        return std::string();
    };
    EXPECT_EQ(place("#1 = A('x',(1,2.5,-1.E-3),$,*,.T.,#2);\n#2=(B()C(LENGTH_MEASURE(1.)));/* c */\n"), "");
    EXPECT_EQ(place("#1 = A(#2);\n#2 = B(#1);\n"), "5:8");
    EXPECT_EQ(place("#1 = A(#1);\n"), "5:8");
    EXPECT_EQ(place("#1 = A(#3);\n"), "5:8");
    EXPECT_EQ(place("#1 = A();\n#1 = A();\n"), "6:1");
    EXPECT_EQ(place("#1 = A(1e300);\n"), "5:8");
    EXPECT_EQ(place("#1 = CIRCLE('',1.E+12);\n"), "5:16");
    EXPECT_EQ(place("#1 = A(,);\n"), "5:8");
    EXPECT_EQ(place("#1 = B_SPLINE_CURVE(1000000000);\n"), "5:21");
    EXPECT_EQ(place("#1 = A('x);\n"), "5:8");
    std::string deep;
    for (int i = 1; i < 300; ++i) deep += fmt::format("#{} = A(#{});\n", i, i + 1);
    EXPECT_NE(place(deep + "#300 = A();\n"), "");
}

TEST(StepReader, StopsWhenAsked)
{
    std::stop_source stop;
    stop.request_stop();
    Notes notes;
    EXPECT_THROW(readStep(stepText(taper(), fixedTime()), notes, Progress(stop.get_token(), {})), Cancelled);
}

}  // namespace
}  // namespace lathelier::cad
