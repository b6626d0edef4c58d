#include "engine/core/profile_item.h"

#include <algorithm>
#include <cmath>

namespace lathelier {

Values toValues(const Profile& profile)
{
    std::vector<double> x_mm, y_mm;
    for (const Eigen::Vector2d& point : profile.points_mm) {
        x_mm.push_back(point.x());
        y_mm.push_back(point.y());
    }
    return {{"name", profile.name}, {"x_mm", std::move(x_mm)}, {"y_mm", std::move(y_mm)}};
}

std::optional<Profile> profileOf(const Values& values)
{
    const auto numbers = [&values](const char* name) -> const std::vector<double>* {
        const Value* value = find(values, name);
        return value ? std::get_if<std::vector<double>>(value) : nullptr;
    };
    const std::vector<double>* const x_mm = numbers("x_mm");
    const std::vector<double>* const y_mm = numbers("y_mm");
    if (!x_mm || !y_mm || x_mm->size() != y_mm->size()) return std::nullopt;
    Profile profile;
    const Value* const name = find(values, "name");
    if (const auto* said = name ? std::get_if<std::string>(name) : nullptr) profile.name = *said;
    for (std::size_t i = 0; i < x_mm->size(); ++i) {
        if (!std::isfinite((*x_mm)[i]) || !std::isfinite((*y_mm)[i])) return std::nullopt;
        profile.points_mm.emplace_back((*x_mm)[i], (*y_mm)[i]);
    }
    return profile;
}

}  // namespace lathelier
