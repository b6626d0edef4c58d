#include "engine/sample/chatter_sample.h"

#include <nlohmann/json.hpp>

#include "engine/core/random.h"
#include "engine/io/frf/frf_writer.h"
#include "engine/io/json/json_fields.h"
#include "engine/receptance/shaft/shaft_receptance.h"
#include "engine/receptance/spindle/spindle_file.h"

namespace lathelier::sample {
namespace {

constexpr char syntheticComputed[] = "synthetic: computed by Lathelier, not measured";
constexpr double tapNoise = 0.01;  ///< of the tap tests, relative
constexpr double tapStep_hz = 5;   ///< of the tap tests

/// Springs that reproduce the results of both papers (Jasiewicz and Miądlicki; Miądlicki et al.).
receptance::SpindleReceptance machine()
{
    receptance::SpindleReceptance spindle;
    spindle.source = receptance::SpindleSprings{14850, 198.3e6, 0.06};
    return spindle;
}

/// The half-finished shaft of Miądlicki et al., Table 1: from the free end, 17 mm of the bar before the chuck.
Shaft shaftOfThePaper()
{
    Shaft shaft;
    shaft.name = "half-finished shaft (" + std::string(syntheticComputed) + ")";
    shaft.segments = {
        {98, 30, 30, 0, {}, {}}, {10, 37, 37, 0, {}, {}}, {75, 33.8, 33.8, 0, {}, {}}, {17, 40, 40, 0, {}, {}}};
    shaft.material = Material{};
    return shaft;
}

Frf responseOf(const Shaft& shaft, double respond_z_mm, double excite_z_mm, double step)
{
    receptance::ReceptanceParameters asked;
    asked.respond_z_mm = respond_z_mm;
    asked.excite_z_mm = excite_z_mm;
    asked.to_hz = 1500;
    asked.step_hz = step;
    Frf frf = shaftReceptance(shaft, asked, machine()).frf;
    frf.name = syntheticComputed;
    return frf;
}

struct Rod {
    double length_mm, diameter_mm;
    double from_chuck_mm[3];
};
constexpr Rod rods[]{{150, 40, {50, 100, 150}}, {250, 40, {80, 160, 250}}, {200, 50, {60, 130, 200}}};

/// Tap tests on three rods, three points each, with noise of 1 %.
std::string tapTests(std::uint64_t seed, const Progress& progress)
{
    std::vector<io::MeasuredFrf> responses;
    int rod_number = 0;
    for (const Rod& rod : rods) {
        progress.report(rod_number / 3.0);
        Shaft shaft;
        shaft.segments = {{rod.length_mm, rod.diameter_mm, rod.diameter_mm, 0, {}, {}}};
        shaft.material = Material{};
        const int node = 100 * ++rod_number;
        for (int a = 0; a < 3; ++a)
            for (int b = a; b < 3; ++b) {
                Frf frf = responseOf(shaft, rod.length_mm - rod.from_chuck_mm[a], rod.length_mm - rod.from_chuck_mm[b],
                                     tapStep_hz);
                const std::uint64_t stream = 1000 * responses.size() + 1;
                for (std::size_t i = 0; i < frf.value.size(); ++i)
                    frf.value[i] *= std::complex<double>(1 + tapNoise * randomNormal(seed, stream, 2 * i),
                                                         tapNoise * randomNormal(seed, stream, 2 * i + 1));
                responses.push_back({std::move(frf), node + a + 1, 1, node + b + 1, 1});
            }
    }
    return io::toUff(responses);
}

Json measurements()
{
    Json json{{"frf", "tap_tests.uff"}, {"rods", Json::array()}};
    int node = 0;
    for (const Rod& rod : rods) {
        node += 100;
        Json points = Json::array();
        for (int i = 0; i < 3; ++i)
            points.push_back({{"node", node + i + 1}, {"distance_from_chuck_mm", rod.from_chuck_mm[i]}});
        json["rods"].push_back({{"length_mm", rod.length_mm},
                                {"diameter_mm", rod.diameter_mm},
                                {"material", io::objectOf(infos<Material>(), toValues(Material{}))},
                                {"points", std::move(points)}});
    }
    return json;
}

SampleContent makeChatter(std::uint64_t seed, const Progress& progress)
{
    const Shaft shaft = shaftOfThePaper();
    io::MeasuredFrf tip{responseOf(shaft, 0, 0, 1), 1, 1, 1, 1};
    SampleContent content;
    content.texts = {io::objectOf(infos<Shaft>(), toValues(shaft)).dump(2) + "\n", receptance::spindleText(machine()),
                     io::toUff({&tip, 1}), measurements().dump(2) + "\n", tapTests(seed, progress)};
    content.truth = std::make_shared<Json>(
        Json{{"chatter",
              {{"about", syntheticComputed},
               {"spindle", {{"radial_N_mm", 14850}, {"tilt_N_mm_rad", 198.3e6}, {"loss_factor", 0.06}}},
               {"tap_test_noise", tapNoise},
               {"recommended_rpm", 2154},
               {"recommended_for", "diameter 30 mm, 190 m/min, published relation"}}}});
    SamplePanel panel;
    panel.parameters = {{"cutting_coefficient_N_mm2", 600.0},
                        {"speed_rpm", std::vector<Interval>{{1200, 4800}}},
                        {"operating_speed_rpm", 2016.0},
                        {"operating_depth", 0.4},
                        {"diameter_mm", 30.0},
                        {"range_m_min", std::vector<Interval>{{120, 400}}},
                        {"uncertainty_frequency_percent", 0.5},
                        {"uncertainty_coefficient_percent", 5.0}};
    content.panels["lobes"] = std::move(panel);
    SamplePanel shaft_panel;
    shaft_panel.parameters = {{"to_hz", 3000.0}};
    content.panels["shaft"] = std::move(shaft_panel);
    SamplePanel spindle_panel;
    spindle_panel.inputs = {{"measurements", "tap_tests.json"}};
    spindle_panel.parameters = {{"smooth", true}, {"hold_out", std::int64_t{3}}, {"limit_percent", 5.0}};
    content.panels["spindle"] = std::move(spindle_panel);
    SamplePanel pass_panel;
    pass_panel.parameters = {{"pass_z_mm", std::vector<Interval>{{0, 98}}},
                             {"pass_depth_mm", 0.4},
                             {"diameter_mm", 30.0},
                             {"range_m_min", std::vector<Interval>{{120, 400}}},
                             {"cutting_coefficient_N_mm2", 600.0},
                             {"speed_rpm", std::vector<Interval>{{1200, 4800}}},
                             {"operating_speed_rpm", 2016.0}};
    content.panels["pass"] = std::move(pass_panel);
    SamplePanel training_panel;
    training_panel.parameters = {{"scenario", "slender"}, {"operating_speed_rpm", 2885.0}, {"operating_depth", 0.45}};
    content.panels["training"] = std::move(training_panel);
    SamplePanel speed_panel;
    speed_panel.parameters = {{"diameter_mm", 30.0},
                              {"cutting_speed_m_min", 190.0},
                              {"range_m_min", std::vector<Interval>{{120, 400}}},
                              {"depth_mm", 0.4},
                              {"cutting_coefficient_N_mm2", 600.0}};
    content.panels["speed"] = std::move(speed_panel);
    progress.report(1);
    return content;
}

}  // namespace

const SamplePart& chatterSample()
{
    static const SamplePart part{
        "chatter", {"shaft.json", "spindle.json", "tip_response.uff", "tap_tests.json", "tap_tests.uff"}, makeChatter};
    return part;
}

}  // namespace lathelier::sample
