// The meridian of a body of revolution as a polyline in the half plane (z, r), and signed distances to it.
#pragma once

#include <optional>
#include <vector>

#include "engine/registration/revolution/measured_faces.h"
#include "engine/registration/revolution/revolution.h"

namespace lathelier::registration {

/// Profile, shoulders and end faces in one line, in order of z; the material lies on its lower side. Where the scan
/// shows a bore, a second line: the material lies on its upper side.
class MeridianLine {
public:
    /// `points` are those of the part, for its end faces.
    MeridianLine(const TurnedPart& part, const std::vector<Eigen::Vector3d>& points, const Progress& progress = {});

    /// Distance of (z, r) from the line, + outside the material; NaN when it is further than `max_distance` or nearest
    /// to where the data end.
    double deviation_mm(double z, double r, double max_distance) const;

    /// The faces that are measured, in order of z: there the line follows them, and is straight across the axis where
    /// the scan shows no more than a step.
    const std::vector<MeasuredFace>& faces() const { return faces_; }

    double zFirst_mm() const { return zFirst_; }
    double zLast_mm() const { return zLast_; }

private:
    struct Segment {
        Eigen::Vector2d from, to;                 ///< (z, r)
        Eigen::Vector2d normal;                   ///< out of the material
        Eigen::Vector2d from_normal, to_normal;   ///< summed with the neighbour's, for the sign at a corner
        bool open_from = false, open_to = false;  ///< the line ends here with the data
    };
    /// Segments that reach into each bin: index of the first, and one past the last.
    struct Index {
        std::vector<std::size_t> first, last;
    };
    /// The end faces that the scan shows.
    struct Ends {
        std::optional<FaceCandidate> first, last;
    };
    Ends measureAllFaces(const TurnedPart& part, const std::vector<Eigen::Vector3d>& points,
                         const std::vector<std::size_t>& known, const Progress& progress);
    std::vector<double> layOutside(const TurnedPart& part, const std::vector<std::size_t>& known, const Ends& ends);
    std::vector<double> clearanceOf(const std::vector<std::size_t>& known, const std::vector<double>& corners) const;
    void addPiece(const std::vector<Eigen::Vector2d>& line);
    void addBore(const RadiusProfile& bore);
    void addFace(std::vector<Eigen::Vector2d>& line, double z, double from_radius, double to_radius) const;
    Index indexOf(std::size_t from, std::size_t to) const;
    double search(double z, double r, double reach) const;

    RadiusProfile profile_;
    std::vector<double> clearance_;  ///< for each profile bin: how far it is from anything but smooth side
    std::vector<Segment> segments_;
    std::vector<MeasuredFace> faces_;
    Index outside_, bore_;
    double binStart_ = 0, binStep_ = 1;
    double zFirst_ = 0, zLast_ = 0;
};

}  // namespace lathelier::registration
