#include "engine/cutting/insert_library.h"

#include "engine/io/json/library_file.h"

namespace lathelier::cutting {

std::vector<LibraryEntry<ToolGeometry>> readInserts(const std::string& json)
{
    return io::readLibrary<ToolGeometry>(json, "inserts");
}

}  // namespace lathelier::cutting
