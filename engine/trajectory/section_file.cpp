#include "engine/trajectory/section_file.h"

#include <array>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <numbers>

#include "engine/core/units.h"
#include "engine/io/file.h"
#include "engine/report/quantity_table.h"
#include "engine/trajectory/trajectory_quantities.h"

namespace lathelier::trajectory {
namespace {

void append(std::string& out, double value)
{
    if (!out.empty() && out.back() != '\n') out += ',';
    if (!std::isfinite(value)) return;
    std::array<char, 32> digits{};
    out.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr);
}

void append(std::string& out, std::initializer_list<double> values)
{
    for (const double value : values) append(out, value);
}

double valueOrNone(const std::vector<double>& values, std::size_t i)
{
    return i < values.size() ? values[i] : notANumber;
}

}  // namespace

void writeSectionTable(const std::string& path, const TrajectoryResult& result)
{
    io::writeFile(path,
                  report::csvOf<TrajectorySection>(result.sections, {"section",
                                                                     "z_mm",
                                                                     "revolutions_used",
                                                                     "diameter_mm",
                                                                     "centre_x_um",
                                                                     "centre_y_um",
                                                                     "RONt_LSCI_um",
                                                                     "RONt_MZCI_um",
                                                                     "RONt_MICI_um",
                                                                     "RONt_MCCI_um",
                                                                     {"two_point.range_um", "two_point_range_um"},
                                                                     "run_out_um",
                                                                     {"spindle.synchronous_um", "synchronous_um"},
                                                                     {"spindle.asynchronous_um", "asynchronous_um"},
                                                                     {"spindle.total_um", "total_um"},
                                                                     "tolerance_um",
                                                                     "verdict"}));
}

void writeImages(const std::string& path, const TrajectoryResult& result)
{
    std::string out = "section,z_mm,i,angle_deg,body_angle_deg,radius_mm,x_mm,y_mm";
    for (const std::string probe : {"X3", "Y3", "Xp", "Yp"})
        out.append(",")
            .append(probe)
            .append("_um,s")
            .append(probe)
            .append("_um,confidence_")
            .append(probe)
            .append("_um");
    out += '\n';
    for (const TrajectorySection& s : result.sections)
        for (std::size_t i = 0; i < s.angle_deg.size(); ++i) {
            const double angle = valueOrNone(s.body_angle_deg, i) * std::numbers::pi / 180;
            const double radius_mm = valueOrNone(s.radius_mm, i);
            append(out, {static_cast<double>(s.section), s.z_mm, static_cast<double>(i), s.angle_deg[i],
                         valueOrNone(s.body_angle_deg, i), radius_mm, radius_mm * std::cos(angle),
                         radius_mm * std::sin(angle)});
            for (const ProbeStatistics& probe : s.probes)
                append(out, {valueOrNone(probe.mean_um, i), valueOrNone(probe.std_um, i),
                             valueOrNone(probe.confidence_um, i)});
            out += '\n';
        }
    io::writeFile(path, out);
}

}  // namespace lathelier::trajectory
