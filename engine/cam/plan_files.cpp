#include "engine/cam/plan_files.h"

#include <filesystem>
#include <optional>

#include "engine/cam/plan_refusal.h"
#include "engine/core/error.h"
#include "engine/io/file.h"
#include "engine/io/io_codes.h"

namespace lathelier::cam {

std::vector<std::string> programPaths(const std::string& stated, std::size_t count)
{
    if (count < 2) return {stated};
    const std::filesystem::path path(stated);
    std::vector<std::string> paths;
    for (std::size_t i = 0; i < count; ++i)
        paths.push_back(
            (path.parent_path() / (path.stem().string() + "_" + std::to_string(i + 1) + path.extension().string()))
                .string());
    return paths;
}

void refuseInputs(const std::vector<std::string>& paths, const std::vector<InputFile>& inputs,
                  const std::string& parameter)
{
    std::error_code ignored;
    for (const std::string& path : paths)
        for (const InputFile& input : inputs)
            if (std::filesystem::equivalent(input.path, path, ignored))
                throw Error(errors::outputIsInput, {{"parameter", parameter}, {"file", input.path}});
}

void writePrograms(const TurningPlan& plan, const std::vector<std::string>& paths)
{
    std::vector<std::optional<std::string>> before;
    std::error_code ignored;
    try {
        for (std::size_t i = 0; i < plan.setups.size(); ++i) {
            std::optional<std::string> old;
            const bool is_last = i + 1 == plan.setups.size();
            if (!is_last && std::filesystem::is_regular_file(paths.at(i), ignored))
                old = std::string(io::FileBytes(paths[i]).view());
            io::writeFile(paths.at(i), plan.setups[i].text);
            before.push_back(std::move(old));
        }
    } catch (...) {
        for (std::size_t i = 0; i < before.size(); ++i) {
            if (before[i])
                io::writeFile(paths[i], *before[i]);
            else if (std::filesystem::is_regular_file(paths[i], ignored))
                std::filesystem::remove(paths[i], ignored);
        }
        throw;
    }
}

void writeRefused(const TurningPlan& plan, const std::vector<std::string>& paths)
{
    for (std::size_t i = 0; i < plan.setups.size(); ++i)
        io::writeFile(refusedPath(paths.at(i)), stoppedText(plan.setups[i].text));
}

}  // namespace lathelier::cam
