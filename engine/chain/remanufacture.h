// The whole chain: recognise → draw → machine → speeds → program → deflection → copy → proof, and in parallel the
// photographs.
//
// Each step is a task with its own result; no number is stored twice. A step without a required
// input is missing, as are the steps depending on it; a refused step stops the chain, and earlier files are kept.
#pragma once

#include <memory>

#include "engine/chain/chain_question.h"
#include "engine/chain/step_runner.h"
#include "engine/io/input_files.h"

namespace lathelier::chain {

/// Ids of steps, in the order of the chain; `deflection_2` only for parts turned in two clampings.
inline constexpr const char* stepIds[] = {"recognise", "draw",       "machine",      "speeds",
                                          "program",   "deflection", "deflection_2", "corrected_check",
                                          "copy",      "proof",      "surface"};

/// Runs the chain, or reports what a run would do. `earlier`: of the last run in the same folder; null: none. Errors of
/// steps are recorded in the dossier. `inputs` collects the files read in preparation. Errors: outputIsInput,
/// fileNotWritable. If cancelled, the dossier of the finished steps is written without a report. Throws Cancelled.
Dossier remanufacture(const ChainQuestion& question, RunMode mode, std::shared_ptr<const Dossier> earlier,
                      io::InputFiles& inputs, const Progress& progress = {});

/// Writes dossier.json, report.html and its annexes into the folder of the question. `inputs` and `parameters` go into
/// its head.
void writeDossier(const ChainQuestion& question, const Dossier& dossier, const std::vector<InputFile>& inputs,
                  const Values& parameters);

inline constexpr const char* reportFile = "report.html";  ///< in the folder of the chain

}  // namespace lathelier::chain
