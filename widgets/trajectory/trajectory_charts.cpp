#include "widgets/trajectory/trajectory_charts.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/report/colours.h"
#include "widgets/core/language.h"

namespace lathelier {

/// The words of these plots.
struct TrajectoryCharts {
    Q_DECLARE_TR_FUNCTIONS(lathelier::TrajectoryCharts)
};

namespace {

const QColor axisBlue(0, 114, 178);
const QColor toolOrange(213, 94, 0);

constexpr std::size_t mostMarks = 60;  // more revolution marks hide the signals

const std::vector<double>& mean(const trajectory::TrajectorySection& section, trajectory::Probe probe)
{
    return section.probes[static_cast<std::size_t>(probe)].mean_um;
}

XyCurve path(const trajectory::TrajectorySection& section, trajectory::Probe x, trajectory::Probe y,
             const QColor& colour)
{
    XyCurve curve;
    curve.x = mean(section, x);
    curve.y = mean(section, y);
    curve.along = partAngles_deg(section);
    curve.colour = colour;
    return curve;
}

constexpr int dotsBetween = 24;  ///< two samples: so close together that they look like a line

/// Samples of the axis (path 0) or the tool (path 1).
std::size_t samplesOf(const trajectory::TrajectorySection& section, std::size_t path)
{
    return path == 0
               ? std::min(mean(section, trajectory::Probe::X3).size(), mean(section, trajectory::Probe::Y3).size())
               : std::min(mean(section, trajectory::Probe::Xp).size(), mean(section, trajectory::Probe::Yp).size());
}

/// Dots along a closed path.
void addDots(Scan& scan, const std::vector<double>& x_um, const std::vector<double>& y_um, double z_mm, double scale)
{
    const std::size_t count = std::min(x_um.size(), y_um.size());
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t next = (i + 1) % count;
        for (int k = 0; k < dotsBetween; ++k) {
            const double t = static_cast<double>(k) / dotsBetween;
            const double x = x_um[i] + t * (x_um[next] - x_um[i]);
            const double y = y_um[i] + t * (y_um[next] - y_um[i]);
            scan.points_mm.emplace_back(scale * x / 1000, scale * y / 1000, z_mm);
        }
    }
}

double placeOf(const trajectory::TrajectorySection& section, std::size_t index)
{
    return std::isfinite(section.z_mm) ? section.z_mm : static_cast<double>(index) * 5;
}

}  // namespace

std::vector<double> partAngles_deg(const trajectory::TrajectorySection& section)
{
    std::vector<double> angles = section.body_angle_deg.empty() ? section.angle_deg : section.body_angle_deg;
    for (double& angle : angles) {
        angle = std::fmod(angle, 360);
        if (angle < 0) angle += 360;
    }
    return angles;
}

XyData axesData(const trajectory::TrajectoryResult& result, std::size_t section, bool all)
{
    XyData data;
    data.title = TrajectoryCharts::tr("Trajectories");
    data.x = {QStringLiteral("X"), QStringLiteral("µm")};
    data.y = {QStringLiteral("Y"), QStringLiteral("µm")};
    data.along = {TrajectoryCharts::tr("angle"), QStringLiteral("°")};
    if (all)
        for (std::size_t i = 0; i < result.sections.size(); ++i) {
            if (i == section) continue;
            for (const auto& [x, y, colour] : {std::tuple{trajectory::Probe::X3, trajectory::Probe::Y3, axisBlue},
                                               std::tuple{trajectory::Probe::Xp, trajectory::Probe::Yp, toolOrange}}) {
                data.curves.push_back(path(result.sections[i], x, y, colour));
                data.curves.back().thin = true;
            }
        }
    const trajectory::TrajectorySection& chosen = result.sections[section];
    data.remark = TrajectoryCharts::tr("section %1").arg(chosen.section);
    data.curves.push_back(path(chosen, trajectory::Probe::X3, trajectory::Probe::Y3, axisBlue));
    data.curves.back().name = TrajectoryCharts::tr("workpiece axis");
    data.curves.push_back(path(chosen, trajectory::Probe::Xp, trajectory::Probe::Yp, toolOrange));
    data.curves.back().name = TrajectoryCharts::tr("tool");
    return data;
}

PlotData coordinateData(const trajectory::TrajectorySection& section)
{
    PlotData data;
    data.title = TrajectoryCharts::tr("Coordinates over the angle");
    data.remark = TrajectoryCharts::tr("section %1").arg(section.section);
    data.x = {TrajectoryCharts::tr("Angle as recorded"), QStringLiteral("°")};
    data.y = {TrajectoryCharts::tr("Displacement"), QStringLiteral("µm")};
    const QStringList names{"X3", "Y3", "Xp", "Yp"};
    for (std::size_t probe = 0; probe < 4; ++probe) {
        PlotCurve curve;
        curve.name = names[static_cast<int>(probe)];
        curve.x = section.angle_deg;
        curve.y = section.probes[probe].mean_um;
        data.curves.push_back(std::move(curve));
    }
    PlotCurve radius;
    radius.name = TrajectoryCharts::tr("R − mean");
    radius.x = section.angle_deg;
    double sum = 0;
    for (const double r : section.radius_mm) sum += r;
    const double average_mm = section.radius_mm.empty() ? 0 : sum / static_cast<double>(section.radius_mm.size());
    for (const double r : section.radius_mm) radius.y.push_back((r - average_mm) * 1000);
    data.curves.push_back(std::move(radius));
    return data;
}

PolarPicturePtr motionPicture(const trajectory::TrajectorySection& section, trajectory::Probe probe,
                              double workpiece_diameter_mm)
{
    const auto p = static_cast<std::size_t>(probe);
    const trajectory::ErrorMotion& motion = section.error_motion[p];
    const std::vector<double>& average = section.probes[p].mean_um;
    PolarPlot plot;
    plot.title = LT_TEXT("Engine", "Error motion of all revolutions");
    plot.base_radius_mm = workpiece_diameter_mm / 2;
    const std::vector<double> angle_deg = partAngles_deg(section);
    bool first = true;
    for (const std::vector<float>& revolution : section.revolutions_um[p]) {
        PolarPlot::Trace trace;
        if (first) trace.name = LT_TEXT("Engine", "single revolutions");
        first = false;
        trace.thin = true;
        trace.colour = 4;
        trace.angle_deg = angle_deg;
        for (std::size_t i = 0; i < revolution.size() && i < average.size(); ++i)
            trace.deviation_um.push_back(revolution[i] - average[i] + motion.synchronous_curve_um[i]);
        plot.traces.push_back(std::move(trace));
    }
    PolarPlot::Trace mean;
    mean.name = LT_TEXT("Engine", "synchronous");
    mean.colour = 1;
    mean.angle_deg = angle_deg;
    mean.deviation_um = motion.synchronous_curve_um;
    plot.traces.push_back(std::move(mean));
    return polarPicture(std::move(plot));
}

QString motionText(const trajectory::ErrorMotion& motion)
{
    QStringList parts{TrajectoryCharts::tr("synchronous %1").arg(screenNumber(motion.synchronous_um, 2))};
    if (std::isfinite(motion.asynchronous_um))
        parts << TrajectoryCharts::tr("asynchronous %1").arg(screenNumber(motion.asynchronous_um, 2));
    if (std::isfinite(motion.total_um)) parts << TrajectoryCharts::tr("total %1").arg(screenNumber(motion.total_um, 2));
    return parts.join(QStringLiteral(" · ")) + QStringLiteral("\u00A0µm");
}

PlotData signalData(const std::vector<trajectory::TimeSignal>& recorded)
{
    PlotData data;
    data.title = TrajectoryCharts::tr("Signals");
    data.x = {TrajectoryCharts::tr("Time"), QStringLiteral("s")};
    const auto displaces = [](const trajectory::TimeSignal& signal) {
        return !signal.signal.empty() && signal.signal != "marker" && signal.signal != "angle";
    };
    // Without a usable map everything is shown as it was recorded: the plot is to tell which channel is which.
    const bool mapped = std::any_of(recorded.begin(), recorded.end(), displaces);
    data.y = mapped ? PlotAxis{TrajectoryCharts::tr("Displacement"), QStringLiteral("µm")}
                    : PlotAxis{TrajectoryCharts::tr("Value"), {}};
    const std::vector<double>* starts = nullptr;
    for (const trajectory::TimeSignal& signal : recorded) {
        if (!starts && !signal.revolution_starts_s.empty()) starts = &signal.revolution_starts_s;
        if (mapped && !displaces(signal)) continue;
        PlotCurve curve;
        curve.name = QString::fromStdString(mapped ? signal.signal : signal.channel);
        curve.x = signal.time_s;
        curve.y = signal.value;
        data.curves.push_back(std::move(curve));
    }
    if (!starts) return data;
    data.remark = TrajectoryCharts::tr("%1 revolution marks").arg(starts->size());
    for (std::size_t i = 0; i < std::min(starts->size(), mostMarks); ++i)
        data.limits.push_back({Qt::Vertical, (*starts)[i], i == 0 ? TrajectoryCharts::tr("marks") : QString(), false});
    // Single turns are seen, the rest comes with the wheel.
    if (starts->size() > 6) data.xRange = std::pair{(*starts)[0], (*starts)[5]};
    return data;
}

double stackMagnification(const trajectory::TrajectoryResult& result)
{
    double reach_um = 1e-3, low_mm = std::numeric_limits<double>::infinity(), high_mm = -low_mm;
    for (std::size_t i = 0; i < result.sections.size(); ++i) {
        const double z = placeOf(result.sections[i], i);
        low_mm = std::min(low_mm, z);
        high_mm = std::max(high_mm, z);
        for (const trajectory::ProbeStatistics& probe : result.sections[i].probes)
            for (const double value : probe.mean_um) reach_um = std::max(reach_um, std::abs(value));
    }
    const double length_mm = std::max(10.0, high_mm - low_mm);
    return std::pow(10, std::floor(std::log10(0.3 * length_mm / (reach_um / 1000))));
}

std::vector<SceneObject> stackedTrajectories(const trajectory::TrajectoryResult& result, double magnification)
{
    auto axis = std::make_shared<Scan>(), tool = std::make_shared<Scan>();
    for (std::size_t i = 0; i < result.sections.size(); ++i) {
        const trajectory::TrajectorySection& section = result.sections[i];
        const double z = placeOf(section, i);
        addDots(*axis, mean(section, trajectory::Probe::X3), mean(section, trajectory::Probe::Y3), z, magnification);
        addDots(*tool, mean(section, trajectory::Probe::Xp), mean(section, trajectory::Probe::Yp), z, magnification);
    }
    SceneObject first, second;
    first.name = TrajectoryCharts::tr("workpiece axis");
    first.scan = axis;
    first.colour = axisBlue;
    second.name = TrajectoryCharts::tr("tool");
    second.scan = tool;
    second.colour = toolOrange;
    return {first, second};
}

StackedPlace stackedPlace(const trajectory::TrajectoryResult& result, std::size_t object, std::int64_t dot)
{
    std::size_t rest = static_cast<std::size_t>(std::max<std::int64_t>(dot, 0)) / dotsBetween;
    for (std::size_t i = 0; i < result.sections.size(); ++i) {
        const std::size_t samples = samplesOf(result.sections[i], object);
        if (rest < samples) return {i, partAngles_deg(result.sections[i])[rest]};
        rest -= samples;
    }
    return {};
}

std::size_t sampleAt(const trajectory::TrajectorySection& section, double angle_deg)
{
    const std::vector<double> angles = partAngles_deg(section);
    const auto distance = [&](double angle) { return std::abs(std::remainder(angle - angle_deg, 360)); };
    const auto nearest =
        std::min_element(angles.begin(), angles.end(), [&](double a, double b) { return distance(a) < distance(b); });
    return static_cast<std::size_t>(nearest - angles.begin());
}

Eigen::Vector3d placeInStack(const trajectory::TrajectoryResult& result, const StackedPlace& place,
                             double magnification)
{
    const trajectory::TrajectorySection& section = result.sections[place.section];
    const std::size_t sample = sampleAt(section, place.angle_deg);
    if (sample >= samplesOf(section, 0)) return Eigen::Vector3d::Zero();
    const double scale = magnification / 1000;
    return {scale * mean(section, trajectory::Probe::X3)[sample], scale * mean(section, trajectory::Probe::Y3)[sample],
            placeOf(section, place.section)};
}

}  // namespace lathelier
