#include "engine/cam/cutting_data.h"

#include <algorithm>
#include <cmath>

#include "engine/cam/post/built_in_posts.h"
#include "engine/core/tool.h"
#include "engine/core/units.h"
#include "engine/io/json/library_file.h"

namespace lathelier::cam {
namespace {

constexpr double cutPowerPerKilowatt = 60000;

}  // namespace

const std::vector<Field<WorkMaterial>>& fieldsOf(const WorkMaterial*)
{
    using P = WorkMaterial;
    static const auto all = [] {
        Label force{LT_TEXT("Engine", "Specific cutting force"), LT_TEXT("Engine", "At a chip of 1 mm by 1 mm."),
                    LT_TEXT("Engine", "N/mm²")};
        force.required = true;
        Label exponent{LT_TEXT("Engine", "Exponent"), LT_TEXT("Engine", "How the force falls with the thickness.")};
        exponent.required = true;
        return described<P>(
            field("name", &P::name, Label{LT_TEXT("Engine", "Name"), LT_TEXT("Engine", "As drawings state it.")}),
            field("k_c11_N_mm2", &P::k_c11_N_mm2, {1, 1e5}, force), field("m_c", &P::m_c, {0, 0.9}, exponent),
            field("standing", &P::standing,
                  Label{LT_TEXT("Engine", "Standing"), LT_TEXT("Engine", "Given or assumed.")}));
    }();
    return all;
}

const std::vector<LibraryEntry<WorkMaterial>>& workMaterials()
{
    static const std::vector<LibraryEntry<WorkMaterial>> all =
        io::readLibrary<WorkMaterial>(builtInMaterials().front().text, "work_materials");
    return all;
}

const LibraryEntry<WorkMaterial>* workMaterial(const std::string& name)
{
    for (const LibraryEntry<WorkMaterial>& entry : workMaterials())
        if (plainCode(entry.key) == plainCode(name) || plainCode(entry.value.name) == plainCode(name)) return &entry;
    return nullptr;
}

double cuttingPower(const WorkMaterial& material, double depth_mm, double feed_mm_rev, double entering_angle_deg,
                    double cutting_speed_m_min)
{
    const double sine = std::sin(entering_angle_deg * rad_per_deg), h = feed_mm_rev * sine, b = depth_mm / sine;
    if (!(h > 0) || !(b > 0)) return 0;
    return material.k_c11_N_mm2 * b * std::pow(h, 1 - material.m_c) * cutting_speed_m_min / cutPowerPerKilowatt;
}

double idealRz_um(double feed_mm_rev, double corner_radius_mm, double back_angle_deg)
{
    const double f = feed_mm_rev, r = corner_radius_mm, back = back_angle_deg * rad_per_deg;
    const bool is_trimmed = back_angle_deg < 90 && f > 2 * r * std::sin(back);
    if (!is_trimmed) {
        if (f >= 2 * r) return notANumber;
        return um_per_mm * (r - std::sqrt(r * r - f * f / 4));
    }
    // Height where the nose's circle, behind its deepest point, intersects the back edge of the next revolution.
    const double start = r - r * std::cos(back);
    double low = start, high = std::min(r, start + f * std::tan(back));
    constexpr int bisections = 60;
    for (int i = 0; i < bisections; ++i) {
        const double h = (low + high) / 2;
        const double circle = std::sqrt(std::max(0.0, r * r - (r - h) * (r - h)));
        const double edge = f - r * std::sin(back) - (h - start) / std::tan(back);
        (circle < edge ? low : high) = h;
    }
    return um_per_mm * (low + high) / 2;
}

double feedForRz(double Rz_um, double corner_radius_mm, double back_angle_deg, double most_mm_rev)
{
    const auto fits = [&](double feed) { return idealRz_um(feed, corner_radius_mm, back_angle_deg) <= Rz_um; };
    if (fits(most_mm_rev)) return most_mm_rev;
    double low = 0, high = most_mm_rev;
    constexpr int bisections = 40;
    for (int i = 0; i < bisections; ++i) {
        const double middle = (low + high) / 2;
        (fits(middle) ? low : high) = middle;
    }
    return low;
}

}  // namespace lathelier::cam
