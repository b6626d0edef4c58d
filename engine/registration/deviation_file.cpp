#include "engine/registration/deviation_file.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>

#include "engine/core/parallel.h"
#include "engine/io/file.h"

namespace lathelier {
namespace {

constexpr std::size_t kBlock = 65536;  // rows made at once, on all cores
constexpr std::size_t kGrain = 8192;

using RowWriter = void (*)(std::string& out, const Eigen::Vector3d& p, float deviation, bool used);

void csvRow(std::string& out, const Eigen::Vector3d& p, float deviation, bool used)
{
    char buffer[128];
    char* place = buffer;
    for (int k = 0; k < 3; ++k) {
        place = std::to_chars(place, buffer + sizeof buffer, p[k]).ptr;
        *place++ = ',';
    }
    if (!std::isnan(deviation)) place = std::to_chars(place, buffer + sizeof buffer, deviation).ptr;
    *place++ = ',';
    *place++ = used ? '1' : '0';
    *place++ = '\n';
    out.append(buffer, place);
}

template <class Bits>
void appendLittle(std::string& out, Bits bits)
{
    for (std::size_t k = 0; k < sizeof bits; ++k) out.push_back(static_cast<char>(bits >> (8 * k) & 0xff));
}

void plyRow(std::string& out, const Eigen::Vector3d& p, float deviation, bool used)
{
    for (int k = 0; k < 3; ++k) appendLittle(out, std::bit_cast<std::uint64_t>(p[k]));
    appendLittle(out, std::bit_cast<std::uint32_t>(deviation));
    out.push_back(used ? 1 : 0);
}

}  // namespace

void writeDeviations(const std::string& path, const Scan& copy, const CompareResult& result, const Progress& progress)
{
    std::string extension = path.substr(std::min(path.size(), path.find_last_of("./") + 1));
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    const std::size_t count = copy.points_mm.size();
    std::string header;
    RowWriter row = nullptr;
    if (extension == "csv") {
        header = "x_mm,y_mm,z_mm,deviation_mm,used\n";
        row = csvRow;
    } else if (extension == "ply") {
        header = "ply\nformat binary_little_endian 1.0\ncomment unit mm\nelement vertex " + std::to_string(count) +
                 "\nproperty double x_mm\nproperty double y_mm\nproperty double z_mm\nproperty float deviation_mm\n"
                 "property uchar used\nend_header\n";
        row = plyRow;
    } else {
        throw Error(ErrorCode::FormatUnknown, {{"path", path}, {"expected", std::string(".csv, .ply")}});
    }
    writeFile(path, [&](const std::function<void(std::string_view)>& append) {
        append(header);
        for (std::size_t block = 0; block < count; block += kBlock) {
            progress.report(static_cast<double>(block) / static_cast<double>(count));
            const std::size_t rows = std::min(kBlock, count - block);
            std::vector<std::string> parts((rows + kGrain - 1) / kGrain);
            parallelFor(rows, kGrain, progress, [&](std::size_t begin, std::size_t end) {
                std::string& out = parts[begin / kGrain];
                out.reserve((end - begin) * 80);
                for (std::size_t i = block + begin; i < block + end; ++i)
                    row(out, result.alignment.reference_T_copy * copy.points_mm[i], result.deviation_mm[i],
                        result.used[i] != 0);
            });
            for (const std::string& part : parts) append(part);
        }
    });
}

}  // namespace lathelier
