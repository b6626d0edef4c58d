// An archive of evaluations that proves itself: last year's numbers come back unchanged, and a change of any of them is
// found. Kept in one file (SQLite) or in the shop's PostgreSQL; both behave alike.
//
// Rows are only ever added. Each row carries the SHA-256 of the one before it of the same writer and of its own whole
// content (chain.h), so that a row that is altered, left out, put in or moved breaks the chain from there on. A writer
// is one file, or one role of a database. A correction is a further row that supersedes another.
//
// Locations: the path of a file; or a database as libpq names it: "postgresql://host/name", "postgres://…",
// "host=… dbname=…", "service=NAME". A location holds no password (sql/location.h).
//
// Times are UTC, "2026-11-29T08:15:30.250Z". Dates are "2026-11-29".
//
// Errors: of every call archiveNotRead, archiveNotWritten (full disk, lost connection, role without the right); those
// of opening at open(). Each call is one transaction (push: several) and one caller at a time; others wait. A writing
// call that throws, Cancelled included, has changed nothing; only where a connection is lost at its very end this
// cannot be known, and the call can be repeated.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/archive/evaluation.h"
#include "engine/core/error.h"
#include "engine/core/progress.h"

namespace lathelier::archive {

enum class Access {
    Read,   ///< nothing can be written
    Write,  ///< an archive of an older version is brought up to date
    Create  ///< makes it; it must not be there yet
};

/// Who answers for the evaluations of one call. Any may be empty: not stated.
struct Attestation {
    std::string person = {};
    std::string instrument = {};     ///< that measured the parts
    std::string calibrated_on = {};  ///< date of its last calibration
};

/// What was asked of every part.
struct ArchivedRecipe {
    std::string sha256;   ///< its identity, as Evaluation::recipe_sha256
    std::string content;  ///< JSON on one line
};

/// What one call of add() did.
struct Added {
    std::int64_t added = 0;
    std::int64_t already_there = 0;  ///< their key was there and not superseded; nothing was written for them
    std::vector<std::string> uuids;  ///< of the added ones, in their order
};

/// Which rows are meant: those that satisfy all that is stated.
struct Filter {
    std::string task = {};                ///< key of the task, "compare"
    std::string characteristic = {};      ///< key
    std::string recipe_sha256 = {};       ///< identity of the recipe
    std::optional<Verdict> verdict = {};  ///< of the evaluation; in series() of the value
    std::string from = {};                ///< first date
    std::string to = {};                  ///< last date, included
    std::int64_t most = 1000;             ///< the latest so many; 0: all
};

/// Head of one evaluation in the archive.
struct Entry {
    std::string uuid;         ///< of the row
    std::string recorded_at;  ///< UTC, with milliseconds
    Attestation attestation;
    std::string task;                ///< key of the task, "compare"
    std::string version;             ///< of the program
    std::string recipe_sha256;       ///< identity of the recipe
    std::string file;                ///< name of the first input, without folders; empty: no input
    int exit_code = 0;               ///< of the verb: 0 answered, 3 rejected, 4 no answer
    std::optional<Verdict> verdict;  ///< none: nothing to judge
    std::string supersedes;          ///< UUID of the row that it replaces; empty: none
    std::string superseded_by;       ///< UUID; empty: it is valid
    std::string reason;              ///< of the replacement; empty: none
    std::string writer;              ///< UUID of a file, or role of a database
    std::int64_t sequence = 0;       ///< place in the chain of its writer, from 1
    std::string hash;                ///< SHA-256 of the row and of the chain before it
};

/// One evaluation as a whole.
struct Record {
    Entry entry;
    Evaluation evaluation;
    std::string previous_hash;  ///< of the row before; of the first 64 zeros
    std::string recipe;         ///< its content, JSON on one line; empty: the archive does not hold it
};

/// One characteristic of which the archive holds values.
struct ArchivedCharacteristic {
    std::string task;              ///< key of the task, "compare"
    std::string key;               ///< with its unit: "worst.deviation_mm"
    std::string unit;              ///< as shown, "µm"; empty: none
    std::string last_recorded_at;  ///< of its latest value
};

/// One value of a characteristic.
struct SeriesPoint {
    std::string uuid;                            ///< of its evaluation
    std::string recorded_at;                     ///< UTC, with milliseconds
    std::string file;                            ///< name of the first input, without folders
    double value = 0;                            ///< in the unit of the characteristic, as the further ones
    std::optional<double> expanded_uncertainty;  ///< k = 2 or 95 %; none: not known
    std::optional<double> lower_limit;           ///< none: no limit on this side
    std::optional<double> upper_limit;           ///< none: no limit on this side
    std::optional<Verdict> verdict;              ///< none: not judged
};

/// What is wrong with a row.
enum class Fault {
    Content,     ///< it is not what was hashed
    Order,       ///< it does not follow the row before it
    Missing,     ///< a row is not there
    Duplicated,  ///< a place in the chain is taken twice
    Values,      ///< its values are not those of its result
    Recipe,      ///< the content of its recipe is not what it was
    StrayValues  ///< values that belong to no row
};
std::string_view key(Fault fault);  ///< "content" | "order" | "missing" | "duplicated" | "values" | "recipe" | …
Text name(Fault fault);

struct BrokenRow {
    std::string writer;         ///< of the chain
    std::int64_t sequence = 0;  ///< place in the chain
    std::string uuid;           ///< empty: the row is missing
    Fault fault = Fault::Content;
};

/// The chain of one writer, as far as it was checked.
struct CheckedChain {
    std::string writer;        ///< UUID of a file, or role of a database
    std::int64_t checked = 0;  ///< rows that are what they were
    std::string last_hash;     ///< of the last of them: who notes it can prove later that nothing was cut off behind
};

struct Verification {
    std::vector<CheckedChain> chains;  ///< by writer
    std::optional<BrokenRow> broken;   ///< the first; none: the archive is whole
    std::int64_t checked() const;      ///< rows of all chains
};

/// What one call of push() did.
struct Pushed {
    std::int64_t pushed = 0;         ///< rows that were written
    std::int64_t already_there = 0;  ///< rows that the target had
};

namespace sql {
class Connection;
}

class Archive {
public:
    /// Opens `location` and checks the last row of every chain. Errors: passwordInLocation, tlsRequired,
    /// locationUnclear (exit 2), archiveNotOpened, noArchive (a file or database of another kind, which stays as it
    /// is), archiveNewer, archiveOlder (the role may not bring it up to date), archiveExists, archiveOnNetwork,
    /// chainBroken (for Write; for Read a note of the same name).
    static Archive open(const std::string& location, Access access, const Progress& progress = {});
    ~Archive();
    Archive(Archive&&) noexcept;
    Archive& operator=(Archive&&) noexcept;

    const std::string& location() const;  ///< as it may be shown: without secrets
    const Notes& notes() const;           ///< of opening: chainBroken, archiveRolesMissing

    /// Adds what is not there yet. Errors recipeContradicts, textNotStorable, dateNotUnderstood.
    Added add(const std::vector<Evaluation>& evaluations, const Attestation& attestation,
              const std::vector<ArchivedRecipe>& recipes = {}, const Progress& progress = {});

    /// Adds `evaluation` in place of the row `uuid` (or the beginning of one), which stays and is marked. Returns the
    /// UUID of the new row. Errors as show() and add(); alreadySuperseded, reasonMissing.
    std::string supersede(const std::string& uuid, const Evaluation& evaluation, const std::string& reason,
                          const Attestation& attestation, const std::vector<ArchivedRecipe>& recipes = {},
                          const Progress& progress = {});

    /// The latest rows first, superseded ones included.
    std::vector<Entry> list(const Filter& filter = {}, const Progress& progress = {}) const;

    /// The row of a UUID or of its unique beginning (4 characters or more). Errors evaluationNotFound,
    /// evaluationAmbiguous.
    Record show(const std::string& uuid, const Progress& progress = {}) const;

    /// By task and key. Of the filter `task` and `characteristic` count.
    std::vector<ArchivedCharacteristic> characteristics(const Filter& filter = {}, const Progress& progress = {}) const;

    /// The values of one characteristic in the order of time, without superseded ones: the latest `most` of them.
    /// `task` of the filter is needed where several tasks have a characteristic of this key (else error
    /// characteristicAmbiguous; characteristicNotFound). 10 000 of 10 million values take 5 ms (SQLite) to 25 ms
    /// (PostgreSQL).
    std::vector<SeriesPoint> series(const std::string& characteristic, const Filter& filter = {},
                                    const Progress& progress = {}) const;

    /// Writes every row as a line of JSON Lines, recipes first, in the order of the chains; add() takes them again.
    /// Canonical: valid evaluations only, each key once, as canonicalOf(), sorted by inputs, recipe, version and task:
    /// without time, person, instrument, UUID and chain, so that the bytes are equal however they were computed.
    void exportLines(const std::function<void(std::string_view line)>& write, bool canonical,
                     const Progress& progress = {}) const;

    /// Recomputes every row of every chain.
    Verification verify(const Progress& progress = {}) const;

    /// Copies the rows that `target` does not have, as they are. Repeatable; stopped anywhere and repeated, it ends the
    /// same. Errors chainForked (a copy of a file was continued in two places), chainBroken (a row here is not what it
    /// was), those of writing.
    Pushed push(Archive& target, const Progress& progress = {}) const;

    /// Its connection, for the rooms that keep further tables in it (the queue of a batch). One caller at a time.
    sql::Connection& connection();

private:
    struct State;
    explicit Archive(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

/// Whether `location` is a database; else it is the path of a file.
bool isDatabase(const std::string& location);

}  // namespace lathelier::archive
