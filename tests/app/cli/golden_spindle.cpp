#include "tests/app/cli/golden_spindle.h"

#include "engine/sample/sample_record.h"

namespace lathelier::golden {
namespace {

sample::SpindleModel shortSpindle()
{
    sample::SpindleModel model = sample::quietSpindle();
    model.sections = 5;
    model.revolutions = 8;
    model.marker_noise_V = 0.01;
    return model;
}

/// Only the first `turns` revolutions, without what the record says of its sections.
io::ProbeRecord beginning(double turns)
{
    io::ProbeRecord record = sample::makeProbeRecord(shortSpindle());
    const auto frames = static_cast<std::size_t>((turns + 0.4) * 100);  // 100 frames a revolution
    record.time_s.resize(frames);
    for (io::ProbeChannel& channel : record.channels) channel.values.resize(frames);
    std::erase_if(record.header, [](const auto& entry) { return entry.first == "sections"; });
    return record;
}

}  // namespace

void makeSpindleRecords(const std::function<void(const std::string& name, const std::string& content)>& write)
{
    const std::string whole = sample::toCsv(sample::makeProbeRecord(shortSpindle()));
    write("spindle.csv", whole);
    write("cut_record.csv", whole.substr(0, whole.find(',', whole.size() / 2) + 1));  // within a row
    write("averages.csv", sample::toCsv(sample::makeAveragedRecord(shortSpindle())));
    write("section.csv", sample::toCsv(beginning(8)));
    write("one_revolution.csv", sample::toCsv(beginning(1)));
    io::ProbeRecord changed = beginning(8);
    for (double& volts : changed.channels[0].values) volts = 0.05;
    write("no_marker.csv", sample::toCsv(changed));
    changed = beginning(8);
    std::erase_if(changed.header, [](const auto& entry) { return entry.first == "D_mm"; });
    write("no_diameter.csv", sample::toCsv(changed));
}

}  // namespace lathelier::golden
