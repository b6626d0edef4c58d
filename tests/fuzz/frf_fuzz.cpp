// Frequency responses, with all options: the first byte chooses those of the table, the second those of the response
// and the name. What is read can be written, and comes back.
#include <cmath>

#include "engine/io/frf/frf_choice.h"
#include "engine/io/frf/frf_codes.h"
#include "engine/io/frf/frf_reader.h"
#include "engine/io/frf/frf_sense.h"
#include "engine/io/frf/frf_writer.h"
#include "tests/fuzz/check_record.h"

namespace {

using namespace lathelier;

void checkFrf(const Frf& frf)
{
    fuzz::require(!frf.frequency_hz.empty() && frf.value.size() == frf.frequency_hz.size());
    fuzz::require(frf.coherence.empty() || frf.coherence.size() == frf.value.size());
    for (std::size_t i = 0; i < frf.value.size(); ++i) {
        fuzz::require(std::isfinite(frf.frequency_hz[i]) && std::isfinite(frf.value[i].real()) &&
                      std::isfinite(frf.value[i].imag()));
        fuzz::require(i == 0 || frf.frequency_hz[i] > frf.frequency_hz[i - 1]);
    }
    for (const double gamma : frf.coherence) fuzz::require(gamma >= 0 && gamma <= 1);
    const Frf receptance = io::toReceptance(frf);
    fuzz::require(receptance.frequency_hz.size() == receptance.value.size());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    std::string_view bytes = fuzz::viewOf(data, size);
    const io::ImportOptions options = fuzz::takeOptions(bytes);
    if (bytes.empty()) return 0;
    io::FrfOptions frf;
    const auto choice = static_cast<unsigned char>(bytes.front());
    bytes.remove_prefix(1);
    frf.frf_unit = static_cast<io::FrfUnitChoice>(choice % 7);
    frf.frequency_unit = static_cast<io::FrequencyUnitChoice>(choice / 7 % 3);
    if (choice & 0x40) frf.variables = "f=a,H=b";
    constexpr const char* columns[] = {"", "frequency,real,imag", "frequency,complex", "frequency,magnitude_db,phase"};
    if (!(choice & 0x20)) frf.frf_columns = columns[choice % 4];
    const char* name = choice & 0x80 ? "fuzz.uff" : choice & 0x20 ? "fuzz.mat" : "fuzz";
    fuzz::checkAnswer([&] {
        const io::FrfFile file = io::readFrf(name, bytes, options, frf);
        fuzz::checkFacts(file.facts, file.notes);
        fuzz::require(!file.frfs.empty());
        const io::MeasuredFrf& used = io::chosenResponse(file.frfs, frf);
        fuzz::require(std::isfinite(io::senseOf(used.frf).frequency_hz));
        for (const io::MeasuredFrf& measured : file.frfs) {
            checkFrf(measured.frf);
            const Frf again = io::readFrf("again", io::toFrfCsv(measured.frf), {}, {}).frfs.at(0).frf;
            fuzz::require(again.value == measured.frf.value && again.frequency_hz == measured.frf.frequency_hz);
        }
    });
    fuzz::checkAnswer([&] {
        Notes notes;
        const io::FileFacts facts = io::readFrfFacts(name, bytes, options, frf, notes);
        fuzz::checkFacts(facts, notes);
    });
    io::likeFrf(name, bytes, options, frf);
    return 0;
}
