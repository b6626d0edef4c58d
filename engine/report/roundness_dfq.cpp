#include "engine/report/roundness_dfq.h"

#include "engine/report/roundness_report.h"

namespace lathelier {

QdasFile qdasFile(const std::vector<RoundnessResult>& results)
{
    QdasFile file;
    file.part_description = "Lathelier roundness";
    for (std::size_t i = 0; i < results.size(); ++i) {
        const RoundnessResult& result = results[i];
        const std::string part = std::to_string(i + 1) + ".";
        const std::string filter = filterName(bandOf(result.parameters));
        for (const ReferenceCircle circle :
             {ReferenceCircle::LSCI, ReferenceCircle::MZCI, ReferenceCircle::MICI, ReferenceCircle::MCCI}) {
            QdasCharacteristic& c = file.characteristics.emplace_back();
            c.number = part + std::to_string(static_cast<int>(circle) + 1);
            c.description = "RONt(" + std::string(name(circle)) + ") " + filter + " " + result.name;
            c.unit = "µm";
            c.nominal = 0;
            if (circle == result.parameters.circle && result.parameters.tolerance_um) {
                c.lower_limit = 0;
                c.upper_limit = *result.parameters.tolerance_um;
            }
            c.values = {result.circles.of(circle).RONt_um};
        }
    }
    return file;
}

}  // namespace lathelier
