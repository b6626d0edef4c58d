#include "tests/app/cli/golden_frf.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/random.h"
#include "engine/io/file.h"
#include "engine/io/frf/frf_writer.h"
#include "engine/receptance/modal/modal_model.h"
#include "engine/receptance/shaft/shaft_receptance.h"
#include "tests/engine/io/frf_files.h"

namespace lathelier::golden {
namespace {

using testing::rawBytes;

/// A variable as MATLAB 5 stores it.
std::string matVariable(const std::string& name, const std::vector<double>& re, const std::vector<double>& im = {})
{
    const auto element = [](std::uint32_t type, std::string data) {
        const auto size = static_cast<std::uint32_t>(data.size());
        data.resize((data.size() + 7) / 8 * 8, '\0');
        return rawBytes(type) + rawBytes(size) + data;
    };
    const auto numbers = [&element](const std::vector<double>& values) {
        std::string data;
        for (const double value : values) data += rawBytes(value);
        return element(9, data);
    };
    return element(14, element(6, rawBytes(im.empty() ? 6U : 0x806U) + rawBytes(0U)) +
                           element(5, rawBytes(static_cast<std::int32_t>(re.size())) + rawBytes(1)) + element(1, name) +
                           numbers(re) + (im.empty() ? std::string() : numbers(im)));
}

std::string matFile(const std::string& variables)
{
    std::string bytes = "MATLAB 5.0 MAT-file";
    bytes.resize(124, ' ');
    return bytes + rawBytes<std::uint16_t>(0x0100) + "IM" + variables;
}

/// The one mode of frf_files.h as others write it. Its least depth is 2 k ζ (1 + ζ) over the coefficient: 408 N/mm.
void writeForeign(const std::string& folder)
{
    const auto write = [&folder](const std::string& name, const std::string& content) {
        io::writeFile(folder + "/" + name, content);
    };
    const io::MeasuredFrf mode = testing::modeFrf(FrfQuantity::Receptance, 401, 0, 1);
    std::string cutpro, complex = "frequency_hz;H (mm/N)\n", level = "f_hz,magnitude_dB_re_1_m_N,phase_deg\n", bare;
    std::vector<double> angular, re, im;
    for (std::size_t i = 0; i < mode.frf.value.size(); ++i) {
        const double f = mode.frf.frequency_hz[i];
        const std::complex<double> value = mode.frf.value[i];
        cutpro += fmt::format("  {:.6e}\t{:.12e}\t{:.12e}\t{}\n", f, value.real() / 1000, value.imag() / 1000,
                              i == 0 ? "Freq\tHz\tReal\tm/N\tImag\tReal\t" : "");
        complex += fmt::format("{};{:.12e}{:+.12e}j\n", f, value.real(), value.imag());
        level += fmt::format("{},{:.12f},{:.12f}\n", f, 20 * std::log10(std::abs(value) / 1000),
                             std::arg(value) * 180 / std::numbers::pi);
        bare += fmt::format("{} {:.12e} {:.12e}\n", f, value.real(), value.imag());
        angular.push_back(2 * std::numbers::pi * f);
        re.push_back(value.real());
        im.push_back(value.imag());
    }
    write("cutpro.frf", cutpro);
    write("complex.csv", complex);
    write("level.csv", level);
    write("bare.txt", bare);
    write("angular.mat", matFile(matVariable("w", angular) + matVariable("FRF", re, im)));
}

/// Universal files of the same mode: a force in a unit that is not known, turned round, conjugated, of several points.
void writePoints(const std::string& folder)
{
    const auto write = [&folder](const std::string& name, const std::string& content) {
        io::writeFile(folder + "/" + name, content);
    };
    const io::MeasuredFrf mode = testing::modeFrf(FrfQuantity::Accelerance, 401, 1, 1);
    testing::UffText set;
    set.points = 401;
    set.start = set.step = 1;
    set.per = "stone";
    std::string values;
    for (const std::complex<double>& value : mode.frf.value)
        values += fmt::format("{:20.12E}{:20.12E}\n", value.real() / 1000, value.imag() / 1000);
    write("unknown_force.uff", testing::uffSet(set, values));
    io::MeasuredFrf turned = mode, conjugated = mode;
    for (auto& value : turned.frf.value) value = -value;
    for (auto& value : conjugated.frf.value) value = std::conj(value);
    write("turned.uff", io::toUff(std::vector{turned}));
    write("conjugated.uff", io::toUff(std::vector{conjugated}));
    std::vector<io::MeasuredFrf> points(3, mode);
    for (std::size_t k = 0; k < points.size(); ++k) {
        points[k].response_node = points[k].reference_node = static_cast<int>(k) + 1;
        for (auto& value : points[k].frf.value) value *= k == 0 ? 0.5 : k == 1 ? 1 : 4;
    }
    points[2].reference_node = 2;  // the largest of all is none of a driving point
    write("points.uff", io::toUff(points));
}

/// Two rods on springs, two points each, as tap tests would find them without noise, the hammer as it should be or
/// turned round at the first rod's second response.
std::string tapTests(bool is_turned)
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
    if (is_turned)
        for (std::complex<double>& value : responses[1].frf.value) value = -value;
    return io::toUff(responses);
}

/// MEASUREMENTS.json of tapTests().
std::string tapMeasurements(const std::string& file)
{
    return R"({"frf": ")" + file +
           R"(", "averages": 3, "rods": [)"
           R"({"length_mm": 150, "diameter_mm": 40, "points": [{"node": 100, "distance_from_chuck_mm": 150},)"
           R"( {"node": 101, "distance_from_chuck_mm": 75}]},)"
           R"({"length_mm": 250, "diameter_mm": 40, "points": [{"node": 200, "distance_from_chuck_mm": 250},)"
           R"( {"node": 201, "distance_from_chuck_mm": 125}]}]})";
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

/// An impact test from 2 Hz on: the accelerance of two modes with the sensor's noise, and its coherence.
std::string lowLines()
{
    std::vector<double> lines;
    for (double f = 2; f <= 800; f += 2) lines.push_back(f);
    Frf frf = receptance::synthesised({{{317, 0.022, 12000}, {900, 0.028, 30000}}, {}, {}}, lines);
    frf.quantity = FrfQuantity::Accelerance;
    double peak = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        frf.value[i] *= -std::pow(2 * std::numbers::pi * lines[i], 2);
        peak = std::max(peak, std::abs(frf.value[i]));
    }
    const double noise = peak / 300 / std::numbers::sqrt2;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const double power = std::norm(frf.value[i]);
        frf.coherence.push_back(power / (power + 2 * noise * noise));
        frf.value[i] += noise * std::complex<double>(randomNormal(4, 1, i), randomNormal(4, 2, i));
    }
    return io::toFrfCsv(frf);
}

/// A soft mode above the lines, of which only the compliance is seen.
std::string modeBeyondLines()
{
    std::vector<double> lines;
    for (double f = 60; f <= 900; f += 2) lines.push_back(f);
    return io::toFrfCsv(receptance::synthesised({{{280, 0.03, 1e4}, {2400, 0.03, 4e3}}, {}, {}}, lines));
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
    write("tap_low_lines.csv", lowLines());
    write("no_unit.csv", "frequency_hz,real,imag\n50,1e-4,-2e-5\n52,2e-4,-3e-5\n");
    const std::string vectors = matFile(matVariable("f", {1, 2}) + matVariable("H", {1, 2}, {1, 2}));
    write("vectors.mat", vectors);
    write("cut.mat", vectors.substr(0, 300));
    writeForeign(folder);
    writePoints(folder);
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
    write(
        "slender.json",
        R"({"schema": "lathelier-shaft", "segments": [{"length_mm": 200, "start_diameter_mm": 16, "end_diameter_mm": 16}],)"
        R"( "material": {"elastic_modulus_MPa": 210000, "poisson_ratio": 0.3, "density_kg_m3": 7850,)"
        R"( "loss_factor": 0.002}})");
    write("stiff.json", R"({"springs": {"radial_N_mm": 1e5, "tilt_N_mm_rad": 2e9, "loss_factor": 0.06}})");
    write("beyond.csv", modeBeyondLines());
    write("stock.txt", "20 0 20 0 250\n");
    write("long_stock.txt", "20 0 20 0 250\n20 0 20 0 1000000\n");
    write("speck.json", R"({"segments": [{"length_mm": 1e-9, "start_diameter_mm": 34, "end_diameter_mm": 34}]})");
    write("taps.uff", tapTests(false));
    write("taps.json", tapMeasurements("taps.uff"));
    write("taps_turned.uff", tapTests(true));
    write("taps_turned.json", tapMeasurements("taps_turned.uff"));
    write("active.json",
          R"({"frequency_hz": [50, 100, 5000], "H_mm_N": [[6e-5, -4e-6], [6e-5, 4e-6], [6e-5, 4e-6]],)"
          R"( "L_mm_Nmm": [[0, 0], [0, 0], [0, 0]], "P_rad_Nmm": [[5e-9, -3e-10], [5e-9, -3e-10], [5e-9, -3e-10]]})");
    write("places.uff", threePlaces());
    write("named.uff", "nothing of a universal file\n");
}

}  // namespace lathelier::golden
