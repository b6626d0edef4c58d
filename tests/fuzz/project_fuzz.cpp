// Any bytes are a project or an Error; what is read is written and read again as the same project.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "engine/core/error.h"
#include "engine/project/project_json.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace lathelier;
    project::Project project;
    try {
        project = project::parseProject({reinterpret_cast<const char*>(data), size}, "/folder");
    } catch (const Error&) {
        return 0;
    }
    const std::string text = project::toJsonText(project, "/folder");
    if (project::toJsonText(project::parseProject(text, "/folder"), "/folder") != text) std::abort();
    return 0;
}
