// A comparison made by hand, so that reports can be tested without a registration.
#pragma once

#include <cmath>
#include <numbers>

#include "engine/io/io_codes.h"
#include "engine/registration/compare.h"
#include "engine/registration/registration_codes.h"

namespace lathelier::registration {

/// A shaft of three steps; the copy has a taper, a collar 50 µm too thick and a barrel, as the shared practice data.
inline CompareResult madeResult()
{
    CompareResult result;
    result.parameters.tolerance_mm = 0.1;
    result.parameters.scanner_accuracy_mm = 0.05;
    result.method_used = CompareMethod::Revolution;
    result.alignment.converged = true;
    result.alignment.iterations = 7;
    result.alignment.reference_axis = Axis{};
    result.alignment.free_motions = {FreeMotion{}};
    result.alignment.uncertainty = {1.9, 0.25, 0.00021};
    result.statistics = {731000, 1000,   99.86,  0.0571, 0.0092, 0.0563, -0.412,
                         0.389,  0.1123, 0.0081, 0.0555, -0.101, 0.118};
    result.cloud_to_cloud_rmse_mm = 0.1412;
    result.sampling_floor_mm = 0.0781;
    result.within_tolerance_percent = 92.7;
    result.verdict = Verdict::Fail;
    result.distinguishable_from_scanner = true;
    result.notes = {{notes::rollNotDetermined, {}},
                    {notes::unitGuessed, {{"path", "copy.xyz"}, {"unit", "mm"}, {"extent", 183.2}}},
                    {notes::outliersExcluded, {{"count", std::int64_t{1000}}, {"distance_mm", 1.0}}}};
    const auto radius = [](double z) { return z < 98 ? 15 : z < 108 ? 18.5 : z > 178 ? 16.9 - (z - 178) : 16.9; };
    const auto error = [](double z) {
        return z < 98 ? 0.03 - 0.06 * z / 98 : z < 108 ? 0.05 : 0.04 * std::sin(std::numbers::pi * (z - 108) / 75);
    };
    Meridian meridian;
    for (double z = 0.25; z < 183; z += 0.5) {
        meridian.z_mm.push_back(z);
        meridian.reference_radius_mm.push_back(radius(z));
        meridian.deviation_mm.push_back(z > 130 && z < 133 ? NAN : error(z) + 0.002 * std::sin(37 * z));
        meridian.std_mm.push_back(0.05);
    }
    result.meridian = meridian;
    UnrolledMap map{0, 0.5, 366, 180, {}};
    for (int z = 0; z < map.z_count; ++z)
        for (int angle = 0; angle < map.angle_count; ++angle) {
            const double z_mm = (z + 0.5) * map.z_step_mm;
            const double waves = 0.02 * std::sin(0.3 * z_mm) * std::cos(angle * std::numbers::pi / 30);
            const bool hole = std::hypot(z - 250.0, angle - 90.0) < 20;
            map.mean_mm.push_back(hole ? NAN : static_cast<float>(2.5 * error(z_mm) + waves));
        }
    result.unrolled = map;
    for (int i = 0; i <= 60; ++i) result.histogram.edges_mm.push_back(-0.3 + 0.01 * i);
    for (int i = 0; i < 60; ++i)
        result.histogram.counts.push_back(std::llround(60000 * std::exp(-0.5 * std::pow((i - 30.5) / 5.6, 2))));
    for (double z = 0; z < 183; z += 5)
        result.zones.push_back({z, std::min(z + 5, 183.0), error(z + 2.5), 0.05, 20000});
    return result;
}

}  // namespace lathelier::registration
