// A beam on springs condensed to one node: 2×2 stiffness of everything to its left and to its right.
//
// A shaft in bending is a chain of short uniform Timoshenko beam elements (sections and shear coefficient of
// engine/beam). The structure on one side of a node acts on it as a stiffness S over (w, θ), θ = dw/dz. Its transfer
// over the next piece has two parts: a rigid lever, S_r = Bᵀ S B with B = [[1, ∓h], [0, 1]], in series with the
// flexibility of the piece held at its near end,
//   F = [[h³/3EI + h/κGA, ±h²/2EI], [±h²/2EI, h/EI]]      (upper sign: away from the free end)
//   S' = (S_r⁻¹ + F)⁻¹ = (S_r + det S_r · adj F) / (1 + tr(S_r F) + det S_r · det F)
// The last form holds for a free end (S = 0) and for one spring (S of rank one), and the large stiffness of a short
// piece never appears, so nothing cancels: 3000 pieces of 0.1 mm agree with the force method to 1e-12, where the
// condensation of stiffness blocks K22 - K21 (K11 + S)⁻¹ K12 keeps four digits. Exact for uniform pieces.
#pragma once

#include "engine/beam/beam_section.h"
#include "engine/core/material.h"

namespace lathelier::deflection {

/// Symmetric, over (w, θ): stiffness in N/mm, N/rad, N·mm/rad, or compliance in mm/N, rad/N, rad/(N·mm).
struct Symmetric2 {
    double ww = 0;  ///< deflection by deflection
    double wt = 0;  ///< deflection by rotation
    double tt = 0;  ///< rotation by rotation

    double determinant() const { return ww * tt - wt * wt; }
    friend Symmetric2 operator+(const Symmetric2& a, const Symmetric2& b)
    {
        return {a.ww + b.ww, a.wt + b.wt, a.tt + b.tt};
    }
    friend bool operator==(const Symmetric2&, const Symmetric2&) = default;
};

inline Symmetric2 inverse(const Symmetric2& s)
{
    const double size = 1 / s.determinant();
    return {s.tt * size, -s.wt * size, s.ww * size};
}

/// Motion of a node, or its load.
struct Motion2 {
    double w = 0;  ///< mm or N
    double t = 0;  ///< rad or N·mm
};

inline Motion2 times(const Symmetric2& s, const Motion2& v)
{
    return {s.ww * v.w + s.wt * v.t, s.wt * v.w + s.tt * v.t};
}

/// Material constants in bending.
struct Elasticity {
    double elastic_modulus_MPa = 0;  ///< E
    double shear_modulus_MPa = 0;    ///< G
    double poisson_ratio = 0;        ///< ν
    beam::ShearModel shear = beam::ShearModel::Cowper;
    double solid_shear = 0;  ///< κ without a bore

    Elasticity() = default;
    Elasticity(const Material& material, beam::ShearModel model)
        : elastic_modulus_MPa(material.elastic_modulus_MPa),
          shear_modulus_MPa(material.elastic_modulus_MPa / (2 * (1 + material.poisson_ratio))),
          poisson_ratio(material.poisson_ratio),
          shear(model),
          solid_shear(beam::shearCoefficient(model, 0, material.poisson_ratio))
    {
    }

    /// F of a piece toward larger z, with its radii at the middle.
    Symmetric2 flexibility(double length_mm, double outer_radius_mm, double bore_radius_mm) const
    {
        const beam::BeamSection section = beam::roundSection(2 * outer_radius_mm, 2 * bore_radius_mm);
        const double kappa = bore_radius_mm > 0
                                 ? beam::shearCoefficient(shear, bore_radius_mm / outer_radius_mm, poisson_ratio)
                                 : solid_shear;
        const double bending = length_mm / (elastic_modulus_MPa * section.second_moment_mm4);
        return {bending * length_mm * length_mm / 3 + length_mm / (kappa * shear_modulus_MPa * section.area_mm2),
                bending * length_mm / 2, bending};
    }
};

/// S_r of the stiffness `s` at the far end of a rigid lever, which lies `toward` (± its length) along z.
inline Symmetric2 onLever(const Symmetric2& s, double toward_mm)
{
    const double wt = s.wt - toward_mm * s.ww;
    return {s.ww, wt, s.tt - toward_mm * (s.wt + wt)};
}

/// Series connection with a flexibility.
inline Symmetric2 inSeries(const Symmetric2& s, const Symmetric2& f)
{
    const double size = s.determinant();
    const double scale = 1 / (1 + f.ww * s.ww + 2 * f.wt * s.wt + f.tt * s.tt + size * f.determinant());
    return {(s.ww + size * f.tt) * scale, (s.wt - size * f.wt) * scale, (s.tt + size * f.ww) * scale};
}

/// From a node to the next toward larger z, over a piece of flexibility `f` and length h.
inline Symmetric2 passedUp(const Symmetric2& s, const Symmetric2& f, double length_mm)
{
    return inSeries(onLever(s, length_mm), f);
}

/// From a node to the one before it.
inline Symmetric2 passedDown(const Symmetric2& s, const Symmetric2& f, double length_mm)
{
    return inSeries(onLever(s, -length_mm), {f.ww, -f.wt, f.tt});
}

/// Motion of the node before, from that of the one after: `s` is the stiffness of all before at the node after.
inline Motion2 motionBefore(const Symmetric2& s, const Symmetric2& f, double length_mm, const Motion2& after)
{
    const Motion2 bent = times(f, times(s, after));
    const double t = after.t - bent.t;
    return {after.w - bent.w - length_mm * t, t};
}

/// Motion of the node after, from that of the node before.
inline Motion2 motionAfter(const Symmetric2& s, const Symmetric2& f, double length_mm, const Motion2& before)
{
    const Motion2 bent = times({f.ww, -f.wt, f.tt}, times(s, before));
    const double t = before.t - bent.t;
    return {before.w - bent.w + length_mm * t, t};
}

}  // namespace lathelier::deflection
