#include <Eigen/Core>
#include <algorithm>
#include <charconv>
#include <filesystem>
#include <vector>

#include "engine/core/error.h"
#include "engine/form/circle/circles.h"
#include "engine/form/verify/form_verification.h"
#include "engine/io/file.h"
#include "engine/io/file_system.h"
#include "engine/io/io_codes.h"

namespace lathelier::form {
namespace {

namespace fs = std::filesystem;

/// All numbers of a file, parted by white space. Error malformed.
std::vector<double> numbersOf(const fs::path& path, const Progress& progress)
{
    const io::FileBytes bytes(path.string(), progress);
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
            throw Error(errors::malformed,
                        {{"path", path.string()},
                         {"byte", static_cast<std::int64_t>(at - text.data())},
                         {"found", std::string(at, std::min(end, at + std::min<std::ptrdiff_t>(end - at, 20)))},
                         {"expected", LT_TEXT("Engine", "a number")}});
        numbers.push_back(value);
        at = next;
    }
    return numbers;
}

[[noreturn]] void throwNoCircles(const fs::path& path, Value found)
{
    throw Error(errors::referenceDataMissing,
                {{"path", path.string()},
                 {"found", std::move(found)},
                 {"expected", LT_TEXT("Engine", "circles as .ds (a count and points) and .fit (7 numbers)")}});
}

/// The points of a set in the plane of its circle. NIST's cylinders have answers of 7 numbers as well, and lines,
/// planes, spheres and cones others: such files are not circle data.
std::vector<Eigen::Vector2d> circleIn(const std::vector<double>& points, const std::vector<double>& fit, std::size_t u,
                                      std::size_t v, std::size_t across, const fs::path& data)
{
    std::vector<Eigen::Vector2d> profile;
    for (std::size_t i = 1; i < points.size(); i += 3) {
        if (std::abs(points[i + across] - fit[across]) > 1e-6 * std::abs(fit[6]))
            throwNoCircles(data, LT_TEXT("Engine", "points out of the plane of a circle"));
        profile.emplace_back(points[i + u], points[i + v]);
    }
    return profile;
}

/// `.ds`: count, then x y z; `.fit`: centre, normal of the plane, diameter. The circle lies in a coordinate plane.
void compareSet(const fs::path& data, const fs::path& answer, VerifyTally& tally, const Progress& progress)
{
    const std::vector<double> points = numbersOf(data, progress), fit = numbersOf(answer, progress);
    if (fit.size() != 7) throwNoCircles(answer, static_cast<std::int64_t>(fit.size()));
    if (points.size() < 10 || points[0] * 3 + 1 != static_cast<double>(points.size()))
        throw Error(errors::malformed, {{"path", data.string()},
                                        {"byte", std::int64_t{0}},
                                        {"found", static_cast<std::int64_t>(points.size())},
                                        {"expected", LT_TEXT("Engine", "a count and as many points")}});
    Eigen::Index largest = 0;
    const double length = Eigen::Vector3d(fit[3], fit[4], fit[5]).cwiseAbs().maxCoeff(&largest);
    if (!(std::abs(length - 1) < 1e-9) || !(fit[6] > 0))
        throwNoCircles(answer, LT_TEXT("Engine", "a direction across no coordinate plane"));
    const auto across = static_cast<std::size_t>(largest);
    const std::size_t u = (across + 1) % 3, v = (across + 2) % 3;
    const FittedCircle circle = fitLeastSquaresCircle(circleIn(points, fit, u, v, across, data));
    tally.nextSet();
    tally.compare(2 * circle.radius_mm / fit[6], 1);
    const Eigen::Vector2d centre(fit[u], fit[v]);
    tally.take((circle.centre_mm - centre).norm() / std::max(centre.norm(), fit[6]));
}

}  // namespace

VerifyKind verifyNistCircles(const std::string& directory, const Progress& progress)
{
    std::error_code problem;
    const fs::file_status status = fs::status(directory, problem);
    if (!fs::exists(status)) throw Error(errors::fileNotFound, {{"path", directory}});
    if (!fs::is_directory(status)) throwNoCircles(directory, LT_TEXT("Engine", "a file in place of a folder"));
    std::vector<fs::path> sets;
    for (fs::directory_iterator entry(directory, problem), end; !problem && entry != end; entry.increment(problem))
        if (entry->path().extension() == ".ds") sets.push_back(entry->path());
    if (problem)
        throw Error(errors::fileNotReadable, {{"path", directory}, {"reason", io::systemReason(problem.value())}});
    if (sets.empty()) throwNoCircles(directory, LT_TEXT("Engine", "no file in .ds"));
    std::sort(sets.begin(), sets.end());
    VerifyTally tally("nist_circle", LT_TEXT("Engine", "NIST reference circles, least squares"), {}, 1e-9);
    for (const fs::path& set : sets) {
        try {
            compareSet(set, fs::path(set).replace_extension(".fit"), tally, progress);
        } catch (Error& error) {
            error.with("path", set.string());  // points on a line, for instance
            throw;
        }
    }
    return tally.done();
}

}  // namespace lathelier::form
