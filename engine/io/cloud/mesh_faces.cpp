#include "engine/io/cloud/mesh_faces.h"

#include "engine/io/io_codes.h"

namespace lathelier::io {

void addPolygon(Scan& scan, std::span<const std::int64_t> corners, const Values& place)
{
    for (const std::int64_t corner : corners)
        if (corner < 0 || static_cast<std::uint64_t>(corner) >= scan.points_mm.size()) {
            Values values = place;
            set(values, "found", corner);
            set(values, "expected", LT_TEXT("Engine", "the index of a vertex"));
            throw Error(errors::malformed, values);
        }
    const auto index = [&corners](std::size_t i) { return static_cast<std::uint32_t>(corners[i]); };
    for (std::size_t i = 2; i < corners.size(); ++i) scan.triangles.push_back({index(0), index(i - 1), index(i)});
}

}  // namespace lathelier::io
