// Program, set-up and stock of a slender shaft as files, for the panels of Deflection.
#pragma once

#include <QTemporaryDir>
#include <string>

#include "engine/deflection/case_a.h"
#include "engine/deflection/deflection_task.h"
#include "engine/deflection/setup_file.h"
#include "engine/gcode/program_input.h"
#include "engine/io/file.h"
#include "engine/project/project.h"

namespace lathelier::deflection_common {

inline constexpr const char* slenderProgram =
    "%\nO1\nG21 G40 G99\nT0101\nG97 S1200 M3\nG0 X40. Z2.\nX30.\nG1 Z-200. F0.2\nG0 Z2.\nX28.\nG1 Z-100.\nX40.\n"
    "G0 X100. Z100.\nM30\n%\n";

/// The folder has to outlive the panel.
inline void giveSlenderFiles(const QTemporaryDir& folder, project::PanelState& state,
                             const std::string& program = slenderProgram)
{
    deflection::TurningSetup setup = deflection::caseASetup();
    setup.stock = "stock.txt";
    const auto path = [&](const char* name) { return folder.filePath(name).toStdString(); };
    io::writeFile(path("stock.txt"), "17 0 17 0 287.5\n");
    io::writeFile(path("setup.json"), deflection::setupText(setup));
    io::writeFile(path("program.nc"), program);
    state.inputs[gcode::programRole].path = path("program.nc");
    state.inputs[deflection::setupRole].path = path("setup.json");
}

}  // namespace lathelier::deflection_common
