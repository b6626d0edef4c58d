#include "engine/walk/shop_supply.h"

#include "engine/cam/job_bodies.h"
#include "engine/cam/job_item.h"
#include "engine/cam/task/job_input.h"
#include "engine/cam/task/turn_question.h"
#include "engine/deflection/setup_item.h"
#include "engine/io/file.h"
#include "engine/receptance/spindle/spindle_item.h"
#include "engine/shop/shop_fill.h"
#include "engine/shop/shop_job.h"

namespace lathelier::walk {
namespace {

/// The job that the project states for its part; none: it states none.
std::optional<cam::Job> givenJob(const project::Project& project, Stores& stores, const Progress& progress)
{
    const project::PanelState state = project::resolved(project, programPlace);
    if (cam::hasTools(state)) {
        auto question = fromValues<cam::TurningQuestion>(state.parameters);
        if (state.inputs.count(cam::jobRole) == 0 || cam::formRules(question, state)) return std::move(question.job);
    }
    task::Sources unused;  // the turning program reports it
    return task::take<cam::JobInput>(state, cam::jobRole, stores, progress, unused);
}

}  // namespace

Supply supplyOf(const shop::StatedShop& stated)
{
    const shop::Shop shop = stated.shop();
    Supply supply;
    supply.digest = io::sha256(shop::shopText(stated));
    supply.has = [](const std::string& kind) {
        return kind == cam::jobItem || kind == deflection::setupItem || kind == receptance::spindleItem;
    };
    supply.needs_part = [](const std::string& kind) { return kind != receptance::spindleItem; };
    supply.job_digest = [](const project::Project& project) {
        return project::stateDigest(project::resolved(project, programPlace));
    };
    supply.fill = [shop](project::PanelState& state, const task::Task& task, const Shaft* part,
                         const project::Project& project, Stores& stores, const Progress& progress, Notes& notes) {
        const std::optional<cam::Job> job = givenJob(project, stores, progress);
        shop::fillFromShop(state, task, shop, part, notes, job ? &*job : nullptr);
    };
    supply.held = [shop](const Shaft& part, const project::Project& project, Stores& stores, const Progress& progress,
                         Notes& notes) {
        std::optional<cam::Job> job = givenJob(project, stores, progress);
        if (!job) {
            job = shop::jobOf(shop, part);
            shop::noteAssumed(shop, shop::usedBy(*job), notes);
        }
        return HeldPart{cam::heldPart(part, *job), cam::usedSpeeds(*job)};
    };
    return supply;
}

}  // namespace lathelier::walk
