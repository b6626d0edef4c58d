#include "app/cli/records.h"

namespace lathelier::cli {
namespace {

void addNotes(const Notes& notes, Answer& answer)
{
    answer.notes.insert(answer.notes.end(), notes.begin(), notes.end());
}

}  // namespace

ProfileFile readProfile(const std::string& path, const Request& request, InputFiles& inputs, const Progress& progress,
                        Answer& answer)
{
    const std::string_view bytes = inputs.open(path, progress);
    const Values& given = request.parameters;
    ProfileFile file = lathelier::readProfile(path, bytes, fromValues<ImportOptions>(given),
                                              fromValues<ProfileOptions>(given), progress);
    addNotes(file.notes, answer);
    return file;
}

ProbeFile readRecord(const std::string& path, const Request& request, InputFiles& inputs, const Progress& progress,
                     Answer& answer)
{
    const std::string_view bytes = inputs.open(path, progress);
    const Values& given = request.parameters;
    ProbeFile file = readProbeRecord(path, bytes, inputs, fromValues<ImportOptions>(given),
                                     fromValues<RecorderOptions>(given), progress);
    addNotes(file.notes, answer);
    return file;
}

}  // namespace lathelier::cli
