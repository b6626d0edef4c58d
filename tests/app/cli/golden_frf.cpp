#include "tests/app/cli/golden_frf.h"

#include <cmath>
#include <numbers>

#include "engine/io/file.h"
#include "engine/io/frf/frf_writer.h"
#include "engine/receptance/modal/modal_model.h"
#include "engine/receptance/shaft_receptance.h"
#include "tests/engine/io/frf_files.h"

namespace lathelier::golden {
namespace {

using testing::rawBytes;

/// A real vector f and a complex vector H of two numbers each, stored as MATLAB 5 does.
std::string matFile()
{
    const auto element = [](std::uint32_t type, std::string data) {
        const auto size = static_cast<std::uint32_t>(data.size());
        data.resize((data.size() + 7) / 8 * 8, '\0');
        return rawBytes(type) + rawBytes(size) + data;
    };
    const auto variable = [&element](const std::string& name, bool isComplex) {
        const std::string numbers = element(9, rawBytes(1.0) + rawBytes(2.0));
        return element(14, element(6, rawBytes(isComplex ? 0x806U : 6U) + rawBytes(0U)) +
                               element(5, rawBytes(2) + rawBytes(1)) + element(1, name) + numbers +
                               (isComplex ? numbers : std::string()));
    };
    std::string bytes = "MATLAB 5.0 MAT-file";
    bytes.resize(124, ' ');
    return bytes + rawBytes<std::uint16_t>(0x0100) + "IM" + variable("f", false) + variable("H", true);
}

/// Two rods on springs, two points each, as tap tests would find them without noise.
std::string tapTests()
{
    receptance::SpindleReceptance spindle;
    spindle.source = receptance::SpindleSprings{};
    std::vector<io::MeasuredFrf> responses;
    int node = 100;
    for (const double length_mm : {150.0, 250.0}) {
        Shaft rod;
        rod.segments = {{length_mm, 40, 40, 0, {}, {}}};
        rod.material = Material{};
        const double places_mm[] = {0, length_mm / 2};
        for (int a = 0; a < 2; ++a)
            for (int b = a; b < 2; ++b) {
                receptance::ReceptanceParameters asked;
                asked.respond_z_mm = places_mm[a];
                asked.excite_z_mm = places_mm[b];
                asked.from_hz = 100;
                asked.to_hz = 400;
                asked.step_hz = 10;
                responses.push_back({shaftReceptance(rod, asked, spindle).frf, node + a, 1, node + b, 1});
            }
        node += 100;
    }
    return io::toUff(responses);
}

/// An accelerance under the headings of a receptance.
std::string wrongLabel()
{
    std::vector<double> lines;
    for (double f = 5; f <= 500; f += 1) lines.push_back(f);
    Frf frf = receptance::synthesised({{{223, 0.03, 1e4}}, {}, {}}, lines);
    for (std::size_t i = 0; i < lines.size(); ++i) frf.value[i] *= -std::pow(2 * std::numbers::pi * lines[i], 2);
    return io::toFrfCsv(frf);
}

/// Two modes at three places of one bar, tapped at the first.
std::string threePlaces()
{
    constexpr double shapes[2][3] = {{1, 0.6, -0.3}, {1, -0.5, -0.8}};
    std::vector<double> lines;
    for (double f = 50; f <= 1000; f += 1) lines.push_back(f);
    std::vector<io::MeasuredFrf> responses;
    for (int place = 0; place < 3; ++place)
        responses.push_back(
            {receptance::synthesised(
                 {{{240, 0.02, 1e4 / shapes[0][place]}, {610, 0.015, 4e4 / shapes[1][place]}}, {}, {}}, lines),
             place + 1, 1, 1, 1});
    return io::toUff(responses);
}

}  // namespace

void makeFrfs(const std::string& folder)
{
    const auto write = [&folder](const std::string& name, const std::string& content) {
        io::writeFile(folder + "/" + name, content);
    };
    const io::MeasuredFrf mode = testing::modeFrf(FrfQuantity::Accelerance, 11);
    write("mode.uff", io::toUff(std::vector{mode}));
    write("mode.csv", io::toFrfCsv(mode.frf));
    write("wrong_label.csv", wrongLabel());
    write("no_unit.csv", "frequency_hz,real,imag\n50,1e-4,-2e-5\n52,2e-4,-3e-5\n");
    write("vectors.mat", matFile());
    write("cut.mat", matFile().substr(0, 300));
    testing::UffText set;
    set.points = 42;
    const std::string values = "  1.000000000000E+00 -2.000000000000E+00\n";
    write("few.uff", testing::uffSet(set, values + values));
    set.points = 2;
    set.data_type = 5;
    set.ordinate = 0;
    set.label = "Receptance";
    set.unit = "(m/s)/N";
    const std::string payload = "\n    -1\n    58\n";
    write("labelled.unv", testing::uffBinarySet(set, payload + std::string(16 - payload.size(), '\0')));
    write("long.unv", testing::uffBinarySet(set, std::string(16, '\0'), false, 100000));
    write(
        "rod.json",
        R"({"schema": "lathelier-shaft", "segments": [{"length_mm": 250, "start_diameter_mm": 40, "end_diameter_mm": 40}],)"
        R"( "material": {"elastic_modulus_MPa": 210000, "poisson_ratio": 0.3, "density_kg_m3": 7850,)"
        R"( "loss_factor": 0.002}})");
    write("plain.json", R"({"segments": [{"length_mm": 250, "start_diameter_mm": 40, "end_diameter_mm": 40}]})");
    write("springs.json", R"({"springs": {"radial_N_mm": 15000, "tilt_N_mm_rad": 197400000, "loss_factor": 0.06}})");
    write("stock.txt", "20 0 20 0 250\n");
    write("long_stock.txt", "20 0 20 0 250\n20 0 20 0 1000000\n");
    write("speck.json", R"({"segments": [{"length_mm": 1e-9, "start_diameter_mm": 34, "end_diameter_mm": 34}]})");
    write("taps.uff", tapTests());
    write("places.uff", threePlaces());
    write("taps.json",
          R"({"frf": "taps.uff", "rods": [)"
          R"({"length_mm": 150, "diameter_mm": 40, "points": [{"node": 100, "distance_from_chuck_mm": 150},)"
          R"( {"node": 101, "distance_from_chuck_mm": 75}]},)"
          R"({"length_mm": 250, "diameter_mm": 40, "points": [{"node": 200, "distance_from_chuck_mm": 250},)"
          R"( {"node": 201, "distance_from_chuck_mm": 125}]}]})");
    write("named.uff", "nothing of a universal file\n");
}

}  // namespace lathelier::golden
