#include "app/cli/records.h"

namespace lathelier::cli {
namespace {

void addNotes(const Notes& notes, Answer& answer)
{
    answer.notes.insert(answer.notes.end(), notes.begin(), notes.end());
}

}  // namespace

io::ProfileFile readProfile(const std::string& path, const Request& request, io::InputFiles& inputs,
                            const Progress& progress, Answer& answer)
{
    const std::string_view bytes = inputs.open(path, progress);
    const Values& given = request.parameters;
    io::ProfileFile file = io::readProfile(path, bytes, fromValues<io::ImportOptions>(given),
                                           fromValues<io::ProfileOptions>(given), progress);
    addNotes(file.notes, answer);
    return file;
}

io::ProbeFile readRecord(const std::string& path, const Request& request, io::InputFiles& inputs,
                         const Progress& progress, Answer& answer)
{
    const std::string_view bytes = inputs.open(path, progress);
    const Values& given = request.parameters;
    io::ProbeFile file = io::readProbeRecord(path, bytes, inputs, fromValues<io::ImportOptions>(given),
                                             fromValues<io::RecorderOptions>(given), progress);
    addNotes(file.notes, answer);
    return file;
}

}  // namespace lathelier::cli
