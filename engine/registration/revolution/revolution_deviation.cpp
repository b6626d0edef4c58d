#include "engine/registration/revolution/revolution_deviation.h"

#include <algorithm>
#include <cmath>

#include "engine/core/parallel.h"
#include "engine/core/units.h"
#include "engine/registration/excluded_zones.h"
#include "engine/registration/point_tasks.h"
#include "engine/registration/revolution/quick_turn.h"

namespace lathelier::registration {
namespace {

/// Size of the unrolled map (README, "Thresholds").
struct MapThresholds {
    std::size_t many_points = 100000;  ///< scans with more have the finer map
    int columns = 48;                  ///< of the map, around the axis
    int fine_columns = 120;
    double rows_per_column = 2;  ///< cells are so many times as long around the axis as along it
    int least_rows = 10;
    int most_rows = 400;
};
constexpr MapThresholds mapThresholds{};

constexpr std::size_t pointsPerZoneTask = 65536;
constexpr std::size_t pointsPerMapTask = 32768;  // at least, and an eighth of all points: the sums of a task are large
constexpr std::size_t mostMapTasks = 8;

struct Moments {
    double n = 0;
    double sum = 0;
    double squares = 0;

    void add(double v)
    {
        n += 1;
        sum += v;
        squares += v * v;
    }
    void add(const Moments& other)
    {
        n += other.n;
        sum += other.sum;
        squares += other.squares;
    }
    double mean() const { return n > 0 ? sum / n : notANumber; }
    double deviation() const
    {
        return n > 1 ? std::sqrt(std::max(0.0, (squares - sum * sum / n) / (n - 1))) : notANumber;
    }
};

/// The sums of the deviations by bin of the profile and by cell of the map.
struct MapSums {
    std::vector<Moments> bins, cells;

    void add(const MapSums& other)
    {
        for (std::size_t i = 0; i < bins.size(); ++i) bins[i].add(other.bins[i]);
        for (std::size_t i = 0; i < cells.size(); ++i) cells[i].add(other.cells[i]);
    }
};

/// An empty map of a part of this length and largest radius.
UnrolledMap mapFor(std::size_t points, double length_mm, double radius_mm)
{
    UnrolledMap map;
    map.angle_count = points > mapThresholds.many_points ? mapThresholds.fine_columns : mapThresholds.columns;
    const double cell_mm = turn_rad * radius_mm / map.angle_count;
    map.z_count = std::clamp(static_cast<int>(length_mm / cell_mm * mapThresholds.rows_per_column),
                             mapThresholds.least_rows, mapThresholds.most_rows);
    map.z_step_mm = length_mm / map.z_count;
    return map;
}

/// Zones, meridian and map are those of the outside.
bool isOnBore(const RevolutionFit& fit, std::size_t bin, double r)
{
    if (fit.bore.size() <= bin) return false;
    const double bore = fit.bore.radius_mm[bin];
    return !std::isnan(bore) && !(r > (bore + fit.profile.radius_mm[bin]) / 2);
}

/// Sums of the deviations of the used points on the outside.
MapSums mapSumsOf(const TurnedPart& reference, const MeridianLine& line, const std::vector<Eigen::Vector3d>& points,
                  const CompareResult& result, const UnrolledMap& map, const Progress& progress)
{
    const RadiusProfile& profile = reference.fit.profile;
    const MapSums empty{std::vector<Moments>(profile.size()),
                        std::vector<Moments>(static_cast<std::size_t>(map.z_count * map.angle_count))};
    return parallelReduce(
        points.size(), std::max(pointsPerMapTask, points.size() / mostMapTasks), progress, empty,
        [&](std::size_t begin, std::size_t end) {
            MapSums part = empty;
            for (std::size_t i = begin; i < end; ++i) {
                if (!result.used[i]) continue;
                const Eigen::Vector3d p = reference.fit.axis_T_scan * points[i];
                const double v = result.deviation_mm[i];
                const double place = (p.z() - profile.z_start_mm) / profile.step_mm;
                if (place >= 0 && place < static_cast<double>(profile.size())) {
                    if (isOnBore(reference.fit, static_cast<std::size_t>(place), p.head<2>().norm())) continue;
                    part.bins[static_cast<std::size_t>(place)].add(v);
                }
                const int row = static_cast<int>((p.z() - line.zFirst_mm()) / map.z_step_mm);
                if (p.z() < line.zFirst_mm() || row >= map.z_count) continue;
                const double turn = quickTurn(p.y(), p.x());
                const int column =
                    std::min(map.angle_count - 1, static_cast<int>((turn < 0 ? turn + 1 : turn) * map.angle_count));
                part.cells[static_cast<std::size_t>(row) * static_cast<std::size_t>(map.angle_count) +
                           static_cast<std::size_t>(column)]
                    .add(v);
            }
            return part;
        },
        [](MapSums all, const MapSums& part) {
            all.add(part);
            return all;
        });
}

}  // namespace

std::vector<float> meridianDeviation(const TurnedPart& reference, const MeridianLine& line,
                                     const std::vector<Eigen::Vector3d>& points, double max_distance_mm,
                                     const Progress& progress)
{
    std::vector<float> deviations(points.size());
    parallelFor(points.size(), taskPoints, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Eigen::Vector3d p = reference.fit.axis_T_scan * points[i];
            const double r = std::sqrt(p.x() * p.x() + p.y() * p.y());
            deviations[i] = static_cast<float>(line.deviation_mm(p.z(), r, max_distance_mm));
        }
    });
    return deviations;
}

std::int64_t excludeZones(const TurnedPart& reference, const MeridianLine& line,
                          const std::vector<Eigen::Vector3d>& points, CompareResult& result, const Progress& progress)
{
    if (result.parameters.exclude_z_mm.empty()) return 0;
    const ExcludedZones zones(result.parameters.exclude_z_mm, line.zLast_mm() - line.zFirst_mm());
    return parallelReduce(
        points.size(), pointsPerZoneTask, progress, std::int64_t{0},
        [&](std::size_t begin, std::size_t end) {
            std::int64_t count = 0;
            for (std::size_t i = begin; i < end; ++i) {
                const double z = (reference.fit.axis_T_scan * points[i]).z() - line.zFirst_mm();
                if (!zones.contains(z) || !result.used[i]) continue;
                result.used[i] = 0;
                result.deviation_mm[i] = std::numeric_limits<float>::quiet_NaN();
                ++count;
            }
            return count;
        },
        [](std::int64_t all, std::int64_t part) { return all + part; });
}

void describeRevolution(const TurnedPart& reference, const MeridianLine& line,
                        const std::vector<Eigen::Vector3d>& points, CompareResult& result, const Progress& progress)
{
    const RadiusProfile& profile = reference.fit.profile;
    UnrolledMap map = mapFor(points.size(), line.zLast_mm() - line.zFirst_mm(), profile.largestRadius_mm());
    const MapSums sums = mapSumsOf(reference, line, points, result, map, progress);
    result.axis_T_reference = Eigen::Translation3d(0, 0, -line.zFirst_mm()) * reference.fit.axis_T_scan;
    Meridian meridian;
    for (std::size_t i = 0; i < profile.size(); ++i) {
        meridian.z_mm.push_back(profile.middle_mm(i) - line.zFirst_mm());
        meridian.reference_radius_mm.push_back(profile.radius_mm[i]);
        meridian.deviation_mm.push_back(sums.bins[i].mean());
        meridian.std_mm.push_back(sums.bins[i].deviation());
    }
    result.meridian = std::move(meridian);
    for (const Moments& s : sums.cells) map.mean_mm.push_back(static_cast<float>(s.mean()));
    result.unrolled = std::move(map);
}

}  // namespace lathelier::registration
