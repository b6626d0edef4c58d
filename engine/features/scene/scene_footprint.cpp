#include "engine/features/scene/scene_footprint.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/features/scene/scene_limits.h"

namespace lathelier::features {
namespace {

std::size_t sectorOf(const Eigen::Vector3d& p, std::size_t sectors)
{
    const double turn = std::atan2(p.y(), p.x()) / (2 * std::numbers::pi) + 0.5;
    return std::min(sectors - 1, static_cast<std::size_t>(turn * static_cast<double>(sectors)));
}

}  // namespace

void SceneFootprint::add(const Eigen::Vector3d& on_axis)
{
    rings_[std::lround(on_axis.z())].set(sectorOf(on_axis, footprintSectors));
}

void SceneFootprint::close()
{
    std::map<long, Ring> wider;
    for (const auto& [z, ring] : rings_) {
        Ring filled = ring;
        for (std::size_t k = 0; k < footprintSectors; ++k) {
            if (!ring[k]) continue;
            for (std::size_t gap = 2; gap <= sceneLimits.filled_sectors; ++gap)
                if (ring[(k + gap) % footprintSectors])
                    for (std::size_t j = 1; j < gap; ++j) filled.set((k + j) % footprintSectors);
        }
        const Ring dilated =
            filled | filled << 1 | filled >> 1 | filled << (footprintSectors - 1) | filled >> (footprintSectors - 1);
        for (const long beside : {z - 1, z, z + 1}) wider[beside] |= dilated;
    }
    rings_ = std::move(wider);
}

bool SceneFootprint::contains(const Eigen::Vector3d& on_axis) const
{
    const auto ring = rings_.find(std::lround(on_axis.z()));
    return ring != rings_.end() && ring->second[sectorOf(on_axis, footprintSectors)];
}

}  // namespace lathelier::features
