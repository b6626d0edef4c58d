// Time records: tables, universal files, WAV.
#include "engine/io/time_record/time_record_reader.h"
#include "tests/fuzz/check_record.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace lathelier;
    std::string_view bytes = fuzz::viewOf(data, size);
    const io::ImportOptions options = fuzz::takeOptions(bytes);
    fuzz::checkAnswer([&] {
        const io::TimeRecordFile file = io::readTimeRecord("fuzz", bytes, options);
        fuzz::checkFacts(file.facts, file.notes);
        fuzz::require(!file.record.channels.empty());
        for (const io::TimeChannel& channel : file.record.channels) {
            fuzz::require(!channel.rate_hz || *channel.rate_hz > 0);
            for (const std::size_t i : channel.at_limit) fuzz::require(i < channel.values.size());
        }
    });
    io::likeTimeRecord(bytes, options);
    return 0;
}
