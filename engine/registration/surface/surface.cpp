#include "engine/registration/surface/surface.h"

#include "engine/registration/surface/surface_cloud.h"
#include "engine/registration/surface/surface_mesh.h"

namespace lathelier::registration {

std::unique_ptr<Surface> makeSurface(const Scan& scan, const Progress& progress)
{
    if (scan.isMesh()) return std::make_unique<MeshSurface>(scan, progress);
    return std::make_unique<CloudSurface>(scan, progress);
}

}  // namespace lathelier::registration
