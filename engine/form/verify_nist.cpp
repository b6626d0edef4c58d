#include <Eigen/Core>
#include <algorithm>
#include <charconv>
#include <filesystem>
#include <vector>

#include "engine/core/error.h"
#include "engine/form/circles.h"
#include "engine/form/verify_kinds.h"
#include "engine/io/file.h"
#include "engine/io/io_codes.h"

namespace lathelier {
namespace {

namespace fs = std::filesystem;

/// All numbers of a file, parted by white space. Error malformed.
std::vector<double> numbersOf(const fs::path& path, const Progress& progress)
{
    const FileBytes bytes(path.string(), progress);
    const std::string_view text = bytes.view();
    std::vector<double> numbers;
    for (const char *at = text.data(), *end = at + text.size(); at != end;) {
        if (std::string_view(" \t\r\n").find(*at) != std::string_view::npos) {
            ++at;
            continue;
        }
        double value = 0;
        const auto [next, error] = std::from_chars(at, end, value);
        if (error != std::errc())
            throw Error(errors::malformed, {{"path", path.string()},
                                            {"byte", static_cast<std::int64_t>(at - text.data())},
                                            {"found", std::string(at, std::min<std::ptrdiff_t>(end - at, 20))},
                                            {"expected", LT_TEXT("Engine", "a number")}});
        numbers.push_back(value);
        at = next;
    }
    return numbers;
}

/// `.ds`: count, then x y z; `.fit`: centre, normal of the plane, diameter. The circle lies in a coordinate plane.
void compareSet(const fs::path& data, const fs::path& answer, VerifyTally& tally, const Progress& progress)
{
    const std::vector<double> points = numbersOf(data, progress), fit = numbersOf(answer, progress);
    const bool whole =
        fit.size() == 7 && points.size() >= 10 && points[0] * 3 + 1 == static_cast<double>(points.size());
    if (!whole)
        throw Error(errors::malformed, {{"path", data.string()},
                                        {"found", static_cast<std::int64_t>(points.size())},
                                        {"expected", LT_TEXT("Engine", "a count and as many points")}});
    Eigen::Index across = 0;
    Eigen::Vector3d(fit[3], fit[4], fit[5]).cwiseAbs().maxCoeff(&across);
    const auto u = static_cast<std::size_t>((across + 1) % 3), v = static_cast<std::size_t>((across + 2) % 3);
    std::vector<Eigen::Vector2d> profile;
    for (std::size_t i = 1; i < points.size(); i += 3) profile.emplace_back(points[i + u], points[i + v]);
    const FittedCircle circle = fitLeastSquaresCircle(profile);
    tally.nextSet();
    tally.compare(2 * circle.radius_mm / fit[6], 1);
    const Eigen::Vector2d centre(fit[u], fit[v]);
    tally.take((circle.centre_mm - centre).norm() / std::max(centre.norm(), fit[6]));
}

}  // namespace

std::optional<VerifyKind> verifyNistCircles(std::string& directory, const Progress& progress)
{
    std::error_code none;
    if (directory.empty()) {
        for (const char* place : {"../shared/data/form/nist_circles", "shared/data/form/nist_circles"})
            if (fs::is_directory(place, none)) directory = place;
        if (directory.empty()) return std::nullopt;
    } else if (!fs::is_directory(directory, none)) {
        throw Error(errors::fileNotFound, {{"path", directory}});
    }
    std::vector<fs::path> sets;
    for (const auto& entry : fs::directory_iterator(directory, none))
        if (entry.path().extension() == ".ds") sets.push_back(entry.path());
    std::sort(sets.begin(), sets.end());
    VerifyTally tally("nist_circle", LT_TEXT("Engine", "NIST reference circles, least squares"), {}, 1e-9);
    for (const fs::path& set : sets) compareSet(set, fs::path(set).replace_extension(".fit"), tally, progress);
    return tally.done();
}

}  // namespace lathelier
