#include "engine/sample/sample_files.h"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>

#include "engine/core/error.h"
#include "engine/core/json.h"
#include "engine/io/file.h"
#include "engine/io/io_codes.h"
#include "engine/project/project.h"
#include "engine/sample/chain_sample.h"
#include "engine/sample/chatter_sample.h"
#include "engine/sample/cylinder_sample.h"
#include "engine/sample/deflection_sample.h"
#include "engine/sample/profile_sample.h"
#include "engine/sample/record_sample.h"
#include "engine/sample/scan_sample.h"
#include "engine/sample/surface_sample.h"
#include "engine/sample/tap_sample.h"
#include "engine/sample/worn_sample.h"

namespace lathelier::sample {
namespace {

constexpr char truthName[] = "truth.json";
constexpr char projectName[] = "sample.lathelier";

/// Panels and report of one part; `sources`: its files and those of the parts before it, by name.
void take(const SampleContent& content, const std::map<std::string, project::Source>& sources,
          project::Project& project)
{
    for (const auto& [id, panel] : content.panels) {
        project::PanelState& state = project.panels[id];
        for (const auto& [role, file] : panel.inputs) state.inputs[role] = sources.at(file);
        state.parameters = panel.parameters;
        if (panel.in_report) project.report.push_back(id);
    }
}

}  // namespace

const std::vector<const SamplePart*>& sampleParts()
{
    static const std::vector<const SamplePart*> all{
        &scanSample(),       &recordSample(), &cylinderSample(), &profileSample(), &chatterSample(),
        &deflectionSample(), &tapSample(),    &wornSample(),     &surfaceSample(), &chainSample()};
    return all;
}

std::vector<std::string> sampleFileNames()
{
    std::vector<std::string> names;
    for (const SamplePart* part : sampleParts()) names.insert(names.end(), part->files.begin(), part->files.end());
    names.emplace_back(truthName);
    names.emplace_back(projectName);
    return names;
}

std::vector<std::string> writeSample(const std::string& directory, std::uint64_t seed, const Progress& progress)
{
    namespace fs = std::filesystem;
    std::error_code failure;
    fs::create_directories(directory, failure);
    if (failure) throw Error(errors::fileNotWritable, {{"path", directory}, {"reason", failure.message()}});
    const auto path = [&](const std::string& name) {
        return (fs::absolute(directory) / name).lexically_normal().string();
    };

    project::Project project;
    project.title = "Sample: a worn shaft, its copy, and a record of the lathe's spindle";
    project.name = "Shaft of the paper";
    Json truth{{"seed", seed}};
    const auto count = static_cast<double>(sampleParts().size());
    std::map<std::string, project::Source> sources;
    double done = 0;
    for (const SamplePart* part : sampleParts()) {
        const SampleContent content = part->make(seed, progress.part(done / count, (done + 1) / count));
        for (std::size_t i = 0; i < part->files.size(); ++i) {
            const std::string& name = part->files[i];
            io::writeFile(path(name), content.texts.at(i));
            sources[name] = {
                .path = path(name), .import = {}, .sha256 = io::sha256(content.texts[i]), .synthetic = true};
        }
        truth.update(*content.truth);
        take(content, sources, project);
        done += 1;
    }
    io::writeFile(path(truthName), truth.dump(1) + "\n");
    project::writeProject(path(projectName), project);
    progress.report(1);

    std::vector<std::string> paths;
    for (const std::string& name : sampleFileNames()) paths.push_back(path(name));
    return paths;
}

}  // namespace lathelier::sample
