// STEP of shafts: schema, names, faces, identical bytes; volumes are checked by the writer itself and once more by the
// reader (step_reader_test.cpp).
#include "engine/cad/step_writer.h"

#include <gtest/gtest.h>

#include <map>

#include "../core/code_of_error.h"
#include "engine/cad/cad_codes.h"
#include "engine/cad/cad_notes.h"
#include "engine/shaft/mark_codes.h"
#include "engine/shaft/shaft_codes.h"
#include "engine/shaft/turned_marks.h"
#include "fixed_time.h"
#include "parts.h"
#include "tests/occurrences.h"

namespace lathelier::cad {
namespace {

/// How many surfaces of each kind a file has; the kernel makes two faces of each revolved piece.
std::map<std::string, std::size_t> surfaces(const std::string& text)
{
    std::map<std::string, std::size_t> result;
    for (const char* kind : {"CYLINDRICAL_SURFACE", "CONICAL_SURFACE", "TOROIDAL_SURFACE", "SPHERICAL_SURFACE",
                             "SURFACE_OF_REVOLUTION", "ADVANCED_FACE", "PLANE"})
        if (const std::size_t found = occurrences(text, std::string("= ") + kind + "(")) result[kind] = found;
    return result;
}

TEST(StepWriter, OneSolidInTheSchemaAskedForAndTheSameBytesTwice)
{
    for (const Shaft& shaft : allParts()) {
        const std::string text = stepText(shaft, fixedTime());
        EXPECT_EQ(occurrences(text, "MANIFOLD_SOLID_BREP("), 1U) << shaft.name;
        EXPECT_NE(text.find("FILE_SCHEMA(('AUTOMOTIVE_DESIGN"), std::string::npos);
        EXPECT_EQ(text, stepText(shaft, fixedTime())) << shaft.name;
        // The product of the second writer of a process is not "shaft 2".
        EXPECT_EQ(occurrences(text, "PRODUCT('" + shaft.name + "','" + shaft.name + "'"), 1U) << shaft.name;
        EXPECT_EQ(text.find("@"), std::string::npos);
        StepOptions managed = fixedTime();
        managed.schema = StepSchema::AP242;
        EXPECT_NE(stepText(shaft, managed).find("'AP242_MANAGED_MODEL_BASED_3D_ENGINEERING"), std::string::npos);
    }
}

TEST(StepWriter, FacesAreOfTheKindOfTheirRows)
{
    using Counts = std::map<std::string, std::size_t>;
    EXPECT_EQ(surfaces(stepText(tableOne(), fixedTime())),
              (Counts{{"ADVANCED_FACE", 8}, {"PLANE", 4}, {"CYLINDRICAL_SURFACE", 3}, {"CONICAL_SURFACE", 1}}));
    const Counts curved = surfaces(stepText(taper(), fixedTime()));
    EXPECT_EQ(curved.at("TOROIDAL_SURFACE"), 5U);
    EXPECT_EQ(curved.count("SURFACE_OF_REVOLUTION"), 0U);
    EXPECT_EQ(surfaces(stepText(undercut(), fixedTime())).at("TOROIDAL_SURFACE"), 3U);
    EXPECT_EQ(surfaces(stepText(flange(), fixedTime())).at("TOROIDAL_SURFACE"), 1U);
    EXPECT_EQ(surfaces(stepText(ballEnd(), fixedTime())).at("SPHERICAL_SURFACE"), 2U);
    EXPECT_EQ(surfaces(stepText(lemon(), fixedTime())).at("SURFACE_OF_REVOLUTION"), 1U);
}

/// The volume of the drawing is exact where that of the kernel is: no sound part is refused for its digits.
TEST(StepWriter, ACrownOfManyMetresIsWritten)
{
    Shaft crowned;
    crowned.segments = {{70.00021429133636, 33.800039817124485, 33.800162388055384, 0, 15354.549983683628, ""},
                        {5, 23.8, 23.8, 0, {}, ""}};
    EXPECT_EQ(occurrences(stepText(crowned, fixedTime()), "MANIFOLD_SOLID_BREP("), 1U);
}

TEST(StepWriter, NamesAreWrittenAsPart21SaysIt)
{
    EXPECT_EQ(stepString("a'b\\c"), "a''b\\\\c");
    EXPECT_EQ(stepString("Wałek ⌀"), "Wa\\X2\\0142\\X0\\ek \\X2\\2300\\X0\\");
    EXPECT_EQ(stepString("\xF0\x9F\x94\xA9"), "\\X4\\0001F529\\X0\\");
    EXPECT_EQ(stepString("\xFF"), "?");
    // Quotes before a comma or bracket end a text for some readers, doubled or not.
    EXPECT_EQ(stepString("'); FILE_NAME('x"), "\\X2\\0027\\X0\\); FILE_NAME(''x");
    EXPECT_EQ(stepString("shaft'"), "shaft\\X2\\0027\\X0\\");
    Shaft shaft = tableOne();
    shaft.material = Material{};
    shaft.material->name = "11SMn30";
    StepOptions options = fixedTime();
    options.name = "O'Neil łożysko";
    options.author = "A. Turner";
    options.organisation = "Shop";
    const std::string text = stepText(shaft, options);
    EXPECT_NE(text.find("PRODUCT('O''Neil \\X2\\0142\\X0\\o\\X2\\017C\\X0\\ysko',"), std::string::npos);
    EXPECT_NE(text.find("'material: 11SMn30'"), std::string::npos);
    EXPECT_NE(text.find("('A. Turner')"), std::string::npos);
    EXPECT_NE(text.find("('Shop')"), std::string::npos);
    EXPECT_NE(text.find("'2000-01-01T00:00:00'"), std::string::npos);
}

TEST(StepWriter, AWrongShaftIsRefusedByItsRule)
{
    Shaft shaft = tableOne();
    shaft.segments[1].length_mm = -1;
    EXPECT_EQ(codeOfError([&] { stepText(shaft, fixedTime()); }), errors::shaftRowWrong);
    EXPECT_EQ(codeOfError([&] { stepText({}, fixedTime()); }), errors::shaftRowWrong);
}

TEST(StepWriter, PiecesThatTheKernelTakesForPointsAreLeftOut)
{
    Shaft shaft = tableOne();
    shaft.segments[0].end_diameter_mm = 30 + 1e-8;
    shaft.segments.insert(shaft.segments.begin() + 1, row(5, 30, 30));
    EXPECT_EQ(surfaces(stepText(shaft, fixedTime())).at("PLANE"), 4U);
}

TEST(StepWriter, StopsWhenAsked)
{
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(stepText(taper(), fixedTime(), Progress(stop.get_token(), {})), Cancelled);
}

TEST(CadNotes, MarksAndArcsBeyondTheAxis)
{
    EXPECT_TRUE(cadNotes(taper()).empty());
    EXPECT_TRUE(contains(cadNotes(lemon()), notes::arcBeyondAxis));
    Shaft shaft = tableOne();
    shaft.marks = {{MarkKind::Keyway}, {MarkKind::Flat}};
    shaft.marks[0].z_start_mm = 6;
    shaft.marks[0].z_end_mm = 34.04;
    const Notes found = cadNotes(shaft);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].code, notes::marksLeftOut);
    EXPECT_EQ(std::get<std::string>(*find(found[0].values, "kinds")), "keyway z 6.0-34.0, flat");
    EXPECT_NO_THROW(requireSolidOfRows(shaft));
    shaft.marks.push_back({MarkKind::Spline});
    EXPECT_THROW(requireSolidOfRows(shaft), Error);
    shaft.marks = {{MarkKind::Sphere}};  // made of its row
    EXPECT_TRUE(cadNotes(shaft).empty());
}

TEST(CadNotes, HolesAreRefusedByName)
{
    for (const MarkKind kind : {MarkKind::CrossHole, MarkKind::BoltCircle}) {
        Shaft shaft = tableOne();
        shaft.marks = {{MarkKind::Keyway}, {kind}};
        shaft.marks[1].z_start_mm = 6;
        try {
            stepText(shaft, fixedTime());
            FAIL() << key(kind);
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), errors::markNotTurned);
            EXPECT_EQ(std::get<double>(*find(error.values(), "z_start_mm")), 6);
        }
    }
}

}  // namespace
}  // namespace lathelier::cad
