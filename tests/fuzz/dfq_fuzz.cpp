// Q-DAS files: what is read can be written, and comes back.
#include "engine/io/qdas/dfq.h"
#include "engine/io/qdas/dfq_reader.h"
#include "engine/io/qdas/dfq_writer.h"
#include "tests/fuzz/check_record.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace lathelier;
    fuzz::checkAnswer([&] {
        const io::QdasFile file = io::readDfq("fuzz", fuzz::viewOf(data, size));
        const io::QdasFile again = io::readDfq("again", io::toDfq(file));
        fuzz::require(again.characteristics.size() == file.characteristics.size());
        for (std::size_t i = 0; i < file.characteristics.size(); ++i)
            fuzz::require(again.characteristics[i].values.size() == file.characteristics[i].values.size());
    });
    return 0;
}
