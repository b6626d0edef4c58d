#include "engine/chain/chain_machine.h"

#include "engine/cam/job_file.h"
#include "engine/deflection/setup_file.h"
#include "engine/receptance/spindle/spindle_file.h"
#include "engine/shop/shop_file.h"

namespace lathelier::chain {
namespace {

constexpr const char* jobMadeFile = "job.json";
constexpr const char* spindleMadeFile = "spindle.json";

}  // namespace

ChainMachine::ChainMachine(const ChainQuestion& question, StepRunner& runner, io::InputFiles& inputs,
                           const Progress& progress)
    : question_(question),
      runner_(runner),
      inputs_(inputs),
      progress_(progress),
      spindleFile_(question.machine),
      jobFile_(question.job),
      post_(question.post)
{
}

io::FileToRead ChainMachine::fileAt(const std::string& path) const
{
    return {path, inputs_.open(path, progress_), question_.reading, inputs_, progress_};
}

void ChainMachine::read()
{
    if (!question_.job.empty()) {
        try {
            job_ = cam::loadJob(fileAt(question_.job)).job;
        } catch (Error& error) {
            throw error.with("path", question_.job);
        }
    }
    const bool is_whole = !question_.machine.empty() && !question_.job.empty() && !question_.setup.empty();
    if (question_.shop.empty() || is_whole) return;
    shop_ = chosenShop();
    if (spindleFile_.empty()) spindleFile_ = runner_.path(spindleMadeFile);
    if (!jobFile_.empty()) return;
    jobFile_ = runner_.path(jobMadeFile);
    if (post_ == ChainQuestion{}.post) post_ = shop_->lathe.value.post;
}

shop::Shop ChainMachine::chosenShop() const
{
    if (!question_.shop_text.empty()) {
        Notes ignored_notes;  // said where it was read into the project
        return shop::readShop(question_.shop_text, ignored_notes).shop();
    }
    return question_.shop == shop::builtInName ? shop::shopOf({}) : shop::loadShop(fileAt(question_.shop)).shop.shop();
}

void ChainMachine::makeFor(const Shaft& part)
{
    if (!shop_) return;
    if (question_.job.empty()) {
        job_ = shop::jobOf(*shop_, part);
        runner_.write(jobMadeFile, cam::jobText(*job_));
    }
    if (question_.machine.empty()) runner_.write(spindleMadeFile, receptance::spindleText(shop::chuckFaceOf(*shop_)));
}

deflection::HeldSetup ChainMachine::setup() const
{
    if (question_.setup.empty()) return {shop::setupOf(*shop_, job_.value()).setup, {}};  // its bar is that of the job
    try {
        return deflection::loadSetup(fileAt(question_.setup));
    } catch (Error& error) {
        throw error.with("path", question_.setup);
    }
}

void ChainMachine::note(const shop::UsedEntries& used)
{
    const std::size_t known = assumed_.size();
    shop::noteAssumed(*shop_, used, assumed_);
    for (std::size_t i = known; i < assumed_.size(); ++i) runner_.addNote(assumed_[i]);
}

void ChainMachine::noteMachine()
{
    if (!shop_ || !job_) return;
    if (question_.job.empty()) note(shop::usedBy(*job_));
    if (question_.machine.empty()) note(shop::usedByChuckFace());
}

void ChainMachine::noteSetup()
{
    if (!shop_ || !job_ || !question_.setup.empty()) return;
    shop::UsedEntries used = shop::usedBy(shop::setupOf(*shop_, *job_).setup);
    used.tools = question_.job.empty();  // else the finishing tool is that of the given job
    note(used);
}

}  // namespace lathelier::chain
