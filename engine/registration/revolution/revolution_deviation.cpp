#include "engine/registration/revolution/revolution_deviation.h"

#include <algorithm>
#include <cmath>

#include "engine/core/parallel.h"
#include "engine/core/units.h"
#include "engine/registration/excluded_zones.h"
#include "engine/registration/revolution/quick_turn.h"

namespace lathelier::registration {
namespace {

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

/// Zones, meridian and map are those of the outside.
bool isOnBore(const RevolutionFit& fit, std::size_t bin, double r)
{
    if (fit.bore.size() <= bin) return false;
    const double bore = fit.bore.radius_mm[bin];
    return !std::isnan(bore) && !(r > (bore + fit.profile.radius_mm[bin]) / 2);
}

}  // namespace

std::vector<float> meridianDeviation(const TurnedPart& reference, const MeridianLine& line,
                                     const std::vector<Eigen::Vector3d>& points, double max_distance_mm,
                                     const Progress& progress)
{
    std::vector<float> deviations(points.size());
    parallelFor(points.size(), 16384, progress, [&](std::size_t begin, std::size_t end) {
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
        points.size(), 65536, progress, std::int64_t{0},
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
    double radius = 0;
    for (const double r : profile.radius_mm) radius = std::isnan(r) ? radius : std::max(radius, r);
    const double length = line.zLast_mm() - line.zFirst_mm();

    UnrolledMap map;
    map.angle_count = points.size() > 100000 ? 120 : 48;
    const double cell = turn_rad * radius / map.angle_count;
    map.z_count = std::clamp(static_cast<int>(length / cell * 2), 10, 400);
    map.z_step_mm = length / map.z_count;

    struct Part {
        std::vector<Moments> bins, cells;
    };
    const auto sized = [&] {
        return Part{std::vector<Moments>(profile.size()),
                    std::vector<Moments>(static_cast<std::size_t>(map.z_count * map.angle_count))};
    };
    const Part sums = parallelReduce(
        points.size(), std::max<std::size_t>(32768, points.size() / 8), progress, sized(),
        [&](std::size_t begin, std::size_t end) {
            Part part = sized();
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
        [](Part all, const Part& part) {
            const auto add = [](std::vector<Moments>& to, const std::vector<Moments>& from) {
                for (std::size_t i = 0; i < to.size(); ++i) to[i].add(from[i]);
            };
            add(all.bins, part.bins);
            add(all.cells, part.cells);
            return all;
        });

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
