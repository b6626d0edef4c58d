#include "engine/sample/scan_ply.h"

#include <bit>
#include <cstdint>

namespace lathelier::sample {

std::string scanPly(const Scan& scan)
{
    std::string text = "ply\nformat binary_little_endian 1.0\ncomment unit mm\ncomment " + std::string(syntheticScan) +
                       "\nelement vertex " + std::to_string(scan.points_mm.size()) +
                       "\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
    const std::size_t header = text.size();
    text.resize(header + scan.points_mm.size() * 12);
    char* place = text.data() + header;
    for (const Eigen::Vector3d& p : scan.points_mm)
        for (int k = 0; k < 3; ++k) {
            const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(p[k]));
            for (int byte = 0; byte < 4; ++byte) *place++ = static_cast<char>(bits >> (8 * byte) & 0xff);
        }
    return text;
}

}  // namespace lathelier::sample
