// What a reader did not understand or a computation does not model, and what was assumed in place of what is not
// stated: part of every result. One function settles what that does to verdict and notes, one whether anything may be
// written.
//
// Gaps are stated by readers that list places of their own (NC programs), and by notes whose code says so
// (NoteRole::NotModelled); assumptions likewise. While a gap could change a number or a verdict, the verdict is
// undecided, and nothing is written that metal is cut by.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/conformity.h"
#include "engine/core/error.h"
#include "engine/core/json.h"

namespace lathelier {

/// What a gap can change, the least first.
enum class GapEffect : std::uint8_t {
    None,      ///< nothing: it is listed only
    Measures,  ///< a measured or computed value
    Shifts,    ///< the place of all that follows
    Moves      ///< which moves are made
};

/// A place that was not understood, or whose effect is not modelled.
struct NotModelled {
    std::string path;         ///< of the file, or name of the item; empty: not known to the reader
    std::int64_t line = 0;    ///< from 1; 0: not by lines
    std::int64_t column = 0;  ///< from 1; 0: the whole line
    std::string word;         ///< as it stands there
    std::string code;         ///< stable key of its kind, "nc_word_unknown"
    GapEffect effect = GapEffect::None;
};

/// What was taken in place of what is not stated.
struct Assumed {
    std::string what;       ///< stable key, "unit"
    std::string value;      ///< "mm"
    std::string path;       ///< of the file that does not state it; empty: no file
    std::int64_t line = 0;  ///< first place where it matters, from 1; 0: not by lines
};

struct Understanding {
    std::vector<NotModelled> not_modelled;  ///< in the order of the sources
    std::vector<Assumed> assumed;           ///< likewise
    std::int64_t more_not_modelled = 0;     ///< further places that are not listed; they may have any effect

    /// The first gap that could change a number or a verdict; nullptr: none.
    const NotModelled* first() const;
    /// Number of such gaps, those not listed too.
    std::int64_t count() const;
    bool isWhole() const { return count() == 0; }
    /// Takes over what another one lists; `path` for those without.
    void add(const Understanding& other, const std::string& path = {});
};

/// Gaps and assumptions that the notes state. Values of such a note: `path`, `line`, `column`, `key` or `found` (the
/// word), all optional. A `key` that is not known counts where it is nearly another one (`meant`).
Understanding understandingOf(const Notes& notes);

/// The rule: with gaps that count the verdict is undecided, and the note not_modelled names the first place.
void settle(const Understanding& understanding, std::optional<Verdict>& verdict, Notes& notes);

/// Error not_modelled where a gap could change what is to be written; names the first place.
void requireUnderstood(const Understanding& understanding);

const char* key(GapEffect effect);  ///< "moves" | "shifts" | "measures" | "none"

/// {`not_modelled`: [{`path`, `line`, `column`, `word`, `code`, `effect`}], `assumed`: [{`what`, `value`, `path`,
/// `line`}]}; places that are not known are null.
Json toJson(const Understanding& understanding);

}  // namespace lathelier
