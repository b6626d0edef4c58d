// What every reader's fuzzer does: read, and check what a caller relies on.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string_view>

#include "engine/core/texts.h"
#include "engine/io/cloud/raw_scan.h"
#include "engine/io/facts_json.h"
#include "engine/io/io_codes.h"

namespace lathelier::fuzz {

inline void require(bool condition)
{
    if (!condition) std::abort();
}

inline void checkScan(const io::ScanFile& file)
{
    const Scan& scan = file.scan;
    require(!scan.points_mm.empty());
    for (const Eigen::Vector3d& point : scan.points_mm)
        require(point.allFinite() && point.cwiseAbs().maxCoeff() <= io::largestCoordinate_mm * 1.000001);
    require(scan.normals.empty() || scan.normals.size() == scan.points_mm.size());
    for (const Eigen::Vector3f& normal : scan.normals) require(std::abs(normal.norm() - 1) < 1e-3F);
    for (const auto& triangle : scan.triangles)
        for (const std::uint32_t corner : triangle) require(corner < scan.points_mm.size());
    require(file.facts.skipped.size() <= 100);
    require(!toJson(file.facts).dump().empty());  // throws when a text is no UTF-8
    for (const Note& note : file.notes) require(!text(note).empty());
}

/// Runs `read`; an Error is a good answer as long as it can be shown and names a place.
template <class Read>
void check(Read read)
{
    try {
        checkScan(read());
    } catch (const Error& error) {
        require(!toJson(error).dump().empty());
        const Values& values = error.values();
        const bool placed = find(values, "line") || find(values, "byte");
        const bool wholeFile = error.code() == errors::fileEmpty || error.code() == errors::noPoints ||
                               error.code() == errors::unitUnknown;
        require(placed || wholeFile);
    }
}

/// The first byte chooses the options, the rest is the file.
inline io::ImportOptions takeOptions(std::string_view& bytes)
{
    io::ImportOptions options;
    if (bytes.empty()) return options;
    const auto choice = static_cast<unsigned char>(bytes.front());
    bytes.remove_prefix(1);
    options.decimal = static_cast<io::Decimal>(choice % 3);
    options.unit = choice % 2 == 0 ? io::LengthUnit::Millimetre : io::LengthUnit::Auto;
    options.delimiter = static_cast<io::Delimiter>(choice / 8 % 6);
    options.encoding = static_cast<io::Encoding>(choice / 64 % 5);
    return options;
}

inline std::string_view viewOf(const std::uint8_t* data, std::size_t size)
{
    return {reinterpret_cast<const char*>(data), size};
}

/// One reader alone, whatever the bytes look like.
inline void checkReader(io::RawScan (*reader)(const io::ScanSource&), std::string_view bytes, bool isText)
{
    io::ImportOptions options;
    options.unit = io::LengthUnit::Millimetre;
    const Progress progress;
    check([&] {
        const io::ScanSource source{bytes, isText ? bytes : std::string_view(), "utf-8", options, progress};
        return io::finishScan(reader(source), "fuzz", options, progress);
    });
}

}  // namespace lathelier::fuzz
