// The place in its file of a row of a shaft that an error is about.
#pragma once

#include <string>

#include "engine/core/error.h"
#include "engine/shaft/shaft.h"

namespace lathelier::receptance {

/// Gives an error of a row of the shaft the path of its file, and the place of the row where the file holds the rows as
/// they were computed (bores divide them). Other errors stay as they are.
void locateSegment(Error& error, const std::string& path, const Shaft& shaft);

/// Calls `work`, with locateSegment() for its errors; `path` empty: no file.
template <class Work>
auto namingShaft(const std::string& path, const Shaft& shaft, Work work)
{
    try {
        return work();
    } catch (Error& error) {
        if (!path.empty()) locateSegment(error, path, shaft);
        throw;
    }
}

}  // namespace lathelier::receptance
