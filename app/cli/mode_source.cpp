#include "app/cli/mode_source.h"

#include "app/cli/frf_source.h"
#include "engine/stability/stability_codes.h"

namespace lathelier::cli {

ModeSource modeSource(const Request& request, io::InputFiles&, const Progress& progress, Answer&)
{
    const auto source = fromValues<SourceParameters>(request.parameters);
    checkOneSource(request, source);
    if (source.mode.empty()) throw Error(errors::modesNeeded, {});
    progress.report(1);
    return {source.mode, {}};
}

}  // namespace lathelier::cli
