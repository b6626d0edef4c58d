#include "engine/chain/machine_fit.h"

#include <algorithm>
#include <filesystem>
#include <memory>

#include "engine/deflection/setup_file.h"
#include "engine/deflection/turning_job.h"
#include "engine/io/file.h"
#include "engine/io/input_files.h"
#include "engine/receptance/spindle/spindle_file.h"

namespace lathelier::chain {
namespace fs = std::filesystem;
namespace {

/// The input file of this name of a step; empty: none.
std::string inputFileNamed(const std::string& folder, const ChainStep& step, const std::string& stated)
{
    const std::string name = fs::path(stated).filename().string();
    for (const InputFile& file : step.inputs)
        if (fs::path(file.path).filename() == name) return (fs::path(folder) / file.path).string();
    return {};
}

/// The program among the inputs of a step.
std::string programOf(const std::string& folder, const ChainStep& step)
{
    for (const InputFile& file : step.inputs)
        if (fs::path(file.path).stem().string().starts_with("program")) return (fs::path(folder) / file.path).string();
    return {};
}

/// Springs of the machine model used for the receptance of the chain.
std::optional<receptance::SpindleSprings> springsOf(const std::string& folder, const Dossier& dossier)
{
    const ChainStep* const step = dossier.step("machine");
    const Value* const stated = step ? find(step->parameters, "spindle") : nullptr;
    const auto* const name = stated ? std::get_if<std::string>(stated) : nullptr;
    if (!name) return std::nullopt;
    Notes ignored_notes;  // already reported by the step
    const io::FileBytes bytes(inputFileNamed(folder, *step, *name));
    const receptance::SpindleReceptance machine = receptance::readSpindle(std::string(bytes.view()), ignored_notes);
    return machine.springs() ? std::optional(*machine.springs()) : std::nullopt;
}

double interpolatedAt(const std::vector<double>& z_mm, const std::vector<double>& values, double at_mm)
{
    for (std::size_t i = 0; i + 1 < z_mm.size(); ++i) {
        const double step_mm = z_mm[i + 1] - z_mm[i];
        if (step_mm > 0 && z_mm[i] <= at_mm && at_mm <= z_mm[i + 1])
            return values[i] + (values[i + 1] - values[i]) * (at_mm - z_mm[i]) / step_mm;
    }
    return values.empty() ? 0 : values.back();
}

}  // namespace

std::vector<deflection::MeasuredDiameter> fittedDiameters(const deflection::FinalContour& contour, const Proof& proof,
                                                          double zero_mm)
{
    std::vector<deflection::MeasuredDiameter> diameters;
    if (contour.z_mm.empty()) return diameters;
    for (const MeasuredPlace& place : proof.along) {
        const double z_mm = place.z_mm + zero_mm;
        if (z_mm < contour.z_mm.front() || z_mm > contour.z_mm.back()) continue;
        const double target_mm = 2 * interpolatedAt(contour.z_mm, contour.target_radius_mm, z_mm);
        diameters.push_back({z_mm, target_mm + place.error_um / 1000, std::max(0.1, place.uncertainty_um / 2)});
    }
    return diameters;
}

std::optional<MachineFit> fitMachine(const std::string& folder, const Dossier& dossier, const Proof& proof,
                                     const deflection::IdentificationParameters& parameters, const Progress& progress)
{
    const ChainStep* const step = dossier.step("deflection");
    if (!step || step->state != StepState::Done || proof.along.empty()) return std::nullopt;
    const Value* const stated = find(step->parameters, "setup");
    const auto* const name = stated ? std::get_if<std::string>(stated) : nullptr;
    const std::string path = name ? inputFileNamed(folder, *step, *name) : std::string();
    const std::string program_path = programOf(folder, *step);
    if (path.empty() || program_path.empty()) return std::nullopt;

    io::InputFiles inputs;
    deflection::SetupFile setup = deflection::loadSetup({path, inputs.open(path, progress), {}, inputs, progress});
    if (!setup.stock) return std::nullopt;
    gcode::Program program =
        gcode::readProgram(std::string(inputs.open(program_path, progress)), nullptr, {}, program_path);
    gcode::Toolpath moves = findToolpath(program);
    const deflection::TurningJob job =
        deflection::turningJob(std::move(program), std::move(moves), std::move(*setup.stock), setup.setup);
    MachineFit fit;
    fit.zero_mm = setup.setup.z_zero_mm;
    fit.springs = springsOf(folder, dossier);
    const deflection::DeflectionResult before = predictJob(job, progress.part(0, 0.2));
    fit.found = identify(job.stock, job.runs, job.setup, fittedDiameters(before.final, proof, fit.zero_mm), parameters,
                         progress.part(0.2, 1));
    deflection::TurningSetup written = fit.found.setup;
    const std::string stock =
        fs::absolute(fs::path(path).parent_path() / setup.setup.stock).lexically_normal().string();
    written.stock = stock;
    fit.whole_text = deflection::setupText(written);
    written.stock = setup.setup.stock == "bar.json" ? std::string() : stock;
    fit.setup_text = deflection::setupText(written);
    return fit;
}

}  // namespace lathelier::chain
