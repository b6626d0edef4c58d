#include "engine/io/file.h"

#include <fcntl.h>
#include <openssl/evp.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <new>
#include <thread>
#include <utility>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/memory.h"
#include "engine/io/file_system.h"
#include "engine/io/io_codes.h"
#include "engine/io/opened_files.h"

namespace lathelier::io {
namespace {

constexpr std::size_t pipeLimit = std::size_t{4} << 30;
constexpr std::size_t readStep = std::size_t{1} << 20;
constexpr auto writersTurn = std::chrono::milliseconds(30);
constexpr auto longestWaitForWriter = std::chrono::seconds(5);

[[noreturn]] void throwNotReadable(const std::string& path, Value reason)
{
    throw Error(errors::fileNotReadable, {{"path", path}, {"reason", std::move(reason)}});
}

Text kindOf(mode_t mode)
{
    if (S_ISDIR(mode)) return LT_TEXT("Engine", "a folder");
    if (S_ISSOCK(mode)) return LT_TEXT("Engine", "a socket");
    return LT_TEXT("Engine", "a device");
}

bool isSameTime(const timespec& a, const timespec& b)
{
    return a.tv_sec == b.tv_sec && a.tv_nsec == b.tv_nsec;
}

/// A regular file, opened for sequential reading.
class OpenFile {
public:
    /// Errors: fileNotFound, notAFile, fileNotReadable. A pipe is accepted only where allowed.
    OpenFile(const std::string& path, bool pipesToo) : path_(path), file_(opened(path))
    {
        if (!file_.isOpen()) refuse(errno);
        if (::fstat(number(), &status_) != 0) throwNotReadable(path_, systemReason(errno));
        if (!S_ISREG(status_.st_mode) && !(pipesToo && isPipe()))
            throw Error(errors::notAFile, {{"path", path_}, {"found", kindOf(status_.st_mode)}});
        noteOpened(path_, status_);
        waitForNewTick();
    }

    int number() const { return file_.number(); }
    bool isPipe() const { return S_ISFIFO(status_.st_mode); }
    std::size_t size() const { return static_cast<std::size_t>(std::max<off_t>(status_.st_size, 0)); }

    /// Reads up to `count` bytes at the current position; fewer only at the end.
    std::size_t read(char* to, std::size_t count)
    {
        std::size_t done = 0;
        while (done < count) {
            const ssize_t step = ::read(number(), to + done, count - done);
            if (step < 0 && errno == EINTR) continue;
            if (step < 0) throwNotReadable(path_, systemReason(errno));
            if (step == 0) break;
            done += static_cast<std::size_t>(step);
        }
        return done;
    }

    /// Error fileChanged when the file was written since it was opened.
    void checkUnchanged() const
    {
        struct stat now {};
        if (::fstat(number(), &now) != 0) throwNotReadable(path_, systemReason(errno));
        if (now.st_size != status_.st_size || !isSameTime(now.st_mtim, status_.st_mtim) ||
            !isSameTime(now.st_ctim, status_.st_ctim))
            throwChanged();
    }

    /// Whether a write that began before the file was opened may still be in progress: the modification time is that of
    /// its start.
    bool mayBeWritten() const
    {
        constexpr std::int64_t longestWrite_s = 2;
        timespec now{};
        return ::clock_gettime(CLOCK_REALTIME, &now) != 0 ||
               std::abs(static_cast<std::int64_t>(now.tv_sec) - status_.st_mtim.tv_sec) <= longestWrite_s;
    }

    void rewind() const { ::lseek(number(), 0, SEEK_SET); }

    [[noreturn]] void throwChanged() const { throw Error(errors::fileChanged, {{"path", path_}}); }

private:
    static Descriptor opened(const std::string& path)
    {
        if (path.find('\0') != std::string::npos) throw Error(errors::fileNotFound, {{"path", path}});
        // Non-blocking: opening a pipe that nobody writes into would never return.
        return Descriptor(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
    }

    [[noreturn]] void refuse(int reason) const
    {
        struct stat status {};
        if (reason == ENOENT || reason == ENOTDIR) throw Error(errors::fileNotFound, {{"path", path_}});
        if (::stat(path_.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISFIFO(status.st_mode))
            throw Error(errors::notAFile, {{"path", path_}, {"found", kindOf(status.st_mode)}});
        throwNotReadable(path_, systemReason(reason));
    }

    /// File times have the resolution of the kernel's coarse clock. A change within the same tick would not be
    /// detected, so reading starts in the next tick: at most 10 ms later, and only right after a change.
    void waitForNewTick() const
    {
        for (int tries = 0; tries < 12; ++tries) {
            timespec now{};
            if (::clock_gettime(CLOCK_REALTIME_COARSE, &now) != 0 || !isSameTime(now, status_.st_mtim)) return;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }

    const std::string& path_;
    Descriptor file_;
    struct stat status_ {};
};

/// Reads the file once more. Error fileChanged when the content differs from the first reading.
void compare(OpenFile& file, std::string_view before, const Progress& progress)
{
    file.rewind();
    std::string step(readStep, '\0');
    for (std::size_t at = 0; at < before.size(); at += readStep) {
        progress.check();
        const std::string_view expected = before.substr(at, readStep);
        if (file.read(step.data(), expected.size()) != expected.size()) file.throwChanged();
        if (expected != std::string_view(step).substr(0, expected.size())) file.throwChanged();
    }
}

void refuseTooLarge(const std::string& path, std::uint64_t size)
{
    constexpr std::uint64_t mebibyte = std::uint64_t{1} << 20;
    const std::uint64_t maximum = largestFile_bytes();
    if (size > maximum)
        throw Error(errors::fileTooLarge, {{"path", path},
                                           {"found_MiB", static_cast<std::int64_t>(size / mebibyte)},
                                           {"maximum_MiB", static_cast<std::int64_t>(maximum / mebibyte)}});
}

/// Reads to the end of something whose length is not known beforehand. On a non-blocking pipe read returns 0 without a
/// writer and EAGAIN while a writer exists: only the first may time out.
std::string readToEnd(int descriptor, bool isPipe, const std::string& path, const Progress& progress)
{
    std::string content;
    bool writerSeen = !isPipe;
    const auto start = std::chrono::steady_clock::now();
    std::vector<char> step(readStep);
    for (;;) {
        progress.check();
        const ssize_t count = ::read(descriptor, step.data(), step.size());
        if (count > 0) {
            if (content.size() + static_cast<std::size_t>(count) > pipeLimit)
                throwNotReadable(path, LT_TEXT("Engine", "the pipe delivers more than 4 GiB"));
            content.append(step.data(), static_cast<std::size_t>(count));
            writerSeen = true;
            continue;
        }
        if (count < 0 && errno == EINTR) continue;
        if (count < 0 && errno != EAGAIN) throwNotReadable(path, systemReason(errno));
        if (count == 0 && writerSeen) return content;
        if (count < 0) writerSeen = true;
        pollfd wait{descriptor, POLLIN, 0};
        ::poll(&wait, 1, 50);
        if (!writerSeen) {
            // A writer that closed without writing is reported as hang-up.
            if ((wait.revents & POLLHUP) != 0 && (wait.revents & POLLIN) == 0) return content;
            if (std::chrono::steady_clock::now() - start > longestWaitForWriter)
                throwNotReadable(path, LT_TEXT("Engine", "nobody writes into this pipe"));
        }
    }
}

}  // namespace

std::uint64_t largestFile_bytes()
{
    return freeMemory_bytes() / 4 * 3;
}

struct FileBytes::Content {
    std::string text;      ///< content of a pipe
    char* room = nullptr;  ///< content of a file: own memory pages
    std::size_t size = 0;

    void allocate(std::size_t bytes)
    {
        void* pages = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        if (pages == MAP_FAILED) throw std::bad_alloc();
        ::madvise(pages, bytes, MADV_HUGEPAGE);  // fewer page faults; optional
        room = static_cast<char*>(pages);
        size = bytes;
    }

    ~Content()
    {
        if (room) ::munmap(room, size);
    }
};

FileBytes::FileBytes(const std::string& path, const Progress& progress) : content_(std::make_unique<Content>())
{
    OpenFile file(path, true);
    if (file.isPipe() || file.size() == 0) {  // files of /proc and /sys report a size of 0
        content_->text = readToEnd(file.number(), file.isPipe(), path, progress);
    } else {
        refuseTooLarge(path, file.size());
        content_->allocate(file.size());
        for (std::size_t at = 0; at < content_->size; at += readStep) {
            progress.check();
            const std::size_t count = std::min(readStep, content_->size - at);
            if (file.read(content_->room + at, count) != count) file.throwChanged();
        }
        if (file.mayBeWritten()) {
            // Delay for a writer that is preempted during its write.
            std::this_thread::sleep_for(writersTurn);
            compare(file, view(), progress);
        }
    }
    if (!file.isPipe()) file.checkUnchanged();
}

FileBytes::~FileBytes() = default;
FileBytes::FileBytes(FileBytes&&) noexcept = default;

std::string_view FileBytes::view() const
{
    if (content_->room) return {content_->room, content_->size};
    return content_->text;
}

void FileBytes::release(std::size_t count)
{
    const auto page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
    const std::size_t whole = std::min(count, content_->size) / page * page;
    if (content_->room && whole > 0) ::madvise(content_->room, whole, MADV_DONTNEED);
}

std::string fileHead(const std::string& path, std::size_t count)
{
    OpenFile file(path, false);
    std::string head(count, '\0');
    head.resize(file.read(head.data(), count));
    return head;
}

std::string fileStamp(const std::string& path)
{
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) return "missing";
    const auto time = [](const timespec& at) { return std::to_string(at.tv_sec) + "." + std::to_string(at.tv_nsec); };
    return std::to_string(status.st_dev) + ":" + std::to_string(status.st_ino) + ":" + std::to_string(status.st_size) +
           "@" + time(status.st_mtim) + "," + time(status.st_ctim);
}

namespace {

/// Incremental SHA-256.
class Digest {
public:
    Digest() : context_(EVP_MD_CTX_new(), &EVP_MD_CTX_free)
    {
        require(context_ && EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr) == 1);
    }

    void add(std::string_view part) { require(EVP_DigestUpdate(context_.get(), part.data(), part.size()) == 1); }

    std::string hexadecimal()
    {
        std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
        unsigned int length = 0;
        require(EVP_DigestFinal_ex(context_.get(), digest.data(), &length) == 1);
        constexpr char digits[] = "0123456789abcdef";
        std::string result;
        for (unsigned int i = 0; i < length; ++i) {
            result += digits[digest[i] >> 4];
            result += digits[digest[i] & 15];
        }
        return result;
    }

private:
    static void require(bool sound)
    {
        if (!sound) throw std::bad_alloc();  // only the allocation of the context can fail
    }

    std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context_;
};

constexpr std::size_t digestStep = std::size_t{4} << 20;  ///< bytes per progress check, a few milliseconds each

}  // namespace

std::string sha256(std::string_view bytes, const Progress& progress, const std::function<void(std::size_t)>& passed)
{
    Digest digest;
    for (std::size_t at = 0; at < bytes.size(); at += digestStep) {
        progress.check();
        digest.add(bytes.substr(at, digestStep));
        if (passed) passed(std::min(at + digestStep, bytes.size()));
    }
    return digest.hexadecimal();
}

std::string fileSha256(const std::string& path, const Progress& progress)
{
    OpenFile file(path, false);
    std::vector<char> step(digestStep);
    const auto size = static_cast<double>(std::max<std::size_t>(file.size(), 1));
    const auto pass = [&](const Progress& own) {
        Digest digest;
        for (std::size_t at = 0;; at += step.size()) {
            own.report(std::min(1.0, static_cast<double>(at) / size));
            const std::size_t count = file.read(step.data(), step.size());
            digest.add({step.data(), count});
            if (count < step.size()) return digest.hexadecimal();
        }
    };
    const bool twice = file.mayBeWritten();
    std::string first = pass(progress.part(0, twice ? 0.5 : 1));
    if (twice) {
        file.rewind();
        if (pass(progress.part(0.5, 1)) != first) file.throwChanged();
    }
    file.checkUnchanged();
    return first;
}

}  // namespace lathelier::io
