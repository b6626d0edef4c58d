// The shop: what a part is made with. Each entry is chosen by name from a library and states its source. Units: mm, N,
// N·mm/rad, m/min, mm/rev, kW.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/cam/job.h"
#include "engine/core/fields.h"
#include "engine/cutting/cutting_forces.h"
#include "engine/receptance/spindle/spindle_receptance.h"

namespace lathelier::shop {

struct Lathe {
    std::string name;                   ///< shown; empty: the key
    double max_rpm = 3000;              ///< of the spindle
    std::optional<double> power_kW;     ///< of the motor; none: not checked
    double efficiency = 0.8;            ///< from the motor to the cut
    std::optional<double> swing_mm;     ///< largest diameter of a part; none: not checked
    std::optional<double> distance_mm;  ///< largest length of a part; none: not checked
    std::string post = "fanuc_a";       ///< of the control: a built-in post
    friend bool operator==(const Lathe&, const Lathe&) = default;
};

struct Chuck {
    std::string name;                       ///< shown; empty: the key
    receptance::SpindleSprings springs;     ///< of the chuck face with the spindle behind it
    std::optional<double> jaw_diameter_mm;  ///< none: the chuck is unbounded radially
    double grip_length_mm = 20;             ///< smallest length to be clamped
    double clearance_mm = 5;                ///< from the part's end to the chuck face
    friend bool operator==(const Chuck&, const Chuck&) = default;
};

struct Tailstock {
    std::string name;             ///< shown; empty: the key
    double radial_N_mm = 0;       ///< against deflection
    double tilt_N_mm_rad = 0;     ///< against rotation; 0: a pointed centre
    double centre_hole_mm = 5;    ///< largest diameter of the centre hole
    double from_slenderness = 4;  ///< used for parts whose length is that many times the mean diameter, or more
    friend bool operator==(const Tailstock&, const Tailstock&) = default;
};

struct ToolSet {
    std::string name;                 ///< shown; empty: the key
    std::vector<cam::JobTool> tools;  ///< values that are not stated are those of the library of inserts and holders
    friend bool operator==(const ToolSet&, const ToolSet&) = default;
};

/// Material of the bars with the cutting data that begin with it.
struct BarMaterial {
    std::string name;                      ///< as drawings state it: "C45"
    std::string elastic = "steel";         ///< key of the elastic material in the library of receptance
    cutting::CuttingCoefficients cutting;  ///< of the material and a coated carbide insert
    cam::RoughCutting rough;
    cam::FinishCutting finish;
    double diameter_allowance_mm = 2;  ///< least difference of the bar's and the part's largest diameter
    double face_allowance_mm = 1;      ///< faced off at the free end
    friend bool operator==(const BarMaterial&, const BarMaterial&) = default;
};

/// An entry that was chosen, with its name and where it is from.
template <class T>
struct Chosen {
    std::string key;
    T value;
    std::string source;
    bool is_assumed = true;  ///< of the built-in library, whose entries are examples
    friend bool operator==(const Chosen&, const Chosen&) = default;
};

/// What a part is made with.
struct Shop {
    Chosen<Lathe> lathe;
    Chosen<Chuck> chuck;
    std::optional<Chosen<Tailstock>> tailstock;  ///< none: the shop has none
    Chosen<ToolSet> tools;
    Chosen<BarMaterial> material;
    friend bool operator==(const Shop&, const Shop&) = default;
};

const std::vector<Field<Lathe>>& fieldsOf(const Lathe*);
const std::vector<Field<Chuck>>& fieldsOf(const Chuck*);
const std::vector<Field<Tailstock>>& fieldsOf(const Tailstock*);
const std::vector<Field<ToolSet>>& fieldsOf(const ToolSet*);
const std::vector<Field<BarMaterial>>& fieldsOf(const BarMaterial*);

}  // namespace lathelier::shop
