#include "app/cli/standard_streams.h"

#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <string>

#include "engine/core/error.h"
#include "engine/io/file_system.h"
#include "engine/io/io_codes.h"

namespace lathelier::cli {

namespace {

constexpr int patience_ms = 50;           ///< between looks at whether the user wants a stop
constexpr std::size_t steadyStep = 4096;  ///< a pipe that is ready takes so much at once (PIPE_BUF)
constexpr std::size_t fileStep = std::size_t{1} << 20;

}  // namespace

void print(Stream stream, std::string_view text, const Progress& progress)
{
    const int descriptor = stream == Stream::Answers ? STDOUT_FILENO : STDERR_FILENO;
    struct stat status {};
    const bool isFile = ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
    while (!text.empty()) {
        progress.check();
        if (!isFile) {
            pollfd ready{descriptor, POLLOUT, 0};
            if (::poll(&ready, 1, patience_ms) == 0) continue;
        }
        const ssize_t count = ::write(descriptor, text.data(), std::min(text.size(), isFile ? fileStep : steadyStep));
        if (count < 0 && (errno == EINTR || errno == EAGAIN)) continue;
        if (count < 0) {
            if (stream == Stream::Errors) return;
            throw Error(errors::fileNotWritable,
                        {{"path", std::string("standard output")}, {"reason", io::systemReason(errno)}});
        }
        text.remove_prefix(static_cast<std::size_t>(count));
    }
}

}  // namespace lathelier::cli
