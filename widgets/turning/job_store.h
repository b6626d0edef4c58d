// Files of jobs and of posts that were read.
#pragma once

#include "engine/cam/job_file.h"
#include "engine/cam/post/post_file.h"
#include "widgets/core/files/file_cache.h"

namespace lathelier::turning_panel {

/// Errors as cam::loadJob().
class JobStore : public FileCache<cam::JobFile> {
public:
    JobStore() : FileCache(20) {}

protected:
    cam::JobFile read(const project::Source& source, io::InputFiles& inputs, const Progress& progress) const override
    {
        return cam::loadJob({source.path, inputs.open(source.path, progress), source.import, inputs, progress});
    }
};

/// Errors as cam::loadPost().
class PostStore : public FileCache<cam::PostFile> {
public:
    PostStore() : FileCache(4) {}

protected:
    cam::PostFile read(const project::Source& source, io::InputFiles& inputs, const Progress& progress) const override
    {
        return cam::loadPost({source.path, inputs.open(source.path, progress), source.import, inputs, progress});
    }
};

}  // namespace lathelier::turning_panel
