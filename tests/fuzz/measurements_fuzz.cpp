// MEASUREMENTS.json: any bytes are refused with a code of rejected input, or give rods whose points lie on them; made
// responses of their nodes are put in order or refused.
#include <cstdint>
#include <cstdlib>

#include "engine/core/error.h"
#include "engine/receptance/eirc/spindle_measurements.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace lathelier;
    try {
        Notes notes;
        const receptance::MeasurementFile file =
            receptance::readMeasurements(std::string(reinterpret_cast<const char*>(data), size), notes);
        std::vector<receptance::NodeFrf> frfs;
        for (const receptance::RodEntry& rod : file.rods)
            for (const receptance::RodPoint& point : rod.points) {
                if (!(point.distance_from_chuck_mm >= 0 && point.distance_from_chuck_mm <= rod.length_mm)) std::abort();
                if (frfs.size() < 100) frfs.push_back({point.node, rod.points.front().node, {}});
            }
        const receptance::SpindleMeasurements all = measurementsOf(file, frfs);
        if (all.rods.size() != file.rods.size()) std::abort();
        for (const receptance::RodFrf& one : all.frfs)
            if (one.rod >= all.rods.size() || one.point_a >= all.rods[one.rod].distance_from_chuck_mm.size() ||
                one.point_b >= all.rods[one.rod].distance_from_chuck_mm.size())
                std::abort();
    } catch (const Error& error) {
        if (error.code().kind != ErrorKind::InputRejected && error.code().kind != ErrorKind::NoAnswer) std::abort();
    }
    return 0;
}
