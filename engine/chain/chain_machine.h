// Machine, job and set-up of a chain: as they are given; what is not given is made from the shop for the drawn part, as
// files of the chain.
#pragma once

#include <optional>
#include <string>

#include "engine/cam/job.h"
#include "engine/chain/chain_question.h"
#include "engine/chain/step_runner.h"
#include "engine/deflection/setup_item.h"
#include "engine/io/input_files.h"
#include "engine/shop/shop_job.h"

namespace lathelier::chain {

class ChainMachine {
public:
    ChainMachine(const ChainQuestion& question, StepRunner& runner, io::InputFiles& inputs, const Progress& progress);

    /// Reads job and shop as far as they are given. Errors of loadJob() and loadShop(), with the path.
    void read();
    /// Job and spindle of the shop as files of the next step. Errors: those of shop::jobOf().
    void makeFor(const Shaft& part);

    /// None: not given, or not made yet.
    const std::optional<cam::Job>& job() const { return job_; }
    const std::string& jobFile() const { return jobFile_; }          ///< empty: neither given nor of the shop
    const std::string& spindleFile() const { return spindleFile_; }  ///< likewise
    const std::string& post() const { return post_; }
    bool hasSetup() const { return !question_.setup.empty() || (shop_ && question_.makesSetup()); }

    /// Precondition: hasSetup(), and a job where the set-up is of the shop. Errors of loadSetup(), with the path.
    deflection::HeldSetup setup() const;

    /// Notes what was assumed for the last step, each entry of the shop once in a chain.
    void noteMachine();
    void noteSetup();

private:
    io::FileToRead fileAt(const std::string& path) const;
    shop::Shop chosenShop() const;
    void note(const shop::UsedEntries& used);

    const ChainQuestion& question_;
    StepRunner& runner_;
    io::InputFiles& inputs_;
    const Progress& progress_;
    std::optional<cam::Job> job_;
    std::optional<shop::Shop> shop_;  // where something is made from it
    Notes assumed_;                   // of the shop, as far as noted
    std::string spindleFile_, jobFile_;
    std::string post_;
};

}  // namespace lathelier::chain
