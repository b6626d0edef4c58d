#include "engine/features/scene/scene_groups.h"

#include <algorithm>

#include "engine/features/scene/scene_limits.h"

namespace lathelier::features {
namespace {

using Eigen::Vector3d;

void orderBySize(std::vector<SceneGroup>& groups)
{
    std::stable_sort(groups.begin() + 1, groups.end(),
                     [](const SceneGroup& a, const SceneGroup& b) { return a.points > b.points; });
    std::erase_if(groups, [](const SceneGroup& one) { return one.points == 0; });
    for (std::size_t g = sceneLimits.most_named_groups; g < groups.size(); ++g) {
        SceneGroup& last = groups[sceneLimits.most_named_groups - 1];
        last.kind = "clutter";
        last.points += groups[g].points;
        last.min_mm = last.min_mm.cwiseMin(groups[g].min_mm);
        last.max_mm = last.max_mm.cwiseMax(groups[g].max_mm);
    }
    if (groups.size() > sceneLimits.most_named_groups) groups.resize(sceneLimits.most_named_groups);
}

}  // namespace

Scene sceneOf(const std::vector<Vector3d>& points, const std::vector<std::uint16_t>& labels,
              const std::vector<std::string>& kinds, const std::string& reason)
{
    Scene scene;
    std::vector<SceneGroup> found(kinds.size());
    for (std::size_t g = 0; g < found.size(); ++g) {
        found[g].kind = kinds[g];
        found[g].kept = g == 0;
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        SceneGroup& one = found[labels[i]];
        one.min_mm = one.points == 0 ? points[i] : Vector3d(one.min_mm.cwiseMin(points[i]));
        one.max_mm = one.points == 0 ? points[i] : Vector3d(one.max_mm.cwiseMax(points[i]));
        ++one.points;
    }
    found.front().reason = reason;
    orderBySize(found);
    if (found.size() < 2) return scene;
    scene.groups = std::move(found);
    scene.kept.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) scene.kept[i] = labels[i] == 0;
    return scene;
}

Scene joined(Scene scene, const Scene& of_kept)
{
    if (of_kept.groups.empty()) return scene;
    if (scene.groups.empty()) {
        scene.groups = of_kept.groups;
        scene.kept = of_kept.kept;
    } else {
        scene.groups.front() = of_kept.groups.front();
        scene.groups.insert(scene.groups.end(), of_kept.groups.begin() + 1, of_kept.groups.end());
        orderBySize(scene.groups);
        std::size_t next = 0;
        for (std::uint8_t& kept : scene.kept)
            if (kept) kept = of_kept.kept[next++];
    }
    if (!scene.support) scene.support = of_kept.support;
    scene.hidden.insert(scene.hidden.end(), of_kept.hidden.begin(), of_kept.hidden.end());
    return scene;
}

}  // namespace lathelier::features
