#include <fmt/format.h>

#include <cmath>

#include "engine/core/texts.h"
#include "engine/sample/sample_record.h"

namespace lathelier::sample {
namespace {

/// "# first line" with the header as key=value pairs.
std::string remarks(const std::string& first, const Values& header)
{
    std::string line = "# " + first;
    for (const auto& [key, value] : header) line += "; " + key + "=" + text(value);
    return line + "\n";
}

}  // namespace

std::string toCsv(const io::ProbeRecord& record)
{
    Values header{{"unit_time", "s"}, {"unit_disp", "um"}};
    header.insert(header.end(), record.header.begin(), record.header.end());
    std::string out = remarks("Probe record", header);
    if (record.channel_skew_s)  // more digits than in sentences
        out += fmt::format("# channel_skew_s={:.9e}\n", *record.channel_skew_s);
    out += "t_s";
    for (const io::ProbeChannel& channel : record.channels)
        out += "," + channel.name + (channel.unit == io::ProbeChannel::Unit::Volt ? "_V" : "_um");
    out += "\n";
    for (std::size_t i = 0; i < record.frames(); ++i) {
        fmt::format_to(std::back_inserter(out), "{:.7f}", record.time_s[i]);
        for (const io::ProbeChannel& channel : record.channels)
            fmt::format_to(std::back_inserter(out), ",{:.3f}", channel.values[i]);
        out += '\n';
    }
    return out;
}

std::string toCsv(const io::AveragedRecord& record)
{
    Values header{{"unit_disp", "um"}, {"unit_len", "mm"}};
    header.insert(header.end(), record.header.begin(), record.header.end());
    std::string out = remarks("Averaged probe record", header);
    out += "section,z_mm,i,angle_deg,X3_um,Y3_um,Xp_um,Yp_um,sX3_um,sY3_um,sXp_um,sYp_um\n";
    for (const io::AveragedSection& s : record.sections)
        for (std::size_t i = 0; i < s.angle_deg.size(); ++i)
            fmt::format_to(std::back_inserter(out),
                           "{},{:.3f},{},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f}\n", s.section,
                           s.z_mm, i, s.angle_deg[i], s.X3_um[i], s.Y3_um[i], s.Xp_um[i], s.Yp_um[i], s.sX3_um[i],
                           s.sY3_um[i], s.sXp_um[i], s.sYp_um[i]);
    return out;
}

}  // namespace lathelier::sample
