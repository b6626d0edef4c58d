#include "app/cli/scans.h"

namespace lathelier::cli {

io::ScanFile readScan(const std::string& path, const Request& request, io::InputFiles& inputs, const Progress& progress,
                      Answer& answer)
{
    return readScan(path, inputs.open(path, progress), request, inputs, progress, answer);
}

io::ScanFile readScan(const std::string& path, std::string_view bytes, const Request& request, io::InputFiles& inputs,
                      const Progress& progress, Answer& answer)
{
    const auto options = fromValues<io::ImportOptions>(request.parameters);
    io::ScanFile file = io::readScan(path, bytes, options, progress);
    inputs.drop();
    answer.notes.insert(answer.notes.end(), file.notes.begin(), file.notes.end());
    return file;
}

}  // namespace lathelier::cli
