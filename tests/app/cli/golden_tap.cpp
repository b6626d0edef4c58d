#include "tests/app/cli/golden_tap.h"

#include <fmt/format.h>

#include "tests/engine/io/frf_files.h"
#include "tests/engine/receptance/tapped_modes.h"

namespace lathelier::golden {
namespace {

using testing::rawBytes;

std::string timeSet(const std::vector<double>& values, double rate_hz, int ordinate, const std::string& unit)
{
    testing::UffText set;
    set.function = 1;
    set.data_type = 4;
    set.points = static_cast<int>(values.size());
    set.start = 0;
    set.step = 1 / rate_hz;
    set.response_node = 12;
    set.response_direction = 1;
    set.ordinate = ordinate;
    set.label = "NONE";
    set.unit = unit;
    set.denominator = 0;
    set.per = "NONE";
    set.frequency_unit = "s";
    std::string lines;
    for (std::size_t i = 0; i < values.size(); ++i)
        lines += fmt::format("{:20.12E}{}", values[i], i % 4 == 3 || i + 1 == values.size() ? "\n" : "");
    return testing::uffSet(set, lines);
}

/// Floating point, two channels, parts of 500 N and of 500 m/s².
std::string wavOf(const receptance::TapSignals& signals)
{
    std::string data;
    for (std::size_t i = 0; i < signals.force_N.size(); ++i)
        data += rawBytes(static_cast<float>(signals.force_N[i] / 500)) +
                rawBytes(static_cast<float>(signals.motion[i] / 500e3));
    const auto rate = static_cast<std::uint32_t>(signals.rate_hz);
    const std::string head = rawBytes(std::uint16_t{3}) + rawBytes(std::uint16_t{2}) + rawBytes(rate) +
                             rawBytes(8 * rate) + rawBytes(std::uint16_t{8}) + rawBytes(std::uint16_t{32});
    const std::string body = "WAVEfmt " + rawBytes(std::uint32_t{16}) + head + "data" +
                             rawBytes(static_cast<std::uint32_t>(data.size())) + data;
    return "RIFF" + rawBytes(static_cast<std::uint32_t>(body.size())) + body;
}

}  // namespace

void makeTapRecords(const std::function<void(const std::string& name, const std::string& content)>& write)
{
    testing::Tapping tapping;
    tapping.modes = {{300, 0.03, 10000}};
    tapping.rate_hz = 20000;
    tapping.pulses = {{0.05, 0.8e-3, 210}, {0.55, 0.8e-3, 180}, {1.05, 0.8e-3, 240}};
    tapping.duration_s = 1.6;
    const receptance::TapSignals signals = tapping.record();
    std::string stated = "t_s,force_N,acc_m_s2\n", gap = stated, plain = "hammer,acc\n", volts = "hammer_V,acc_V\n";
    for (std::size_t i = 0; i < signals.force_N.size(); ++i) {
        const double force = signals.force_N[i], motion = signals.motion[i];
        const std::string row =
            fmt::format("{:.5f},{:.6f},{:.6f}\n", static_cast<double>(i) / signals.rate_hz, force, motion / 1000);
        stated += row;
        if (i != 5000) gap += row;
        if (i < 12000) plain += fmt::format("{:.6f},{:.6f}\n", force, motion);
        volts += fmt::format("{:.8f},{:.8f}\n", force / 400, motion / 9806.65 / 10);  // 2.5 mV/N, 100 mV/g
    }
    write("tapped.csv", stated);
    write("tapped_gap.csv", gap);
    write("tapped_plain.csv", plain);
    write("tapped_volts.csv", volts);
    write("tapped.wav", wavOf(signals));
    std::vector<double> metres(signals.motion);
    for (double& value : metres) value /= 1000;
    write("tapped.uff",
          timeSet(signals.force_N, signals.rate_hz, 13, "N") + timeSet(metres, signals.rate_hz, 12, "m/s^2"));
}

}  // namespace lathelier::golden
