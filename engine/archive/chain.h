// One row of the archive, and the chain of rows that makes a change of any of them visible.
//
//   hash(n) = SHA-256( "lathelier archive 1", hash(n-1), every field of the row, every one of its values )
//
// hash(0) is 64 zeros. What is hashed is a sequence of fields, each with its kind and its length before it, so that no
// two rows give the same bytes; a number is its eight bytes (IEEE 754), the first the most significant.
// Source: S. Haber, W. S. Stornetta, How to Time-Stamp a Digital Document, Journal of Cryptology 3, 1991 (linking).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/archive/archive.h"
#include "engine/core/verdict_json.h"

namespace lathelier::archive {

/// A row as it is stored. Optional texts are empty where the database has NULL.
struct Row {
    std::string uuid;           ///< of the row
    std::string writer;         ///< UUID of a file, or role of a database
    std::int64_t sequence = 0;  ///< place in the chain, from 1
    std::string previous_hash;  ///< of the row before
    std::string hash;           ///< of this row, hashOf()
    std::string recorded_at;    ///< UTC, with milliseconds
    Attestation attestation;
    std::string task;                          ///< key of the task
    std::string version;                       ///< of the program
    std::string recipe_sha256;                 ///< identity of the recipe
    std::string recipe_content_sha256;         ///< of the text of the recipe; empty: it was not there
    std::string key;                           ///< Evaluation::key()
    std::string inputs;                        ///< JSON
    int exit_code = 0;                         ///< of the verb
    std::string verdict;                       ///< key; empty: none
    std::string result;                        ///< JSON
    std::string supersedes;                    ///< UUID; empty: none
    std::string reason;                        ///< of the replacement
    std::vector<task::Characteristic> values;  ///< in the order of the evaluation
    bool is_file_right = true;  ///< the name of the file beside the values is that of the inputs; not hashed
};

inline const std::string firstHash(64, '0');

/// Of all fields but `hash`.
std::string hashOf(const Row& row);

/// Fields of the evaluation; negative zeros become zeros, which SQLite does not tell apart.
Row rowOf(const Evaluation& evaluation);

/// The reverse. Error malformed where a field is no JSON, or not such JSON.
Evaluation evaluationOf(const Row& row);

/// The name of the first input without folders; empty: no input.
std::string fileOf(const std::string& inputs);

/// What is wrong with a row, looked at alone: Content, Values or Recipe; none: nothing. `recipe` is the content of its
/// recipe, if the archive holds it.
std::optional<Fault> faultOf(const Row& row, const std::optional<std::string>& recipe);

}  // namespace lathelier::archive
