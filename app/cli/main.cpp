// lathelier-cli: one verb for each capability of the engine. The contract is its help page and exit codes.
#include <malloc.h>

#include <csignal>

#include "app/cli/arguments.h"
#include "app/cli/interruption.h"
#include "app/cli/run.h"

namespace {

/// A run is short and its arrays are large: memory that was given back is asked for again at once, and each time the
/// system would fill it with zeros page by page (a tenth of the time of a comparison of ten million points).
void keepFreedMemory()
{
    mallopt(M_MMAP_THRESHOLD, 256 << 20);
    mallopt(M_TRIM_THRESHOLD, 1 << 30);
}

}  // namespace

int main(int argc, char** argv)
{
    using namespace lathelier::cli;
    keepFreedMemory();
    std::signal(SIGPIPE, SIG_IGN);  // a closed pipe is reported as an error
    std::signal(SIGXFSZ, SIG_IGN);  // a file size limit is reported as an error
    const Parsed parsed = parseArguments(argc, argv);
    if (!parsed.invocation) return parsed.exit_code;
    const Interruption interruption;
    return run(*parsed.invocation, interruption.token());
}
