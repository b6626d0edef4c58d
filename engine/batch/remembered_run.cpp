#include "engine/batch/remembered_run.h"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>

#include "engine/batch/batch_codes.h"
#include "engine/core/json.h"
#include "engine/io/file.h"
#include "engine/io/io_codes.h"
#include "engine/io/json/json_document.h"

namespace lathelier::batch {
namespace {

namespace fs = std::filesystem;

constexpr const char* runSchema = "lathelier-batch";
constexpr std::size_t mostInputsRemembered = 10000000;

std::string fileIn(const std::string& folder)
{
    return (fs::path(folder) / "batch.json").string();
}

}  // namespace

void remember(const std::string& folder, const RememberedRun& run)
{
    std::error_code problem;
    fs::create_directories(folder, problem);
    if (problem) throw Error(errors::fileNotWritable, {{"path", folder}, {"reason", problem.message()}});
    const Json json{{"schema", runSchema},
                    {"schema_version", 1},
                    {"working_folder", fs::current_path().string()},
                    {"recipe", run.recipe},
                    {"inputs", run.inputs}};
    io::writeFile(fileIn(folder), json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

RememberedRun remembered(const std::string& folder)
{
    const std::string path = fileIn(folder);
    std::error_code unknown;
    if (!fs::exists(path, unknown)) throw Error(errors::batchNotRemembered, {{"path", folder}});
    try {
        const io::FileBytes bytes(path);
        const io::JsonDocument document{std::string(bytes.view())};
        const io::JsonCursor root = document.root();
        const io::JsonCursor schema = root.at("schema", std::string(runSchema));
        if (schema.string() != runSchema) schema.reject(std::string(runSchema));
        const fs::path working = root.at("working_folder", LT_TEXT("Engine", "a folder")).string();
        const auto given = [&](const std::string& stated) {
            return working == fs::current_path() ? stated : (working / stated).string();
        };
        RememberedRun run;
        run.recipe = given(root.at("recipe", LT_TEXT("Engine", "the path of a recipe")).string());
        root.at("inputs", LT_TEXT("Engine", "a list of paths"))
            .items(mostInputsRemembered,
                   [&](const io::JsonCursor& item) { run.inputs.push_back(given(item.string())); });
        return run;
    } catch (Error& error) {
        throw error.with("path", path);
    }
}

}  // namespace lathelier::batch
