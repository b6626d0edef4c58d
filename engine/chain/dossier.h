// The dossier of a copied part: the steps from the scan of the worn original to the proof of the copy, the files that
// each took and made with their SHA-256, and the numbers that stand in them, each with the place where it is written.
//
// A step takes files from outside, or files that earlier steps made; so every number leads back to files from outside
// by the digests alone. checkDossier() follows them all again on the disk.
#pragma once

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
    Done,        ///< its files are there
    Missing,     ///< what it needs was not given
    Failed,      ///< it refused; what earlier steps made stays
    NotReached,  ///< an earlier step failed, or nothing was asked yet
    OutOfDate    ///< done, and something before it has changed since
};

/// "done", "missing", "failed", "not_reached", "out_of_date".
const char* key(StepState state);
Text nameOf(StepState state);

/// One step of the chain.
struct ChainStep {
    std::string id;                           ///< "recognise", "draw"…
    StepState state = StepState::NotReached;  ///< how it ended
    std::vector<InputFile> inputs;            ///< files of the chain by their path within its folder, others as given
    std::vector<InputFile> outputs;           ///< by their path within the folder of the chain
    std::string result;                       ///< which of the outputs is its result as JSON; empty: none
    Values parameters;                        ///< all of them
    Notes notes;                              ///< of the step, where this process has run it
    std::optional<Error> error;               ///< why it failed, or what is missing
    std::string request;                      ///< SHA-256 of what was asked: another one makes the step out of date
    std::vector<report::Section> sections;    ///< of its report, where this process has run it
    std::vector<std::string> remarks;         ///< notes and error of a step that was read from a file, in English
    std::shared_ptr<const Json> past_notes;   ///< its notes as they were written; null where `notes` has them
};

/// Somebody's word for something that the chain does not compute.
struct Confirmation {
    std::string what;  ///< "drawing"
    std::string file;  ///< that was confirmed
    std::string by;    ///< name; empty: nobody is named
};

struct Dossier {
    std::vector<ChainStep> steps;         ///< in order
    std::vector<TracedNumber> numbers;    ///< in the order of steps
    std::vector<Confirmation> confirmed;  ///< what people answer for
    std::optional<Verdict> verdict;       ///< of the copy; none: no copy, or no limit
    Notes notes;                          ///< of the steps, each with `step`
    std::string version;                  ///< of the program that made it

    const ChainStep* step(const std::string& id) const;  ///< null: it has none of this id
    std::optional<Error> error() const;                  ///< of the step that failed
    std::vector<report::Section> sections() const;       ///< of the reports of all steps
};

inline constexpr const char* dossierSchema = "lathelier-dossier";
inline constexpr std::size_t mostDossierItems = 100000;     ///< of a list in it
inline constexpr const char* dossierFile = "dossier.json";  ///< in the folder of the chain

/// Adds a step: its notes, and where it is done the numbers of its result.
void add(Dossier& dossier, ChainStep step, const Json& result);

/// `schema`, `verdict`, `steps`, `numbers`, `assumed` (the notes that say so), `confirmed`.
Json toJson(const Dossier& dossier);

/// All that dossier.json holds: the head of a result, toJson(), the notes of all steps.
Json wholeDossier(const Dossier& dossier, const std::vector<InputFile>& inputs, const Values& parameters);

/// What differs from what a dossier states.
struct DossierFault {
    std::string step;      ///< id
    std::string what;      ///< "input", "output", "number"
    std::string path;      ///< of the file
    std::string place;     ///< JSON pointer of a number; else empty
    bool is_gone = false;  ///< file or number is not there; else it differs
};

struct DossierCheck {
    std::int64_t files = 0;            ///< digests that were computed anew
    std::int64_t numbers = 0;          ///< numbers that were looked up
    std::vector<DossierFault> faults;  ///< in the order of the dossier
};

/// Reads the dossier at `path`, computes every digest anew, looks every number up in its file, and follows each file
/// of the chain that a step took to the step that made it. Files from outside that lie no longer at their path are
/// faults that are gone. Errors malformed, keyMissing (line, column), those of FileBytes for the dossier itself.
/// Throws Cancelled.
DossierCheck checkDossier(const std::string& path, const Progress& progress = {});

}  // namespace lathelier::chain
