// Macros for FreeCAD and SolidWorks: as many constraints as unknowns, aliases that are not cell names, metres.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "engine/cad/freecad_macro.h"
#include "engine/cad/solidworks_macro.h"
#include "parts.h"
#include "tests/occurrences.h"

namespace lathelier::cad {
namespace {

TEST(FreecadMacro, EveryUnknownHasOneConstraint)
{
    for (const Shaft& shaft : allParts()) {
        const std::string macro = freecadMacro(shaft);
        const std::size_t unknowns =
            4 * occurrences(macro, "Part.LineSegment(") + 5 * occurrences(macro, "Part.ArcOfCircle(");
        std::size_t equations = 2 * occurrences(macro, "K('Coincident'");
        for (const char* kind : {"Horizontal", "Vertical", "DistanceX", "DistanceY", "Radius", "PointOnObject"})
            equations += occurrences(macro, fmt::format("K('{}'", kind));
        EXPECT_EQ(unknowns, equations) << shaft.name;
    }
}

TEST(FreecadMacro, AliasesAreUniqueAndNoCells)
{
    const std::regex alias("setAlias\\('B\\d+', '([^']+)'\\)"), cell("[A-Z]{1,2}[0-9]+");
    for (const Shaft& shaft : allParts()) {
        const std::string macro = freecadMacro(shaft);
        std::set<std::string> seen;
        for (std::sregex_iterator at(macro.begin(), macro.end(), alias), end; at != end; ++at) {
            EXPECT_TRUE(seen.insert(at->str(1)).second) << at->str(1);
            EXPECT_FALSE(std::regex_match(at->str(1), cell));
            EXPECT_NE(macro.find("'Table." + at->str(1)), std::string::npos);
        }
        EXPECT_GE(seen.size(), 3U);
    }
    EXPECT_NE(freecadMacro(tableOne()).find("'Dia_1'); T.set('B1', '30 mm')"), std::string::npos);
    EXPECT_NE(freecadMacro(flange()).find("'Dia_b1_2'"), std::string::npos);
}

TEST(FreecadMacro, ANameIsNoCode)
{
    Shaft shaft = tableOne();
    shaft.name = "x'); import os #\n⌀";
    const std::string macro = freecadMacro(shaft);
    EXPECT_NE(macro.find("doc.Label = 'x\\U00000027); import os #\\U0000000a\\U00002300'\n"), std::string::npos);
}

TEST(SolidworksMacro, MetresAndOneRevolution)
{
    const std::string macro = solidworksMacro(taper());
    EXPECT_NE(macro.find("Not tested in SolidWorks"), std::string::npos);
    EXPECT_EQ(occurrences(macro, "CreateArc("), 5U);
    EXPECT_EQ(occurrences(macro, "FeatureRevolve2("), 1U);
    EXPECT_NE(macro.find("CreateLine(0.001000000000, 0.008000000000, 0#, 0.020000000000, 0.008000000000, 0#)"),
              std::string::npos);
}

}  // namespace
}  // namespace lathelier::cad
