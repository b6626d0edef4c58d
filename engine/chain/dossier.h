// The dossier of a copied part: the steps from the scan of the worn original to the proof of the copy, input and output
// files of each with their SHA-256, and the results with their position in these files.
//
// Inputs of a step are external files or outputs of earlier steps, so every number can be traced to external files by
// digests. checkDossier() verifies them on the disk.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/chain/traced_numbers.h"
#include "engine/core/conformity.h"
#include "engine/core/error.h"
#include "engine/core/input_file.h"
#include "engine/core/json.h"
#include "engine/core/progress.h"
#include "engine/report/document.h"

namespace lathelier::chain {

enum class StepState : std::uint8_t {
    Done,        ///< all files written
    Missing,     ///< an input was not given
    Failed,      ///< refused with an error; files of earlier steps are kept
    NotReached,  ///< an earlier step failed, or not run yet
    OutOfDate    ///< done, but an input has changed since
};

/// "done", "missing", "failed", "not_reached", "out_of_date".
const char* key(StepState state);
Text nameOf(StepState state);

/// How a step stands: what was made of it, and what its own answer says.
struct StepStanding {
    StepState state = StepState::Missing;
    std::optional<Verdict> verdict;  ///< of a step that is done

    /// Done, and its answer is not out of tolerance and not undecided.
    bool isSound() const { return state == StepState::Done && (!verdict || *verdict == Verdict::Pass); }
};
Text nameOf(const StepStanding& standing);

/// One step of the chain.
struct ChainStep {
    std::string id;  ///< "recognise", "draw"…
    StepState state = StepState::NotReached;
    std::vector<InputFile> inputs;             ///< files of the chain by their path within its folder, others as given
    std::vector<InputFile> outputs;            ///< by their path within the folder of the chain
    std::string result;                        ///< the output that is its JSON result; empty: none
    std::optional<Verdict> verdict;            ///< of its own answer; none: nothing to judge
    std::map<std::string, std::string> roles;  ///< files of the task's inputs by role, named as `inputs`
    Values parameters;
    Notes notes;                                ///< empty if the step was not run by this process
    std::optional<Error> error;                 ///< of a failed or missing step
    std::string request;                        ///< SHA-256 of the request; a different one makes the step out of date
    std::vector<report::Section> sections;      ///< of its report; empty if not run by this process
    std::vector<std::string> remarks;           ///< notes and error of a step read from a dossier, in English
    std::shared_ptr<const Json> understanding;  ///< of its result, each entry with `step`; null: no result
    std::shared_ptr<const Json> past_notes;     ///< notes as written in the earlier dossier; null if `notes` has them
};

StepStanding standingOf(const ChainStep& step);

/// A person's confirmation of an input that the chain does not compute.
struct Confirmation {
    std::string what;  ///< "drawing"
    std::string file;  ///< confirmed file
    std::string by;    ///< name of the person; empty: not stated
};

struct Dossier {
    std::vector<ChainStep> steps;
    std::vector<TracedNumber> numbers;    ///< ordered by step
    std::vector<Confirmation> confirmed;  ///< inputs confirmed by persons
    std::optional<Verdict> verdict;       ///< of the copy; none: no copy or no tolerance. See settledVerdict()
    Notes notes;                          ///< of the steps, each with `step`
    std::string version;                  ///< of the program that made it

    const ChainStep* step(const std::string& id) const;  ///< null: not found
    std::optional<Error> error() const;                  ///< of the failed step
    std::optional<Verdict> settledVerdict() const;       ///< undecided where a step did not understand what counts
    bool isCorrected(const ChainStep& step) const;       ///< its program was corrected, and the corrected one checked
    /// The worst of the copy's verdict and those of the steps, a failed step among them; no step that is sound gives
    /// one to a chain without a copy.
    std::optional<Verdict> coverVerdict() const;
};

inline constexpr const char* dossierSchema = "lathelier-dossier";
inline constexpr std::size_t mostDossierItems = 100000;     ///< limit for each list of a dossier file
inline constexpr const char* dossierFile = "dossier.json";  ///< in the folder of the chain

/// Adds a step: its notes, and if it is done, the numbers of its result.
void add(Dossier& dossier, ChainStep step, const Json& result);

/// `schema`, `verdict` (of the copy), `cover_verdict`, `steps`, `numbers`, `assumed` (notes on assumed values),
/// `confirmed`.
Json toJson(const Dossier& dossier);

/// {`not_modelled`, `assumed`} of all steps, each entry with `step`.
Json understandingOf(const Dossier& dossier);

/// Content of dossier.json: the head of a result, toJson(), what was not understood and the notes of all steps.
Json wholeDossier(const Dossier& dossier, const std::vector<InputFile>& inputs, const Values& parameters);

/// A difference between dossier and disk.
struct DossierFault {
    std::string step;
    std::string what;  ///< "input", "output", "number"
    std::string path;
    std::string place;     ///< JSON pointer of a number; else empty
    bool is_gone = false;  ///< file or number is missing; false: it differs
};

struct DossierCheck {
    std::int64_t files = 0;            ///< digests recomputed
    std::int64_t numbers = 0;          ///< numbers compared
    std::vector<DossierFault> faults;  ///< in the order of the dossier
};

/// Reads the dossier at `path`, recomputes every digest, compares every number with its file, and traces each input
/// within the folder to the step that wrote it. Missing external files are faults with is_gone. Errors malformed,
/// keyMissing (line, column), those of FileBytes for the dossier itself. Throws Cancelled.
DossierCheck checkDossier(const std::string& path, const Progress& progress = {});

}  // namespace lathelier::chain
