#include "widgets/deflection_common/turning_files.h"

namespace lathelier::deflection_common {

ProgramFile ProgramStore::read(const project::Source& source, io::InputFiles& inputs, const Progress& progress) const
{
    ProgramFile file;
    file.text = inputs.open(source.path, progress.part(0, 0.2));
    file.facts = gcode::programFiles().facts({source.path, file.text, source.import, inputs, progress}, file.notes);
    return file;
}

deflection::SetupFile SetupStore::read(const project::Source& source, io::InputFiles& inputs,
                                       const Progress& progress) const
{
    return deflection::loadSetup({source.path, inputs.open(source.path, progress), source.import, inputs, progress});
}

}  // namespace lathelier::deflection_common
