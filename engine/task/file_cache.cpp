#include "engine/task/file_cache.h"

#include "engine/project/project_codes.h"

namespace lathelier {

std::string shortDigest(const std::string& sha256)
{
    return sha256.substr(0, 12);
}

void requireSame(const FileSeen& before, const InputFile& now)
{
    if (before.sha256 != now.sha256)
        throw Error(errors::sourceReplaced, {{"path", now.path},
                                             {"read", shortDigest(before.sha256)},
                                             {"now", shortDigest(now.sha256)},
                                             {"read_sha256", before.sha256},
                                             {"now_sha256", now.sha256}});
}

}  // namespace lathelier
