// writeFile(): temporary file, then rename.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <set>
#include <thread>

#include "engine/core/error.h"
#include "engine/io/file.h"
#include "engine/io/file_system.h"
#include "engine/io/io_codes.h"
#include "engine/io/opened_files.h"

namespace lathelier::io {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t bufferSize = std::size_t{1} << 18;

[[noreturn]] void throwNotWritable(const std::string& path, int error)
{
    throw Error(errors::fileNotWritable, {{"path", path}, {"reason", systemReason(error)}});
}

/// Buffered writing.
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

/// Removes the temporary file unless the rename succeeded.
struct RemoveOnFailure {
    std::string path;
    bool done = false;
    ~RemoveOnFailure()
    {
        if (!done) ::unlink(path.c_str());
    }
};

/// Final target of a link, also when it does not exist yet.
std::string followLinks(const std::string& path)
{
    std::error_code failure;
    const fs::path target = fs::weakly_canonical(path, failure);
    return failure || target.empty() ? path : target.string();
}

constexpr std::string_view partHead = ".lathelier-";
constexpr std::string_view partTail = ".part";

std::string nameBeside(const std::string& path)
{
    static std::atomic<unsigned> counter{0};
    const std::string name = std::string(partHead) + std::to_string(::getpid()) + "-" + std::to_string(counter++);
    return (fs::path(path).parent_path() / (name + std::string(partTail))).string();
}

fs::path folderOf(const std::string& path)
{
    const fs::path folder = fs::path(path).parent_path();
    return folder.empty() ? fs::path(".") : folder;
}

/// Process number encoded in the name of a temporary file; 0: not one of ours.
pid_t ownerOf(const std::string& name)
{
    if (!name.starts_with(partHead) || !name.ends_with(partTail)) return 0;
    const char* const from = name.data() + partHead.size();
    const char* const to = name.data() + name.size() - partTail.size();
    long number = 0;
    const auto [end, problem] = std::from_chars(from, to, number);
    return problem == std::errc() && end != to && *end == '-' && number > 0 ? static_cast<pid_t>(number) : 0;
}

/// Removes temporary files of terminated processes from `folder`: once per folder, and only those unchanged for an
/// hour, since the process may run on another machine.
void sweep(const fs::path& folder)
{
    static std::mutex mutex;
    static std::set<std::string> swept;
    {
        const std::lock_guard lock(mutex);
        if (!swept.insert(folder.string()).second) return;
    }
    std::error_code problem;
    const auto old = fs::file_time_type::clock::now() - std::chrono::hours(1);
    for (fs::directory_iterator entry(folder, problem), end; !problem && entry != end; entry.increment(problem)) {
        const pid_t owner = ownerOf(entry->path().filename().string());
        if (owner == 0 || ::kill(owner, 0) == 0 || errno != ESRCH) continue;
        std::error_code unknown;
        if (entry->last_write_time(unknown) < old && !unknown) fs::remove_all(entry->path(), unknown);
    }
}

/// A rename is durable only after its folder is synchronised. Unsupported file systems are ignored.
void syncFolder(const fs::path& folder)
{
    const Descriptor descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (descriptor.isOpen()) ::fsync(descriptor.number());
}

/// Opens a device or pipe. A named pipe without a reader is asked again for a while, as its reader may be starting;
/// opened plainly it would wait for one without end.
int openStream(const std::string& target, bool is_pipe)
{
    constexpr int tries = 250;
    constexpr auto pause = std::chrono::milliseconds(20);
    if (!is_pipe) return ::open(target.c_str(), O_WRONLY | O_CLOEXEC);
    int number = -1;
    for (int i = 0; i < tries && number < 0; ++i) {
        number = ::open(target.c_str(), O_WRONLY | O_CLOEXEC | O_NONBLOCK);
        if (number < 0 && errno != ENXIO) return number;
        if (number < 0) std::this_thread::sleep_for(pause);
    }
    if (number >= 0 && ::fcntl(number, F_SETFL, O_WRONLY) != 0) {
        const int problem = errno;
        ::close(number);
        errno = problem;
        return -1;
    }
    if (number < 0) errno = ENXIO;
    return number;
}

}  // namespace

void writeFile(const std::string& path, const std::function<void(const Append& append)>& write)
{
    checkWrite();
    const std::string target = followLinks(path);
    struct stat status {};
    const bool exists = ::stat(target.c_str(), &status) == 0;
    if (target.empty()) throwNotWritable(path, ENOENT);
    if (exists && S_ISDIR(status.st_mode)) throwNotWritable(path, EISDIR);
    // A rename needs no permission on the replaced file; write-protected files are kept by this check.
    if (exists && ::access(target.c_str(), W_OK) != 0) throwNotWritable(path, errno);

    const auto fill = [&](int descriptor) {
        Output output(descriptor, path);
        write([&output](std::string_view chunk) { output.append(chunk); });
        output.flush();
    };
    if (exists && !S_ISREG(status.st_mode)) {
        Descriptor stream(openStream(target, S_ISFIFO(status.st_mode)));
        if (!stream.isOpen()) throwNotWritable(path, errno);
        fill(stream.number());
        if (!stream.close()) throwNotWritable(path, errno);
        return;
    }

    sweep(folderOf(target));
    std::string beside = nameBeside(target);
    int number = ::open(beside.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    while (number < 0 && errno == EEXIST) {  // left by a crashed process of the same number
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
    syncFolder(folderOf(target));
}

void writeFile(const std::string& path, std::string_view content)
{
    writeFile(path, [content](const Append& append) { append(content); });
}

PartFolder::PartFolder()
{
    std::error_code problem;
    const fs::path place = fs::temp_directory_path(problem);
    if (problem) throwNotWritable("TMPDIR", problem.value());
    sweep(place);
    int failure = 0;
    do {
        path_ = nameBeside((place / "folder").string());
        failure = ::mkdir(path_.c_str(), 0700) == 0 ? 0 : errno;
    } while (failure == EEXIST);
    if (failure != 0) throwNotWritable(path_, failure);
}

PartFolder::~PartFolder()
{
    std::error_code problem;
    fs::remove_all(path_, problem);
}

}  // namespace lathelier::io
