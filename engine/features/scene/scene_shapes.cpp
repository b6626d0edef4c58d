#include "engine/features/scene/scene_shapes.h"

#include "engine/core/module.h"
#include "engine/features/scene/scene_kernel.h"

namespace lathelier::features {
namespace {

const SceneKernel& kernel()
{
    static const auto& table = moduleTable<SceneKernel>("lathelier-pcl", "lathelier_scene_kernel");
    return table;
}

}  // namespace

std::optional<ScenePlane> largestPlane(const std::vector<Eigen::Vector3d>& points, double tolerance_mm)
{
    return kernel().largest_plane(points, tolerance_mm);
}

std::vector<std::vector<std::uint32_t>> groupsOf(const std::vector<Eigen::Vector3d>& points, double gap_mm,
                                                 std::size_t least)
{
    return kernel().groups_of(points, gap_mm, least);
}

}  // namespace lathelier::features
