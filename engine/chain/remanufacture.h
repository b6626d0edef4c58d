// The whole chain: recognise → draw → machine → speeds → program → deflection → copy → proof, with photographs beside.
//
// Each step is a verb of the command line with its own result; no number exists twice. A step that lacks an input is
// missing, and so are those that need it; one that refuses stops the chain, and what was made before stays.
#pragma once

#include <memory>

#include "engine/chain/chain_question.h"
#include "engine/chain/step_runner.h"
#include "engine/io/input_files.h"

namespace lathelier::chain {

/// Ids of steps, in the order of the chain; `deflection_2` only where the part is turned in two clampings.
inline constexpr const char* stepIds[] = {"recognise", "draw",       "machine",      "speeds",
                                          "program",   "deflection", "deflection_2", "corrected_check",
                                          "copy",      "proof",      "surface"};

/// Runs the chain, or looks what a run would do. `earlier`: of the last run in the same folder; null: none. Refusals
/// of steps are in the dossier. `inputs` gets the files that prepare steps. Errors: outputIsInput, fileNotWritable.
/// When it is stopped the dossier of what was made is written, without a report. Throws Cancelled.
Dossier remanufacture(const ChainQuestion& question, const AskVerb& ask, RunMode mode,
                      std::shared_ptr<const Dossier> earlier, io::InputFiles& inputs, const Progress& progress = {});

/// Writes dossier.json and report.html into the folder of the question. `inputs` and `parameters` are those of the
/// head.
void writeDossier(const ChainQuestion& question, const Dossier& dossier, const std::vector<InputFile>& inputs,
                  const Values& parameters);

inline constexpr const char* reportFile = "report.html";  ///< in the folder of the chain

}  // namespace lathelier::chain
