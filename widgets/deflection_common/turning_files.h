// NC programs and set-ups that were read.
#pragma once

#include <string>

#include "engine/deflection/setup_file.h"
#include "engine/gcode/program_kind.h"
#include "widgets/core/files/file_cache.h"

namespace lathelier::deflection_common {

/// The text of a program and what was understood of it.
struct ProgramFile {
    std::string text;     ///< every byte
    io::FileFacts facts;  ///< as gcode::programFiles() has them
    Notes notes;          ///< of the reading
};

/// Errors as gcode::readProgram().
class ProgramStore : public FileCache<ProgramFile> {
public:
    ProgramStore() : FileCache(10) {}

protected:
    ProgramFile read(const project::Source& source, io::InputFiles& inputs, const Progress& progress) const override;
};

/// Errors as deflection::loadSetup().
class SetupStore : public FileCache<deflection::SetupFile> {
public:
    SetupStore() : FileCache(10) {}

protected:
    deflection::SetupFile read(const project::Source& source, io::InputFiles& inputs,
                               const Progress& progress) const override;
};

}  // namespace lathelier::deflection_common
