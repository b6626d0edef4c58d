// How much memory there is for data.
#pragma once

#include <cstdint>

namespace lathelier {

/// Bytes that this process may still allocate: the minimum of free memory, limit of the control group (v2) and limit of
/// the address space. The largest number when none is known.
std::uint64_t freeMemory_bytes();

}  // namespace lathelier
