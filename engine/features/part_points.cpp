#include "engine/features/part_points.h"

#include "engine/features/features_codes.h"
#include "engine/features/recognition_limits.h"
#include "engine/features/walls/mesh_points.h"
#include "engine/registration/point_checks.h"
#include "engine/registration/registration_codes.h"

namespace lathelier::features {
namespace {

template <class T>
void keepOnly(const std::vector<std::uint8_t>& kept, std::vector<T>& items)
{
    std::size_t next = 0;
    for (std::size_t i = 0; i < items.size(); ++i)
        if (kept[i]) items[next++] = items[i];
    items.resize(next);
}

/// Adds the note sceneCut.
void noteSceneCut(const Scene& scene, Recognition& result)
{
    result.scene = scene.groups;
    const auto all = static_cast<std::int64_t>(scene.kept.size());
    const auto count = [&](const char* kind) {
        std::int64_t sum = 0;
        for (const SceneGroup& group : scene.groups) sum += group.kind == kind ? group.points : 0;
        return sum;
    };
    result.notes.push_back({notes::sceneCut,
                            {{"cut_points", all - scene.groups.front().points},
                             {"points", all},
                             {"turntable_points", count("turntable")},
                             {"clamp_points", count("clamp")},
                             {"clutter_points", count("clutter")}}});
}

}  // namespace

PartPoints pointsOf(const Scan& scan, const Progress& progress)
{
    PartPoints points{scan, {}, {}};
    if (scan.isMesh()) {
        points.samples = registration::drawSamples(scan, recognitionLimits.mesh_samples, 0, progress);
        points.own = flatPoints(scan, points.samples, progress);
    }
    registration::checkPoints(points.all(), "scan", progress);
    return points;
}

void leaveOut(const LeftOut& left_out, PartPoints& part, Recognition& result, const Progress& progress)
{
    std::int64_t excluded = 0;
    const std::vector<std::uint8_t> kept = keptPoints(left_out, part.all(), excluded);
    if (!left_out.scene.groups.empty()) noteSceneCut(left_out.scene, result);
    if (left_out.zones) result.notes.push_back({notes::zonesExcluded, {{"count", excluded}}});
    if (kept.empty()) return;
    part.is_cut = true;
    if (!part.scan.isMesh()) part.own = part.scan.points_mm;
    keepOnly(kept, part.own);
    if (part.scan.isMesh()) keepOnly(kept, part.samples);
    registration::checkPoints(part.own, "scan", progress);
}

void roundFacets(PartPoints& part, Recognition& result, const Progress& progress)
{
    double sagitta_mm = 0;
    for (int round = 0; round < recognitionLimits.facet_rounds; ++round) {
        const registration::RevolutionFit fit = registration::fitRevolution(part.own, progress);
        if (!registration::isBodyOfRevolution(fit)) break;
        RoundedPoints rounded = roundedPoints(part.scan, part.samples, fit, progress);
        if (rounded.points.empty()) break;
        part.own = std::move(rounded.points);
        sagitta_mm = rounded.sagitta_mm;
    }
    if (sagitta_mm > 0) result.notes.push_back({notes::facetsRounded, {{"sagitta_mm", sagitta_mm}}});
}

}  // namespace lathelier::features
