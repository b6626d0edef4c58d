// lathelier-cli: one verb for each capability of the engine. The contract is its help page and exit codes.
#include <csignal>

#include "app/cli/arguments.h"
#include "app/cli/interruption.h"
#include "app/cli/run.h"

int main(int argc, char** argv)
{
    using namespace lathelier::cli;
    std::signal(SIGPIPE, SIG_IGN);  // a reader that has gone is an error like any other
    std::signal(SIGXFSZ, SIG_IGN);  // so is a limit on the size of files
    const Parsed parsed = parseArguments(argc, argv);
    if (!parsed.invocation) return parsed.exit_code;
    const Interruption interruption;
    return run(*parsed.invocation, interruption.token());
}
