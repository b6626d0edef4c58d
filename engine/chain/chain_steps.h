// The steps of the chain: tasks and their preparation. The public function is in remanufacture.h.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "engine/chain/chain_machine.h"
#include "engine/chain/chain_question.h"
#include "engine/chain/held_bar.h"
#include "engine/chain/step_results.h"
#include "engine/chain/step_runner.h"
#include "engine/io/input_files.h"

namespace lathelier::chain {

/// To be called in this order. After a failed step the following ones are only recorded.
class ChainSteps {
public:
    ChainSteps(const ChainQuestion& question, StepRunner& runner, io::InputFiles& inputs, const Progress& progress);
    ~ChainSteps();

    void recognise();
    void draw();
    void planSpeeds();  ///< machine and speeds
    void program();
    void deflect();  ///< including the check of the corrected program
    void compareCopy();
    void prove();
    void comparePhotographs();

private:
    struct Results;
    struct LocalCut {
        double diameter_mm;            // of the finish
        double before_rpm, after_rpm;  // by the job's cutting speed, by the program
    };

    StepRequest asked(const char* id, std::vector<std::string> operands, Values given = {}) const;
    Progress share(double from, double to, Text stage) const { return progress_.part(from, to, stage); }
    void addPreparationInputs();
    std::string extension() const;
    Shaft readPart();
    void deflectOne(const char* id, const HeldBar& held, const std::string& number, double from, double to);
    void checkCorrected();
    std::optional<LocalCut> cutAt(const std::optional<double>& z_mm) const;
    void compareMarks(const ChatterMarks& marks, double model_hz);

    const ChainQuestion& question_;
    StepRunner& runner_;
    io::InputFiles& inputs_;
    const Progress& progress_;
    ChainMachine machine_;
    std::string shaft_;          // path of the drawing
    bool twoClampings_ = false;  // of the program
    std::optional<HeldBar> second_;
    double split_mm_ = 0;  // z from which the second clamping finishes the part
    double zero_mm_ = 0;   // z of deflection's stock less z of the part
    double partLength_mm_ = 0;
    std::unique_ptr<Results> results_;
};

}  // namespace lathelier::chain
