#include "app/cli/records.h"

#include <filesystem>

#include "engine/io/dfq_writer.h"
#include "engine/io/scan_reader.h"
#include "engine/io/units.h"

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
    return readProfile(path, inputs.open(path, progress), request, progress, answer);
}

ProfileFile readProfile(const std::string& path, std::string_view bytes, const Request& request,
                        const Progress& progress, Answer& answer)
{
    const Values& given = request.parameters;
    ProfileFile file = lathelier::readProfile(path, bytes, fromValues<ImportOptions>(given),
                                              fromValues<ProfileOptions>(given), progress);
    addNotes(file.notes, answer);
    return file;
}

ProbeFile readRecord(const std::string& path, const Request& request, InputFiles& inputs, const Progress& progress,
                     Answer& answer)
{
    return readRecord(path, inputs.open(path, progress), request, inputs, progress, answer);
}

ProbeFile readRecord(const std::string& path, std::string_view bytes, const Request& request, InputFiles& inputs,
                     const Progress& progress, Answer& answer)
{
    const Values& given = request.parameters;
    ProbeFile file = readProbeRecord(path, bytes, inputs, fromValues<ImportOptions>(given),
                                     fromValues<RecorderOptions>(given), progress);
    addNotes(file.notes, answer);
    return file;
}

RecordKind kindOf(const std::string& path, std::string_view bytes, const Request& request)
{
    const auto options = fromValues<ImportOptions>(request.parameters);
    if (isDfq(bytes) || lowerCase(std::filesystem::path(path).extension().string()) == ".dfq") return RecordKind::Qdas;
    const RecordFiles files = findRecordFiles(path, bytes);
    const bool isPair = files.kind == RecordFiles::Kind::LGraph;
    if (isPair && !files.par.empty()) return RecordKind::ProbeRecord;
    if (hasScanFormat(bytes)) return RecordKind::None;
    if (isPair || isProbeTable(bytes, options)) return RecordKind::ProbeRecord;
    const ProfileColumns columns = fromValues<ProfileOptions>(request.parameters).columns;
    return isProfileTable(bytes, options, columns) ? RecordKind::Profile : RecordKind::None;
}

}  // namespace lathelier::cli
