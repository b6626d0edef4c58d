// The surfaces of revolution and the faces that the walls of a scan show, to tell points on them from all others.
#pragma once

#include <vector>

#include "engine/features/walls/walls.h"

namespace lathelier::features {

class SeenSurface {
public:
    enum class Place { Wall, Face, Off };

    SeenSurface(const MeridianCloud& cloud, const Walls& walls);
    SeenSurface(const SeenSurface&) = delete;
    SeenSurface& operator=(const SeenSurface&) = delete;

    /// Where a point at (z, r) lies.
    Place placeOf(double z_mm, double r_mm) const;
    /// Outer radius at z; where no wall is seen there, the smaller one of the nearest before and behind. 0: no walls.
    double outer_mm(double z_mm) const;
    /// Is a wall of the outside seen at z?
    bool isSeen(double z_mm) const;
    /// Chains of the outside that count as surfaces, in order of z.
    const std::vector<const Chain*>& outside() const { return outside_; }
    /// Half the width of the band of a smooth wall.
    double band_mm() const { return band_mm_; }

private:
    /// Radii about r + slope·(z - middle of the bin).
    struct Band {
        double r_mm, slope, half_mm;
        bool face;
    };
    struct Bin {
        std::vector<Band> bands;  ///< of chains and faces
        double outer_mm = 0;      ///< 0: no wall of the outside
        double reference_mm = 0;  ///< outer_mm()
    };

    void addChain(const Chain& chain, double bin_mm);
    void addFaces();
    void addFace(double from_mm, double to_mm, double low_mm, double high_mm);
    Bin* binAt(double z_mm);
    const Bin* binAt(double z_mm) const;

    double first_mm_ = 0, band_mm_ = 0;
    std::vector<Bin> bins_;
    std::vector<Chain> chains_;          ///< that count as surfaces
    std::vector<const Chain*> outside_;  ///< of these
};

}  // namespace lathelier::features
