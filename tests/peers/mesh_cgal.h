// Distance to a mesh by CGAL's AABB tree, measured beside ours.
#pragma once

#include <Eigen/Core>
#include <memory>

#include "engine/core/scan.h"

namespace lathelier::peers {

class CgalMesh {
public:
    explicit CgalMesh(const Scan& mesh);
    ~CgalMesh();
    double distance_mm(const Eigen::Vector3d& query_mm) const;

private:
    struct Tree;
    std::unique_ptr<Tree> tree_;
};

}  // namespace lathelier::peers
