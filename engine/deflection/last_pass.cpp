#include "engine/deflection/last_pass.h"

#include "engine/deflection/deflection_codes.h"

namespace lathelier::deflection {

LastPass lastPassOf(const WorkPlan& plan, const TurningSetup& setup)
{
    TurningWork work(plan, setup);
    std::size_t last = plan.cuts.size();
    std::vector<Station> stations;
    for (std::size_t i = 0; i < plan.cuts.size(); ++i) {
        work.take(plan.cuts[i], CutTask::Predict, stations);
        if (!stations.empty()) last = i;
    }
    if (last == plan.cuts.size()) throw Error(errors::noCut, {});
    work.reset();
    for (std::size_t i = 0; i < last; ++i) work.take(plan.cuts[i], CutTask::Predict, stations);
    return {last, std::move(work)};
}

}  // namespace lathelier::deflection
