// Text tables as clouds, with all options.
#include "engine/io/cloud/text_reader.h"
#include "tests/fuzz/check_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace lathelier;
    std::string_view bytes = fuzz::viewOf(data, size);
    const io::ImportOptions options = fuzz::takeOptions(bytes);
    const Progress progress;
    fuzz::check([&] {
        const io::DecodedText text = io::decodeText(bytes, options.encoding);
        return io::finishScan(io::readTextScan({bytes, text.view(), text.encoding(), options, progress}), "fuzz",
                              options, progress);
    });
    return 0;
}
