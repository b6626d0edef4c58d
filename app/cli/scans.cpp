#include "app/cli/scans.h"

namespace lathelier::cli {

ScanFile readScan(const std::string& path, const Request& request, InputFiles& inputs, const Progress& progress,
                  Answer& answer)
{
    const auto options = fromValues<ImportOptions>(request.parameters);
    ScanFile file = lathelier::readScan(path, inputs.open(path, progress), options, progress);
    inputs.drop();
    answer.notes.insert(answer.notes.end(), file.notes.begin(), file.notes.end());
    return file;
}

}  // namespace lathelier::cli
