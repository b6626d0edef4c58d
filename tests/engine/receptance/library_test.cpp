// The libraries inside the program, and how they are refused.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <set>

#include "../core/code_of_error.h"
#include "engine/cutting/cutting_forces.h"
#include "engine/cutting/tool_library.h"
#include "engine/io/io_codes.h"
#include "engine/receptance/library.h"
#include "engine/stock/tool_outline.h"

namespace lathelier::receptance {
namespace {

std::string resource(const char* name)
{
    std::ifstream file(std::string(LATHELIER_SOURCE_DIR) + "/resources/library/" + name);
    return {std::istreambuf_iterator<char>(file), {}};
}

TEST(Library, OfMaterialsIsWholeAndSaysWhereItIsFrom)
{
    const auto library = readMaterials(resource("materials.json"));
    std::set<std::string> keys;
    for (const auto& entry : library) {
        keys.insert(entry.key);
        EXPECT_EQ(entry.value.name, entry.key);
        EXPECT_FALSE(entry.source.empty()) << entry.key;
        EXPECT_GT(entry.value.loss_factor, 0) << entry.key;
        const double wave_speed = std::sqrt(1e6 * entry.value.elastic_modulus_MPa / entry.value.density_kg_m3);
        EXPECT_GT(wave_speed, 3000) << entry.key;  // m/s: E and ρ belong together
        EXPECT_LT(wave_speed, 5400) << entry.key;
    }
    EXPECT_EQ(keys, (std::set<std::string>{"steel", "stainless", "aluminium", "brass", "titanium", "cast_iron"}));
    Material steel;
    EXPECT_EQ(entryOf(library, "steel")->value, steel);  // that is assumed where none is stated
    EXPECT_EQ(entryOf(library, "butter"), nullptr);
}

TEST(Library, OfMachinesIsWhole)
{
    const auto library = readMachines(resource("machines.json"));
    ASSERT_EQ(library.size(), 3U);
    EXPECT_EQ(entryOf(library, "papers")->value, (SpindleSprings{14850, 198.3e6, 0.06}));
    EXPECT_GT(entryOf(library, "stiff")->value.radial_N_mm, entryOf(library, "soft")->value.radial_N_mm);
}

TEST(Library, OfInsertsIsWholeAndCanCut)
{
    const auto library = cutting::readToolLibrary(resource("inserts.json"), resource("holders.json")).inserts;
    ASSERT_EQ(library.size(), 16U);
    for (const auto& entry : library) {
        EXPECT_NE(entry.source.find("ISO 1832"), std::string::npos) << entry.key;
        ASSERT_TRUE(entry.value.tip_angle_deg) << entry.key;
        EXPECT_EQ(entry.value.tip_angle_deg, tipAngleOfCode_deg(entry.source.substr(10))) << entry.key;
        EXPECT_FALSE(stock::outlineOf(entry.value).insert.empty()) << entry.key;
        const cutting::CuttingForces forces = cutting::cuttingForces({2000, 0, 1000, 0}, entry.value, 0.2, 1);
        EXPECT_GT(forces.F_ap_N, 0) << entry.key;
    }
    const cutting::LibraryTool& insert = entryOf(library, "cnmg_120408")->value;
    EXPECT_EQ(insert.entering_angle_deg, 95);
    EXPECT_EQ(insert.corner_radius_mm, 0.8);
    EXPECT_EQ(insert.tip_angle_deg, 80);
    EXPECT_EQ(codeOfError([] {
                  cutting::readToolLibrary(R"({"inserts": [{"key": "a", "lead_angle_deg": 0}]})", R"({"holders": []})");
              }),
              errors::keyMissing);
}

TEST(Library, SaysWhatIsMissing)
{
    EXPECT_EQ(codeOfError([] { readMachines("{}"); }), errors::keyMissing);
    EXPECT_EQ(codeOfError([] { readMachines(R"({"machines": [{"key": "a"}]})"); }), errors::keyMissing);
    EXPECT_EQ(codeOfError([] { readMaterials(R"({"materials": [{"key": "a", "density_kg_m3": 1000}]})"); }),
              errors::keyMissing);
}

}  // namespace
}  // namespace lathelier::receptance
