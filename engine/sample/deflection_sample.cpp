#include "engine/sample/deflection_sample.h"

#include <nlohmann/json.hpp>

#include "engine/deflection/case_a.h"
#include "engine/deflection/setup_file.h"

namespace lathelier::sample {
namespace {

constexpr const char* caseAProgram =
    "%\n"
    "O0101 (SYNTHETIC: SLENDER SHAFT D34 TO D28)\n"
    "N10 G21 G18 G40 G99\n"
    "N20 G28 U0. W0.\n"
    "N30 T0101 (CORNER RADIUS 0.8, LEAD ANGLE -5)\n"
    "N40 G50 S2500\n"
    "N50 G96 S200 M04\n"
    "N60 G00 X38. Z2. M08\n"
    "N70 X28.\n"
    "N80 G01 Z-280. F0.2\n"
    "N90 X36.\n"
    "N100 G00 Z2. M09\n"
    "N110 G28 U0. W0. M05\n"
    "N120 M30\n"
    "%\n";

constexpr const char* steppedProgram =
    "%\n"
    "O0201 (SYNTHETIC: STEPPED SHAFT, THREE PASSES)\n"
    "N10 G21 G18 G40 G99\n"
    "N20 T0101 (CORNER RADIUS 0.8, LEAD ANGLE -5)\n"
    "N30 G50 S2000\n"
    "N40 G96 S180 M04\n"
    "N50 G00 X44. Z2. M08\n"
    "N60 X36. (FIRST PASS)\n"
    "N70 G01 Z-280. F0.25\n"
    "N80 U4. W1.\n"
    "N90 G00 Z2.\n"
    "N100 X32. (SECOND PASS, WITH A CONE)\n"
    "N110 G01 Z-180. F0.25\n"
    "N120 X34. Z-220.\n"
    "N130 X38.\n"
    "N140 G00 Z2.\n"
    "N150 X29. (FINISH)\n"
    "N160 G01 Z-120. F0.15\n"
    "N170 X33.\n"
    "N180 G00 X100. Z50. M09\n"
    "N190 M30\n"
    "%\n";

std::string steppedSetup()
{
    deflection::TurningSetup setup;
    setup.stock = "stepped_stock.txt";
    setup.material.elastic.elastic_modulus_MPa = 210000;
    setup.material.elastic.poisson_ratio = 0.3;
    setup.material.cutting = {1800, 70, 750, 80};
    setup.tool.corner_radius_mm = 0.8;
    setup.tool.entering_angle_deg = 95;
    setup.chuck = {45000, 0, 9e7, 0};
    setup.tailstock = deflection::HoldingSprings{9000, 0, 0, 0};
    return deflection::setupText(setup);
}

SampleContent makeDeflection(std::uint64_t, const Progress& progress)
{
    deflection::TurningSetup case_a = deflection::caseASetup();
    case_a.stock = "case_a_stock.txt";
    SampleContent content;
    content.texts = {caseAProgram,        deflection::setupText(case_a),
                     "17 0 17 0 287.5\n", steppedProgram,
                     steppedSetup(),      "20 0 20 0 320\n"};
    content.truth = std::make_shared<Json>(Json{
        {"deflection",
         {{"about", "Synthetic: programs, machines and stock were written for this sample."},
          {"case_a",
           {{"z_mm", {0, 50, 100, 200, 280}}, {"diameter_error_um", {61.304, 44.038, 36.550, 21.352, 10.457}}}}}}});
    progress.report(1);
    return content;
}

}  // namespace

const SamplePart& deflectionSample()
{
    static const SamplePart part{
        "deflection",
        {"case_a.nc", "case_a_setup.json", "case_a_stock.txt", "stepped.nc", "stepped_setup.json", "stepped_stock.txt"},
        makeDeflection};
    return part;
}

}  // namespace lathelier::sample
