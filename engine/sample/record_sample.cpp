#include "engine/sample/record_sample.h"

#include <nlohmann/json.hpp>

#include "engine/core/json.h"
#include "engine/form/roundness/roundness_quantities.h"
#include "engine/sample/sample_record.h"

namespace lathelier::sample {
namespace {

constexpr char syntheticRecord[] = "synthetic: probe record made by Lathelier, not a measurement";

Json wavesOf(const std::vector<MotionWave>& waves)
{
    Json json = Json::array();
    for (const MotionWave& w : waves)
        json.push_back({{"upr", w.upr},
                        {"x_um", w.x_um},
                        {"x_phase_rad", w.x_phase_rad},
                        {"y_um", w.y_um},
                        {"y_phase_rad", w.y_phase_rad}});
    return json;
}

/// Expected results of the probe record.
Json truthOf(const SpindleModel& model)
{
    Json sections = Json::array();
    for (int i = 0; i < model.sections; ++i)
        sections.push_back({{"section", i + 1},
                            {"z_mm", sectionMiddle_mm(model, i)},
                            {"circles", nestedJson(describedValues(form::fitCircles(trueImage_mm(model, i))))}});
    return {{"about", syntheticRecord},
            {"workpiece_diameter_mm", model.workpiece_diameter_mm},
            {"taper_diameter_um", model.taper_diameter_um},
            {"barrel_um", model.barrel_um},
            {"axis", wavesOf(model.axis)},
            {"tool", wavesOf(model.tool)},
            {"axis_noise_um", model.axis_noise_um},
            {"tool_noise_um", model.tool_noise_um},
            {"whirl_um", model.whirl_um},
            {"sections", sections}};
}

SampleContent makeRecords(std::uint64_t seed, const Progress& progress)
{
    SpindleModel spindle = sampleSpindle();
    spindle.seed = seed;
    SampleContent content;
    content.texts.push_back(toCsv(makeProbeRecord(spindle)));
    progress.report(0.5);
    content.texts.push_back(toCsv(makeAveragedRecord(spindle)));
    content.truth = std::make_shared<Json>(Json{{"probe_record", truthOf(spindle)}});
    content.panels["roundness"] = {.inputs = {{"record", "probe_record.csv"}}, .parameters = {{"tolerance_um", 15.0}}};
    return content;
}

}  // namespace

const SamplePart& recordSample()
{
    static const SamplePart part{"record", {"probe_record.csv", "averaged.csv"}, makeRecords};
    return part;
}

}  // namespace lathelier::sample
