#include "engine/archive/sql/random_uuid.h"

#include <array>
#include <random>

namespace lathelier::archive::sql {

std::string randomUuid()
{
    std::random_device source;
    std::array<unsigned char, 16> bytes{};
    for (unsigned char& byte : bytes) byte = static_cast<unsigned char>(source() & 0xFFU);
    bytes[6] = static_cast<unsigned char>((bytes[6] & 0x0FU) | 0x40U);
    bytes[8] = static_cast<unsigned char>((bytes[8] & 0x3FU) | 0x80U);
    constexpr const char* digits = "0123456789abcdef";
    std::string uuid;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        if (i == 4 || i == 6 || i == 8 || i == 10) uuid += '-';
        uuid += digits[bytes[i] / 16];
        uuid += digits[bytes[i] % 16];
    }
    return uuid;
}

}  // namespace lathelier::archive::sql
