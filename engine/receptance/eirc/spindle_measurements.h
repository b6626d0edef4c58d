// Measurements for the identification of the receptance of a spindle: rods in the chuck, tapped at points along them.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/fields.h"
#include "engine/core/frf.h"
#include "engine/shaft/shaft.h"

namespace lathelier::receptance {

/// A rod (or any shaft) in the chuck, free at its other end; z = length is the chuck face.
struct MeasuredRod {
    Shaft shaft;                                    ///< the part outside the chuck; without material steel is assumed
    std::vector<double> distance_from_chuck_mm;     ///< by point, 0 to the length
    std::vector<std::int64_t> node = {};            ///< number by point, for people; empty: points count from 1
    std::vector<double> accelerometer_mass_g = {};  ///< by point, of the sensor where it responds; empty: none

    std::int64_t nodeOf(std::size_t point) const;
    double massAt(std::size_t point) const;
};

/// A measured frequency response between two points of a rod. Without the mass of an accelerometer their order is
/// indifferent, by reciprocity.
struct RodFrf {
    std::size_t rod = 0;      ///< index of the rod, from 0
    std::size_t point_a = 0;  ///< index of the point that responds, from 0
    std::size_t point_b = 0;  ///< index of the point that is excited, from 0
    Frf frf;                  ///< receptance, mobility or accelerance, with coherence if known
};

struct SpindleMeasurements {
    std::vector<MeasuredRod> rods;  ///< rods of different length improve the identification
    std::vector<RodFrf> frfs;       ///< on common frequency lines
    int averages = 0;  ///< taps averaged for each response, scale of the noise by the coherence; 0: not known
};

/// A point of MEASUREMENTS.json.
struct RodPoint {
    int node = 0;                                ///< node number in the file of frequency responses
    double distance_from_chuck_mm = 0;           ///< position along the rod
    std::optional<double> accelerometer_mass_g;  ///< of the sensor at this point; none: that of the rod
    friend bool operator==(const RodPoint&, const RodPoint&) = default;
};

/// A rod of MEASUREMENTS.json: a cylinder.
struct RodEntry {
    double length_mm = 0;  ///< length outside the chuck
    double diameter_mm = 0;
    std::optional<Material> material;            ///< none: steel is assumed
    std::optional<double> accelerometer_mass_g;  ///< at its points; none: that of the file
    std::vector<RodPoint> points;                ///< measured points
    friend bool operator==(const RodEntry&, const RodEntry&) = default;
};

/// MEASUREMENTS.json: {"frf": "file.uff", "averages"?, "accelerometer_mass_g"?, "rods": [{"length_mm", "diameter_mm",
/// "material"?, "accelerometer_mass_g"?, "points": [{"node", "distance_from_chuck_mm", "accelerometer_mass_g"?}…]}…]}.
struct MeasurementFile {
    std::string frf;                             ///< path of the file of frequency responses, relative to this file
    int averages = 0;                            ///< taps averaged for each response; 0: not known
    std::optional<double> accelerometer_mass_g;  ///< moves with the point that responds; none: no mass
    std::vector<RodEntry> rods;                  ///< in the order of the file; --hold-out refers to this order, from 1
    friend bool operator==(const MeasurementFile&, const MeasurementFile&) = default;
};

const std::vector<Field<RodPoint>>& fieldsOf(const RodPoint*);
const std::vector<Field<RodEntry>>& fieldsOf(const RodEntry*);
const std::vector<Field<MeasurementFile>>& fieldsOf(const MeasurementFile*);

/// Errors with line and column: malformed, keyMissing, keyOutOfRange; measuredPointBeyondRod. Note unknownKey.
MeasurementFile readMeasurements(const std::string& json, Notes& notes);

/// A frequency response between two nodes.
struct NodeFrf {
    std::int64_t response_node = 0;   ///< where the motion was measured
    std::int64_t reference_node = 0;  ///< where the force acted
    Frf frf;                          ///< response between the nodes
};

/// Combines rods and responses; responses at unstated nodes are ignored. Error measuredNodeMissing for a node without
/// any response.
SpindleMeasurements measurementsOf(const MeasurementFile& file, std::span<const NodeFrf> frfs);

}  // namespace lathelier::receptance
