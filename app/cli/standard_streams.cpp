#include "app/cli/standard_streams.h"

#include <unistd.h>

#include <cerrno>
#include <string>

#include "engine/core/error.h"
#include "engine/io/file_system.h"
#include "engine/io/io_codes.h"

namespace lathelier::cli {

void print(Stream stream, std::string_view text)
{
    const int descriptor = stream == Stream::Answers ? STDOUT_FILENO : STDERR_FILENO;
    while (!text.empty()) {
        const ssize_t count = ::write(descriptor, text.data(), text.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) {
            if (stream == Stream::Errors) return;
            throw Error(errors::fileNotWritable,
                        {{"path", std::string("standard output")}, {"reason", systemReason(errno)}});
        }
        text.remove_prefix(static_cast<std::size_t>(count));
    }
}

}  // namespace lathelier::cli
