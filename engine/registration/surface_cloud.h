// The smooth surface through a cloud: patches fitted to the neighbourhoods of its points, split at sharp edges.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/registration/neighbours.h"
#include "engine/registration/surface.h"
#include "engine/registration/surface_patch.h"

namespace lathelier {

/// One patch serves eight points that lie together. Where its residuals show an edge, it is replaced by up to three
/// sheets that continue the smooth patches around; the sheet nearest to the query counts.
class CloudSurface : public Surface {
public:
    CloudSurface(const Scan& cloud, const Progress& progress);

    void place(std::span<const Eigen::Vector3d> queries_mm, double max_distance_mm,
               std::span<SurfacePlace> places) const override;
    bool orient(const Progress& progress) override;
    double scatter_mm() const override { return scatter_mm_; }

private:
    static constexpr std::uint32_t points_per_patch = 8;
    static constexpr std::uint32_t none = 0xffffffff;

    struct Sheet {
        SurfacePatch patch;
        std::uint32_t next = none;  ///< another sheet through the same neighbourhood
    };

    void fitAll(const Progress& progress);
    void splitAtEdges(const Progress& progress);
    void gather(std::uint32_t patch, std::size_t count, std::vector<Eigen::Vector3d>& points_mm) const;
    SurfacePlace placeOne(const Eigen::Vector3d& query_mm, const Neighbours::Found& nearest) const;

    Neighbours points_;
    std::vector<Sheet> sheets_;  ///< first one for each eight points, then the further ones
    std::vector<Eigen::Vector3f> given_normals_;
    double scatter_mm_ = 0;
};

}  // namespace lathelier
