// Large blocks of memory lie in large pages: the first touch of every small page would cost a tenth of all work with
// millions of points.
#include <sys/mman.h>

#include <cstdint>
#include <cstdlib>
#include <new>

namespace {

constexpr std::size_t largePage_bytes = std::size_t{1} << 21;
constexpr std::size_t large_bytes = 2 * largePage_bytes;

void useLargePages(void* block, std::size_t bytes)
{
    const auto begin = reinterpret_cast<std::uintptr_t>(block);
    const std::uintptr_t first = (begin + largePage_bytes - 1) / largePage_bytes * largePage_bytes;
    const std::uintptr_t last = (begin + bytes) / largePage_bytes * largePage_bytes;
    // Only whole large pages within the block; where they are not known, small ones do.
    if (first < last) ::madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
}

}  // namespace

void* operator new(std::size_t bytes)
{
    for (;;) {
        if (void* const block = std::malloc(bytes > 0 ? bytes : 1)) {
            if (bytes >= large_bytes) useLargePages(block, bytes);
            return block;
        }
        const std::new_handler handler = std::get_new_handler();
        if (!handler) throw std::bad_alloc();
        handler();
    }
}

void operator delete(void* block) noexcept
{
    std::free(block);
}

void operator delete(void* block, std::size_t /*bytes*/) noexcept
{
    std::free(block);
}
