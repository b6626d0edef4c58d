// Tailstock and steady rests of a shaft, as every task that computes a shaft's response takes them: springs between the
// shaft and the ground beside its chuck.
#pragma once

#include <vector>

#include "engine/beam/beam_model.h"
#include "engine/core/fields.h"

namespace lathelier::receptance {

/// A centre at z 0.
struct Tailstock {
    double radial_N_mm = 10000;  ///< radial stiffness
    double tilt_N_mm_rad = 0;    ///< stiffness against rotation; 0: a live centre
    friend bool operator==(const Tailstock&, const Tailstock&) = default;
};

const std::vector<Field<Tailstock>>& fieldsOf(const Tailstock*);

/// A steady rest, or any other spring.
struct Rest {
    double z_mm = 0;             ///< from the free end
    double radial_N_mm = 10000;  ///< radial stiffness
    double loss_factor = 0.05;   ///< complex stiffness k (1 + i·loss_factor)
    friend bool operator==(const Rest&, const Rest&) = default;
};

const std::vector<Field<Rest>>& fieldsOf(const Rest*);

struct ShaftSupports {
    std::vector<Tailstock> tailstock;  ///< at most one
    std::vector<Rest> rest;
    friend bool operator==(const ShaftSupports&, const ShaftSupports&) = default;
};

const std::vector<Field<ShaftSupports>>& fieldsOf(const ShaftSupports*);

/// As the beam model takes them. A centre has the loss factor of a rest.
std::vector<beam::Support> supportsOf(const ShaftSupports& supports);

}  // namespace lathelier::receptance
