#include "engine/surface/picture_kernel.h"

#include "engine/core/module.h"

namespace lathelier::surface {

const PictureKernel& pictureKernel()
{
    static const auto& table = moduleTable<PictureKernel>("lathelier-opencv", "lathelier_picture_kernel");
    return table;
}

}  // namespace lathelier::surface
