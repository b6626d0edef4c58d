#include "tests/app/cli/expectations.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>
#include <stdexcept>

namespace lathelier::golden {
namespace {

using Json = nlohmann::json;

/// The value at a dotted path, or nullptr.
const Json* find(const Json& json, const std::string& path)
{
    const Json* here = &json;
    for (std::size_t begin = 0; begin <= path.size();) {
        const std::size_t end = std::min(path.find('.', begin), path.size());
        const std::string step = path.substr(begin, end - begin);
        if (here->is_object() && here->contains(step))
            here = &(*here)[step];
        else if (here->is_array() && step.find_first_not_of("0123456789") == std::string::npos &&
                 std::stoul(step) < here->size())
            here = &(*here)[std::stoul(step)];
        else
            return nullptr;
        begin = end + 1;
    }
    return here;
}

std::string contained(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos ? "" : "not in “" + text.substr(0, 400) + "”";
}

std::string wholeFile(const std::string& path)
{
    std::ifstream stream(path, std::ios::binary);
    if (!stream) return {};
    return {std::istreambuf_iterator<char>(stream), {}};
}

Eigen::Isometry3d pose(const Json& rows)
{
    Eigen::Matrix4d matrix;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            matrix(row, column) = rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)].get<double>();
    return Eigen::Isometry3d(matrix);
}

/// The error of the transform as the practice data score it: at mid length, along and across the original's axis.
double alignmentError(const std::string& name, const Json& result, const std::string& data)
{
    const Json truth = Json::parse(wholeFile(data + "/sample/truth.json"));
    const Eigen::Isometry3d original = pose(truth["pose_original_part_to_scan"]);
    const Eigen::Isometry3d copy = pose(truth["pose_copy_part_to_scan"]);
    Eigen::Matrix4d matrix;
    for (int i = 0; i < 16; ++i)
        matrix(i / 4, i % 4) = result["transform_reference_from_copy"][static_cast<std::size_t>(i)].get<double>();
    const Eigen::Isometry3d found(matrix);
    const Eigen::Vector3d middle(0, 0, 91.5);
    const Eigen::Vector3d axis = original.linear().col(2);
    const Eigen::Vector3d error = found * (copy * middle) - original * middle;
    const double along = error.dot(axis);
    if (name == "axial_um") return 1000 * std::abs(along);
    if (name == "radial_um") return 1000 * (error - along * axis).norm();
    if (name == "axis_deg")
        return std::asin(std::min(1.0, (found.linear() * copy.linear().col(2)).cross(axis).norm())) * 180 /
               std::numbers::pi;
    throw std::runtime_error("no such error: " + name);
}

std::string checkZone(const std::vector<std::string>& words, const Json& result)
{
    const double from = std::stod(words.at(1));
    const double to = std::stod(words.at(2));
    double sum = 0;
    double points = 0;
    for (const Json& zone : result.at("zones"))
        if (zone["z_start_mm"].get<double>() >= from - 1e-9 && zone["z_end_mm"].get<double>() <= to + 1e-9) {
            sum += zone["mean_mm"].get<double>() * zone["points"].get<double>();
            points += zone["points"].get<double>();
        }
    if (points == 0) return "no zone lies there";
    const double mean_um = 1000 * sum / points;
    return std::abs(mean_um - std::stod(words.at(4))) <= std::stod(words.at(5)) ? ""
                                                                                : "found " + std::to_string(mean_um);
}

std::string checkLeft(const std::vector<std::string>& names, const std::string& folder)
{
    std::set<std::string> found;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        found.insert(entry.path().filename().string());
    std::string list;
    for (const std::string& name : found) list += " " + name;
    return found == std::set<std::string>(names.begin() + 1, names.end()) ? "" : "found" + list;
}

std::string checkValue(const std::string& relation, const std::string& wanted, const Json& value)
{
    const std::string found = "found " + value.dump().substr(0, 400);
    if (relation == "=") return value == Json::parse(wanted) ? "" : found;
    if (relation == "has") {
        const Json item = Json::parse(wanted);
        const auto fits = [&item](const Json& member) {
            return member == item || (member.is_object() && member.value("code", Json()) == item);
        };
        return value.is_array() && std::any_of(value.begin(), value.end(), fits) ? "" : found;
    }
    if (!value.is_number()) return found;
    const double number = value.get<double>();
    const std::vector<std::string> words = split(wanted);
    if (relation == "~") return std::abs(number - std::stod(words.at(0))) <= std::stod(words.at(1)) ? "" : found;
    if (relation == "<") return number < std::stod(wanted) ? "" : found;
    if (relation == ">") return number > std::stod(wanted) ? "" : found;
    throw std::runtime_error("no relation " + relation);
}

std::string checkJson(const std::vector<std::string>& words, const std::string& expectation, const Evidence& evidence)
{
    const Json json = Json::parse(evidence.outcome.standard_output);
    if (words[0] == "truth") {
        const double error = alignmentError(words.at(1), json, evidence.data_folder);
        return error < std::stod(words.at(3)) ? "" : "found " + std::to_string(error);
    }
    if (words[0] == "zone") return checkZone(words, json);
    const Json* value = find(json, words[0]);
    if (words.at(1) == "absent") return value ? "found " + value->dump() : "";
    if (!value) return "it is not there";
    if (words[1] == "exists") return "";
    const std::size_t wanted = expectation.find(" " + words[1] + " ");
    return checkValue(words[1], expectation.substr(wanted + words[1].size() + 2), *value);
}

}  // namespace

std::string check(const std::string& expectation, const Evidence& evidence)
{
    const std::vector<std::string> words = split(expectation);
    const std::size_t has = expectation.find(" has ");
    const std::string part = has == std::string::npos ? "" : expectation.substr(has + 5);
    if (words[0] == "stdout" || words[0] == "stderr") {
        const std::string& text =
            words[0] == "stdout" ? evidence.outcome.standard_output : evidence.outcome.standard_error;
        if (words.at(1) == "empty") return text.empty() ? "" : "found “" + text.substr(0, 400) + "”";
        return contained(text, part);
    }
    if (words[0] == "left") return checkLeft(words, evidence.out_folder);
    if (words[0] == "again") {
        Run run = evidence.line.run;
        run.words.insert(run.words.end(), words.begin() + 1, words.end());
        return evidence.again(run).standard_output == evidence.outcome.standard_output ? "" : "the output differs";
    }
    if (words.size() > 1 && words[1] == "has" && std::filesystem::exists(evidence.out_folder + "/" + words[0]))
        return contained(wholeFile(evidence.out_folder + "/" + words[0]), part);
    return checkJson(words, expectation, evidence);
}

}  // namespace lathelier::golden
