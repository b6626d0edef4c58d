// Profiles, with all options: the first byte chooses those of the table, the second those of the profile.
#include "engine/io/profile/profile_reader.h"
#include "tests/fuzz/check_record.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace lathelier;
    std::string_view bytes = fuzz::viewOf(data, size);
    const io::ImportOptions options = fuzz::takeOptions(bytes);
    if (bytes.empty()) return 0;
    io::ProfileOptions profile;
    const auto choice = static_cast<unsigned char>(bytes.front());
    bytes.remove_prefix(1);
    profile.columns = static_cast<io::ProfileColumns>(choice % 3);
    if (choice & 0x80) profile.nominal_radius_mm = 25;
    fuzz::checkAnswer([&] {
        const io::ProfileFile file = io::readProfile("fuzz", bytes, options, profile);
        fuzz::checkFacts(file.facts, file.notes);
        fuzz::require(!file.profile.points_mm.empty());
        for (const Eigen::Vector2d& point : file.profile.points_mm)
            fuzz::require(point.allFinite() && point.cwiseAbs().maxCoeff() <= io::largestCoordinate_mm * 1.01);
        fuzz::require(!toJson(file.header).dump().empty());
    });
    io::isProfileTable(bytes, options);
    return 0;
}
