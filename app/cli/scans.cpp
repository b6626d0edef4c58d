#include "app/cli/scans.h"

namespace lathelier::cli {

ScanFile readScan(const std::string& path, const Request& request, InputFiles& inputs, const Progress& progress,
                  Answer& answer)
{
    ScanFile file = readScan(path, inputs.open(path, progress), request, progress, answer);
    inputs.drop();
    return file;
}

ScanFile readScan(const std::string& path, std::string_view bytes, const Request& request, const Progress& progress,
                  Answer& answer)
{
    ScanFile file = lathelier::readScan(path, bytes, fromValues<ImportOptions>(request.parameters), progress);
    answer.notes.insert(answer.notes.end(), file.notes.begin(), file.notes.end());
    return file;
}

}  // namespace lathelier::cli
