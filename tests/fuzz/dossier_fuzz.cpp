// dossier.json: any bytes are refused with a code of rejected input, or give a dossier whose report can be written; as
// the result of the proof they are none, or can be drawn.
#include <cstdint>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>

#include "engine/chain/dossier_cover.h"
#include "engine/chain/dossier_read.h"
#include "engine/chain/proof.h"
#include "engine/core/error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace lathelier;
    const std::string text(reinterpret_cast<const char*>(data), size);
    try {
        const chain::Dossier dossier = chain::dossierFrom(text);
        if (chain::dossierReport(dossier).sections.empty()) std::abort();
        chain::wholeDossier(dossier, {}, {});
    } catch (const Error& error) {
        if (error.code().kind != ErrorKind::InputRejected) std::abort();
    }
    const Json json = Json::parse(text, nullptr, false);
    if (json.is_discarded()) return 0;
    if (const auto proof = chain::proofFrom(json)) {
        const std::size_t places = proof->predicted.z_mm.size();
        if (proof->predicted.error_um.size() != places) std::abort();
        if (!proof->predicted.low_um.empty() && proof->predicted.low_um.size() != places) std::abort();
        chain::proofPlot(*proof);
        chain::proofTable(*proof);
    }
    return 0;
}
