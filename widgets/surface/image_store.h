// Files of pictures that were read.
#pragma once

#include "engine/io/image/image.h"
#include "engine/io/input_files.h"
#include "engine/task/file_cache.h"

namespace lathelier::surface_panel {

/// Errors as io::readImage(), with the path.
class ImageStore : public FileCache<io::Image> {
public:
    ImageStore() : FileCache(3) {}  // pictures of 100 Mpx have 400 MB: before, after, and the next one

protected:
    io::Image read(const project::Source& source, io::InputFiles& inputs, const Progress& progress) const override
    {
        try {
            return io::readImage(source.path, inputs.open(source.path, progress.part(0, 0.2)), progress.part(0.2, 1));
        } catch (Error& error) {
            throw error.with("path", source.path);
        }
    }
};

}  // namespace lathelier::surface_panel
