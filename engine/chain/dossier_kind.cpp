#include "engine/chain/dossier_kind.h"

#include "engine/chain/dossier.h"
#include "engine/io/json/json_head.h"

namespace lathelier::chain {
namespace {

io::Likeness likeDossier(const std::string&, std::string_view head, const Values&)
{
    const std::vector<std::string> keys = io::keysOfHead(head);
    return io::hasKey(keys, "schema") && io::hasKey(keys, "steps") && io::hasKey(keys, "verdict")
               ? io::Likeness::Certain
               : io::Likeness::No;
}

io::FileFacts factsOf(const io::FileToRead& file, Notes&)
{
    const DossierCheck check = checkDossier(file.path, file.progress);
    io::FileFacts facts;
    facts.path = file.path;
    facts.format = "dossier";
    facts.encoding = "utf-8";
    Rows faults;
    for (const DossierFault& fault : check.faults)
        faults.rows.push_back({{{"step", fault.step},
                                {"what", fault.what},
                                {"path", fault.path},
                                {"pointer", fault.place.empty() ? Value() : Value(fault.place)},
                                {"gone", fault.is_gone}}});
    facts.details = {{"files", check.files},
                     {"numbers", check.numbers},
                     {"unchanged", check.faults.empty()},
                     {"faults", std::move(faults)}};
    return facts;
}

}  // namespace

const io::FileKind& dossierFiles()
{
    static const io::FileKind kind{
        "dossier", LT_TEXT("Engine", "Dossiers of copied parts"), "*.json", {}, {}, likeDossier, factsOf};
    return kind;
}

}  // namespace lathelier::chain
