// L-Graph pairs: the first two bytes say how long the .par is, the rest is the .dat.
#include "engine/io/probe/lgraph.h"
#include "tests/fuzz/check_record.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace lathelier;
    std::string_view bytes = fuzz::viewOf(data, size);
    if (bytes.size() < 2) return 0;
    const std::size_t length = data[0] + 256U * data[1];
    bytes.remove_prefix(2);
    const std::string_view par = bytes.substr(0, length);
    const std::string_view dat = bytes.substr(par.size());
    fuzz::checkAnswer([&] { fuzz::checkRecord(io::readLGraph("fuzz.par", par, dat, {}, {}, "fuzz.dat")); });
    return 0;
}
