// Profiles with certified answers.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

namespace lathelier::form {

inline std::filesystem::path formData()
{
    return std::filesystem::path(LATHELIER_SOURCE_DIR "/tests/data/form");
}

/// Ten circles with known least-squares answers, laid out as NIST's: see tests/data/README.md.
inline std::filesystem::path nistLikeData()
{
    return std::filesystem::path(LATHELIER_SOURCE_DIR "/tests/data/nist_like");
}

/// The x,y columns of a practice profile, in mm.
inline std::vector<Eigen::Vector2d> readPoints(const std::string& name)
{
    std::ifstream file(formData() / (name + ".csv"));
    std::vector<Eigen::Vector2d> points;
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line[0] == '#' || line[0] == 'x') continue;
        std::istringstream cells(line);
        double x = 0, y = 0;
        char comma = 0;
        cells >> x >> comma >> y;
        points.emplace_back(x, y);
    }
    return points;
}

inline nlohmann::json readAnswers(const std::string& name)
{
    std::ifstream file(formData() / (name + ".json"));
    return nlohmann::json::parse(file).at("answers");
}

}  // namespace lathelier::form
