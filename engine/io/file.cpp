#include "engine/io/file.h"

#include <fcntl.h>
#include <openssl/evp.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/stat.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <vector>

#include "engine/core/error.h"
#include "engine/io/file_system.h"
#include "engine/io/io_codes.h"

namespace lathelier {
namespace {

constexpr std::size_t pipeLimit = std::size_t{4} << 30;
constexpr std::size_t readStep = std::size_t{1} << 20;
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

/// Reads to the end of something whose length is not known beforehand. A non-blocking pipe tells "nobody writes"
/// (read gives 0) from "the writer is still busy" (EAGAIN): only the first may time out.
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
            // A writer that came and went without a byte hangs up.
            if ((wait.revents & POLLHUP) != 0 && (wait.revents & POLLIN) == 0) return content;
            if (std::chrono::steady_clock::now() - start > longestWaitForWriter)
                throwNotReadable(path, LT_TEXT("Engine", "nobody writes into this pipe"));
        }
    }
}

}  // namespace

struct FileBytes::Content {
    std::string text;
    void* mapped = nullptr;
    std::size_t mappedSize = 0;

    ~Content()
    {
        if (mapped) ::munmap(mapped, mappedSize);
    }
};

FileBytes::FileBytes(const std::string& path, const Progress& progress) : content_(std::make_unique<Content>())
{
    if (path.find('\0') != std::string::npos) throw Error(errors::fileNotFound, {{"path", path}});
    // Non-blocking: opening a pipe that nobody writes into would never return.
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
    struct stat status {};
    if (!file.isOpen()) {
        const int reason = errno;
        if (reason == ENOENT || reason == ENOTDIR) throw Error(errors::fileNotFound, {{"path", path}});
        if (::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISFIFO(status.st_mode))
            throw Error(errors::notAFile, {{"path", path}, {"found", kindOf(status.st_mode)}});
        throwNotReadable(path, systemReason(reason));
    }
    if (::fstat(file.number(), &status) != 0) throwNotReadable(path, systemReason(errno));
    const bool isPipe = S_ISFIFO(status.st_mode);
    if (!isPipe && !S_ISREG(status.st_mode))
        throw Error(errors::notAFile, {{"path", path}, {"found", kindOf(status.st_mode)}});
    if (!isPipe && status.st_size > 0) {
        const auto size = static_cast<std::size_t>(status.st_size);
        void* mapped = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file.number(), 0);
        if (mapped != MAP_FAILED) {
            content_->mapped = mapped;
            content_->mappedSize = size;
            return;
        }
    }
    content_->text = readToEnd(file.number(), isPipe, path, progress);
}

FileBytes::~FileBytes() = default;
FileBytes::FileBytes(FileBytes&&) noexcept = default;

std::string_view FileBytes::view() const
{
    if (content_->mapped) return {static_cast<const char*>(content_->mapped), content_->mappedSize};
    return content_->text;
}

std::string sha256(std::string_view bytes, const Progress& progress)
{
    constexpr std::size_t chunk = 4 << 20;  // a few milliseconds each
    const std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context(EVP_MD_CTX_new(), &EVP_MD_CTX_free);
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned int length = 0;
    bool sound = context && EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr) == 1;
    for (std::size_t at = 0; sound && at < bytes.size(); at += chunk) {
        progress.check();
        const std::string_view part = bytes.substr(at, chunk);
        sound = EVP_DigestUpdate(context.get(), part.data(), part.size()) == 1;
    }
    if (!sound || EVP_DigestFinal_ex(context.get(), digest.data(), &length) != 1)
        throw std::bad_alloc();  // SHA-256 itself cannot fail; only its context can be missing
    constexpr char digits[] = "0123456789abcdef";
    std::string result;
    for (unsigned int i = 0; i < length; ++i) {
        result += digits[digest[i] >> 4];
        result += digits[digest[i] & 15];
    }
    return result;
}

}  // namespace lathelier
