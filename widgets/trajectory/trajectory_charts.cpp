#include "widgets/trajectory/trajectory_charts.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/trajectory/trajectory_plots.h"
#include "widgets/core/language.h"
#include "widgets/plot/plot_style.h"

namespace lathelier::trajectory_panel {

/// The words of these plots.
struct TrajectoryCharts {
    Q_DECLARE_TR_FUNCTIONS(lathelier::trajectory_panel::TrajectoryCharts)
};

namespace {

const QColor axisBlue = plot::toQt(report::colourOf(0)),
             toolOrange = plot::toQt(report::colourOf(1));  // as in the charts

const std::vector<double>& mean(const trajectory::TrajectorySection& section, trajectory::Probe probe)
{
    return section.probes[static_cast<std::size_t>(probe)].mean_um;
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

QString motionText(const trajectory::ErrorMotion& motion)
{
    const auto number = [](double value_um) { return screenNumber(value_um, micrometre, 2); };
    QStringList parts{TrajectoryCharts::tr("synchronous %1").arg(number(motion.synchronous_um))};
    if (std::isfinite(motion.asynchronous_um))
        parts << TrajectoryCharts::tr("asynchronous %1").arg(number(motion.asynchronous_um));
    if (std::isfinite(motion.total_um)) parts << TrajectoryCharts::tr("total %1").arg(number(motion.total_um));
    return parts.join(QStringLiteral(" · ")) + QStringLiteral("\u00A0") + screenUnit(micrometre);
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

std::vector<scene::SceneObject> stackedTrajectories(const trajectory::TrajectoryResult& result, double magnification)
{
    auto axis = std::make_shared<Scan>(), tool = std::make_shared<Scan>();
    for (std::size_t i = 0; i < result.sections.size(); ++i) {
        const trajectory::TrajectorySection& section = result.sections[i];
        const double z = placeOf(section, i);
        addDots(*axis, mean(section, trajectory::Probe::X3), mean(section, trajectory::Probe::Y3), z, magnification);
        addDots(*tool, mean(section, trajectory::Probe::Xp), mean(section, trajectory::Probe::Yp), z, magnification);
    }
    scene::SceneObject first, second;
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

}  // namespace lathelier::trajectory_panel
