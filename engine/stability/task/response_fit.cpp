#include "engine/stability/task/response_fit.h"

#include "engine/task/memo.h"

namespace lathelier::stability {
namespace {

struct FittedResponses : Memo<receptance::ModalFit> {};

}  // namespace

std::shared_ptr<const receptance::ModalFit> fitOf(const Frf& frf, const std::string& basis, Stores& stores,
                                                  const Progress& progress)
{
    return stores.of<FittedResponses>()->find(
        basis, progress, [&](const Progress& fitting) { return receptance::fitModes(frf, {}, fitting); });
}

}  // namespace lathelier::stability
