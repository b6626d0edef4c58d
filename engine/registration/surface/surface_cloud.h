// The smooth surface through a cloud: quadric patches fitted to the neighbourhoods of its points, split at sharp edges.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/registration/neighbours/neighbours.h"
#include "engine/registration/surface/surface.h"
#include "engine/registration/surface/surface_patch.h"

namespace lathelier::registration {

/// Eight points that lie together share one patch, or more where they do not lie within one patch's reach. A patch
/// whose residuals show an edge is replaced by up to three sheets that continue the smooth patches around. Of the
/// patches of the nearest point the one nearest to the query counts.
class CloudSurface : public Surface {
public:
    CloudSurface(const Scan& cloud, const Progress& progress);

    void place(std::span<const Eigen::Vector3d> queries_mm, double max_distance_mm, std::span<SurfacePlace> places,
               std::span<Trace> traces) const override;
    bool orient(const Progress& progress) override;
    double scatter_mm() const override { return scatter_mm_; }
    std::size_t pointCount() const override { return points_.size(); }
    const Neighbours* points() const override { return &points_; }
    double spacing_mm() const override { return 0.25 * reach_mm_; }

private:
    static constexpr std::uint32_t groupSize = 8;

    struct Member {
        std::uint32_t group;
        std::uint32_t centre;  ///< place of the point in whose neighbourhood the patch was fitted
        SurfacePatch patch;
    };

    struct Search;  // working memory of one thread

    std::uint32_t groupCount() const
    {
        return static_cast<std::uint32_t>((points_.size() + groupSize - 1) / groupSize);
    }
    std::uint32_t groupEnd(std::uint32_t group) const;
    void gather(std::uint32_t centre, std::size_t count, Search& search) const;
    void surround(std::size_t group, std::size_t end, Search& search) const;
    void fitGroup(std::uint32_t group, Search& search, std::vector<Member>& members) const;
    std::vector<Member> fitAll(const Progress& progress) const;
    std::vector<Member> splitAtEdges(const std::vector<Member>& members, const Progress& progress) const;
    void split(const Member& rough, const Neighbours& smooth_index, const std::vector<SurfacePatch>& smooth,
               Search& search, std::vector<Member>& sheets) const;
    bool isSmooth(const SurfacePatch& patch) const;
    SurfacePlace placeOne(const Eigen::Vector3d& query_mm, const Neighbours::Found& nearest) const;

    void store(const std::vector<Member>& members);
    SurfacePlace placeOn(std::uint32_t spot, const Eigen::Vector3d& query_mm, const Neighbours::Found& nearest) const;

    Neighbours points_;
    struct Spot {
        Eigen::Vector3d centre_mm;
        std::uint32_t first_patch;  ///< its patches end where those of the next spot begin
    };

    std::vector<std::uint32_t> firstSpot_;  ///< spots of group g: firstSpot_[g] … firstSpot_[g+1]-1
    std::vector<Spot> spots_;               ///< and one behind the last
    std::vector<SurfacePatch> patches_;
    std::vector<Eigen::Vector3f> givenNormals_;
    double scatter_mm_ = 0;
    double reach_mm_ = 0;  ///< usual radius of a patch
};

}  // namespace lathelier::registration
