// Names that nobody else gives.
// Source: RFC 9562, UUID version 4.
#pragma once

#include <string>

namespace lathelier::archive::sql {

/// "f81d4fae-7dec-41d0-a765-00a0c91e6bf6", of 122 random bits of the system.
std::string randomUuid();

}  // namespace lathelier::archive::sql
