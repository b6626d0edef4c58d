#include "engine/io/time_record/time_record_reader.h"

#include <filesystem>

#include "engine/io/frf/uff.h"
#include "engine/io/io_codes.h"
#include "engine/io/text/units.h"
#include "engine/io/time_record/time_record_formats.h"

namespace lathelier::io {
namespace {

bool isUffRecord(const std::string& name, std::string_view bytes)
{
    const std::string extension = lowerCase(std::filesystem::path(name).extension().string());
    return isUff(bytes) || extension == ".uff" || extension == ".unv";
}

Value wordOrNothing(const std::string& word)
{
    return word.empty() ? Value() : Value(word);
}

Row channelRow(const TimeChannel& channel)
{
    Value role;
    if (channel.role == TimeChannel::Role::Force) role = std::string("force");
    if (channel.role == TimeChannel::Role::Motion) role = std::string("motion");
    return {{{"number", channel.number},
             {"name", wordOrNothing(channel.name)},
             {"unit", channel.is_of_full_scale ? Value(std::string("full scale")) : wordOrNothing(channel.unit_text)},
             {"role", std::move(role)},
             {"points", static_cast<std::int64_t>(channel.values.size())},
             {"rate_hz", channel.rate_hz ? Value(*channel.rate_hz) : Value()},
             {"start_s", channel.start_s}}};
}

/// What is the same for all formats.
void describeChannels(TimeRecordFile& file)
{
    Rows channels;
    for (const TimeChannel& channel : file.record.channels) channels.rows.push_back(channelRow(channel));
    set(file.facts.details, "channels", std::move(channels));
    const TimeChannel& first = file.record.channels.front();
    if (!first.rate_hz) return;
    set(file.facts.details, "rate_hz", *first.rate_hz);
    set(file.facts.details, "duration_s", static_cast<double>(first.values.size()) / *first.rate_hz);
}

}  // namespace

TimeRecordFile readTimeRecord(const std::string& name, std::string_view bytes, const ImportOptions& options,
                              const Progress& progress)
{
    try {
        TimeRecordFile file = isWav(bytes)               ? readWav(bytes, progress)
                              : isUffRecord(name, bytes) ? readTimeUff(bytes, progress)
                                                         : readTimeTable(name, bytes, options, progress);
        file.record.name = std::filesystem::path(name).filename().string();
        file.facts.path = name;
        describeChannels(file);
        for (Note& note : file.notes)
            if (!find(note.values, "path")) set(note.values, "path", name);
        return file;
    } catch (Error& error) {
        throw error.with("path", name);
    }
}

Likeness likeTimeRecord(std::string_view head, const ImportOptions& options)
{
    return isWav(head) || isTimeUff(head) || isTimeTable(head, options) ? Likeness::Certain : Likeness::No;
}

const FileKind& timeRecordFiles()
{
    static const FileKind kind{"time_record",
                               LT_TEXT("Engine", "Time records"),
                               "*.csv *.txt *.tsv *.uff *.unv *.wav",
                               {},
                               {},
                               [](const std::string&, std::string_view head, const Values& reading) {
                                   return likeTimeRecord(head, fromValues<ImportOptions>(reading));
                               },
                               [](const FileToRead& file, Notes& notes) {
                                   TimeRecordFile read = readTimeRecord(
                                       file.path, file.bytes, fromValues<ImportOptions>(file.reading), file.progress);
                                   notes.insert(notes.end(), read.notes.begin(), read.notes.end());
                                   return std::move(read.facts);
                               }};
    return kind;
}

}  // namespace lathelier::io
