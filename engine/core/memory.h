// How much memory there is for data.
#pragma once

#include <cstdint>

namespace lathelier {

/// Bytes that this process may still take: the least of what the machine has free, what its control group allows (v2)
/// and what the limit of its address space leaves. The largest number when the system tells none of them.
std::uint64_t freeMemory_bytes();

}  // namespace lathelier
