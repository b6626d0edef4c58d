// writeFile: beside, then rename.
#include <fcntl.h>
#include <sys/stat.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <filesystem>

#include "engine/core/error.h"
#include "engine/io/file.h"
#include "engine/io/file_system.h"
#include "engine/io/io_codes.h"

namespace lathelier {
namespace {

constexpr std::size_t bufferSize = std::size_t{1} << 18;

[[noreturn]] void throwNotWritable(const std::string& path, int error)
{
    throw Error(errors::fileNotWritable, {{"path", path}, {"reason", systemReason(error)}});
}

/// Gathers small chunks and writes them out.
class Output {
public:
    Output(int descriptor, const std::string& path) : descriptor_(descriptor), path_(path) {}

    void append(std::string_view chunk)
    {
        buffer_.append(chunk);
        if (buffer_.size() >= bufferSize) flush();
    }

    void flush()
    {
        std::string_view rest = buffer_;
        while (!rest.empty()) {
            const ssize_t count = ::write(descriptor_, rest.data(), rest.size());
            if (count < 0 && errno == EINTR) continue;
            if (count <= 0) throwNotWritable(path_, count < 0 ? errno : ENOSPC);
            rest.remove_prefix(static_cast<std::size_t>(count));
        }
        buffer_.clear();
    }

private:
    int descriptor_;
    const std::string& path_;
    std::string buffer_;
};

/// Removes the file beside unless the rename succeeded.
struct RemoveOnFailure {
    std::string path;
    bool done = false;
    ~RemoveOnFailure()
    {
        if (!done) ::unlink(path.c_str());
    }
};

/// Where a link points to in the end, also when that file is still to be made.
std::string followLinks(const std::string& path)
{
    std::error_code failure;
    const std::filesystem::path target = std::filesystem::weakly_canonical(path, failure);
    return failure || target.empty() ? path : target.string();
}

std::string nameBeside(const std::string& path)
{
    static std::atomic<unsigned> counter{0};
    const std::string name = ".lathelier-" + std::to_string(::getpid()) + "-" + std::to_string(counter++) + ".part";
    return (std::filesystem::path(path).parent_path() / name).string();
}

}  // namespace

void writeFile(const std::string& path,
               const std::function<void(const std::function<void(std::string_view)>& append)>& write)
{
    const std::string target = followLinks(path);
    struct stat status {};
    const bool exists = ::stat(target.c_str(), &status) == 0;
    if (target.empty()) throwNotWritable(path, ENOENT);
    if (exists && S_ISDIR(status.st_mode)) throwNotWritable(path, EISDIR);
    // The rename needs no permission on the file it replaces; a write-protected file must stay all the same.
    if (exists && ::access(target.c_str(), W_OK) != 0) throwNotWritable(path, errno);

    const auto fill = [&](int descriptor) {
        Output output(descriptor, path);
        write([&output](std::string_view chunk) { output.append(chunk); });
        output.flush();
    };
    if (exists && !S_ISREG(status.st_mode)) {
        Descriptor stream(::open(target.c_str(), O_WRONLY | O_CLOEXEC));
        if (!stream.isOpen()) throwNotWritable(path, errno);
        fill(stream.number());
        if (!stream.close()) throwNotWritable(path, errno);
        return;
    }

    std::string beside = nameBeside(target);
    int number = ::open(beside.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    while (number < 0 && errno == EEXIST) {  // left by a crashed program of the same process number
        beside = nameBeside(target);
        number = ::open(beside.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    }
    if (number < 0) throwNotWritable(path, errno);
    Descriptor file(number);
    RemoveOnFailure cleanup{beside};
    if (exists && ::fchmod(file.number(), status.st_mode & 07777) != 0) throwNotWritable(path, errno);
    fill(file.number());
    if (::fsync(file.number()) != 0) throwNotWritable(path, errno);
    if (!file.close()) throwNotWritable(path, errno);
    if (::rename(beside.c_str(), target.c_str()) != 0) throwNotWritable(path, errno);
    cleanup.done = true;
}

void writeFile(const std::string& path, std::string_view content)
{
    writeFile(path, [content](const std::function<void(std::string_view)>& append) { append(content); });
}

}  // namespace lathelier
