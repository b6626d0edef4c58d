// A file of zones as an input of a task (task/inputs.h).
#pragma once

#include <string>
#include <vector>

#include "engine/io/file_kind.h"
#include "engine/registration/verdict/zone_limits.h"

namespace lathelier::registration {

struct ZonesFile {
    std::vector<ZoneLimits> zones;  ///< in order of z
    Notes notes;                    ///< of the reader
};

struct ZonesInput {
    using File = ZonesFile;
    using Value = std::vector<ZoneLimits>;
    static constexpr const char* item = "";

    static File read(const io::FileToRead& file)
    {
        File loaded;
        loaded.zones = readZones(std::string(file.bytes), loaded.notes);
        return loaded;
    }
    static Value valueOf(const File& file) { return file.zones; }
    static io::FileKinds kinds() { return {}; }
};

}  // namespace lathelier::registration
