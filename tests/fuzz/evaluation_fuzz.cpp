// Lines of results: any bytes are refused with a code and a line, or give evaluations that are written and read again
// as the same.
#include <cstdint>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "engine/archive/chain.h"
#include "engine/archive/result_lines.h"
#include "engine/core/texts.h"

namespace {

using namespace lathelier;

void require(bool condition)
{
    if (!condition) std::abort();
}

void checkEvaluation(const archive::Evaluation& evaluation)
{
    const std::string line = archive::toJson(evaluation).dump();
    require(line.find('\n') == std::string::npos);
    require(archive::toJson(archive::evaluationFrom(line)).dump() == line);
    require(!archive::canonicalOf(evaluation).dump().empty());
    archive::Row row = archive::rowOf(evaluation);
    row.hash = archive::hashOf(row);
    require(archive::evaluationOf(row).key() == evaluation.key());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    try {
        checkEvaluation(archive::evaluationFrom(text));
    } catch (const Error& error) {
        require(error.code().kind == ErrorKind::InputRejected && !lathelier::text(error).empty());
    }
    try {
        const archive::ResultLines lines = archive::readResultLines(text);
        for (const archive::Evaluation& evaluation : lines.evaluations) checkEvaluation(evaluation);
        for (const archive::ArchivedRecipe& recipe : lines.recipes) require(Json::accept(recipe.content));
    } catch (const Error& error) {
        require(error.code().kind == ErrorKind::InputRejected && find(error.values(), "line") != nullptr);
        require(!lathelier::text(error).empty());
    }
    return 0;
}
