#include "engine/registration/deviation_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>

#include "engine/core/core_codes.h"
#include "engine/core/error.h"
#include "engine/core/parallel.h"
#include "engine/io/file.h"

namespace lathelier::registration {
namespace {

static_assert(std::endian::native == std::endian::little, "rows are written as they lie in memory");

constexpr std::size_t chunkRows = 8192;
constexpr std::size_t chunksAtOnce = 16;  ///< formatted on all cores, then written in order

bool endsWith(const std::string& path, const std::string& extension)
{
    return path.size() >= extension.size() && std::equal(extension.rbegin(), extension.rend(), path.rbegin(),
                                                         [](char a, char b) { return a == (b | 0x20); });
}

void appendText(std::string& out, const Eigen::Vector3d& point_mm, float deviation_mm, bool used)
{
    std::array<char, 128> row{};
    char* const end = row.data() + row.size();
    char* place = row.data();
    for (int axis = 0; axis < 3; ++axis) {
        place = std::to_chars(place, end, point_mm[axis]).ptr;
        *place++ = ',';
    }
    if (std::isfinite(deviation_mm)) place = std::to_chars(place, end, deviation_mm).ptr;
    *place++ = ',';
    *place++ = used ? '1' : '0';
    *place++ = '\n';
    out.append(row.data(), place);
}

template <class T>
void appendBytes(std::string& out, T value)
{
    char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    out.append(bytes, sizeof(T));
}

void appendBinary(std::string& out, const Eigen::Vector3d& point_mm, float deviation_mm, bool used)
{
    for (int axis = 0; axis < 3; ++axis) appendBytes(out, point_mm[axis]);
    appendBytes(out, deviation_mm);
    out += static_cast<char>(used);
}

std::string header(bool binary, std::size_t rows)
{
    if (!binary) return "x_mm,y_mm,z_mm,deviation_mm,used\n";
    return fmt::format(
        "ply\nformat binary_little_endian 1.0\ncomment Lathelier: signed deviation of the copy, in the reference's "
        "frame\n"
        "comment unit mm\nelement vertex {}\nproperty double x_mm\nproperty double y_mm\nproperty double z_mm\n"
        "property float deviation_mm\nproperty uchar used\nend_header\n",
        rows);
}

}  // namespace

bool isDeviationFile(const std::string& path)
{
    return endsWith(path, ".ply") || endsWith(path, ".csv");
}

void writeDeviations(const std::string& path, const Scan& copy, const CompareResult& result, const Progress& progress)
{
    if (!isDeviationFile(path))
        throw Error(
            errors::valueNotUnderstood,
            {{"parameter", "deviations"}, {"found", path}, {"expected", LT_TEXT("Engine", "a name in .ply or .csv")}});
    const bool binary = endsWith(path, ".ply");
    const std::size_t rows = copy.points_mm.size();
    const auto rowsOf = [&](std::size_t begin, std::size_t end) {
        std::string out;
        for (std::size_t i = begin; i < end; ++i) {
            const Eigen::Vector3d point_mm = result.alignment.reference_T_copy * copy.points_mm[i];
            (binary ? appendBinary : appendText)(out, point_mm, result.deviation_mm[i], result.used[i] != 0);
        }
        return out;
    };
    io::writeFile(path, [&](const std::function<void(std::string_view)>& append) {
        append(header(binary, rows));
        for (std::size_t begin = 0; begin < rows; begin += chunkRows * chunksAtOnce) {
            const std::size_t count = std::min(rows - begin, chunkRows * chunksAtOnce);
            std::vector<std::string> chunks((count + chunkRows - 1) / chunkRows);
            parallelFor(count, chunkRows, progress, [&](std::size_t from, std::size_t to) {
                chunks[from / chunkRows] = rowsOf(begin + from, begin + to);
            });
            for (const std::string& chunk : chunks) append(chunk);
            progress.report(static_cast<double>(begin + count) / static_cast<double>(rows));
        }
    });
}

}  // namespace lathelier::registration
