#include "app/cli/scans.h"

namespace lathelier::cli {

ScanFile readScan(const std::string& path, const Request& request, Inputs& inputs, const Progress& progress,
                  Answer& answer)
{
    const std::string_view bytes = inputs.open(path, progress);
    ScanFile file = lathelier::readScan(path, bytes, fromValues<ImportOptions>(request.parameters), progress);
    answer.notes.insert(answer.notes.end(), file.notes.begin(), file.notes.end());
    return file;
}

}  // namespace lathelier::cli
