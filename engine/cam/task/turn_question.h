// Question of the task turn: control, clampings, and the job, from its file or from a window's form.
#pragma once

#include <string>
#include <vector>

#include "engine/cam/job.h"
#include "engine/cam/plan.h"
#include "engine/project/project.h"

namespace lathelier::cam {

inline constexpr const char* jobRole = "job";          ///< of the input; besides: shaft, spindle
inline constexpr const char* jobOfKey = "job_of";      ///< key of job_of; not in the form
inline constexpr const char* toolsKey = "tools";       ///< of the job
inline constexpr const char* skippedKey = "skipped";   ///< of the plan; edited in the list of operations
inline constexpr const char* orderKey = "order";       ///< of the plan; edited in the list of operations
inline constexpr const char* draftsKey = "drafts";     ///< programs changed by hand; made by the editor
inline constexpr const char* postRole = "post_file";   ///< of the input in place of a built-in post
inline constexpr const char* programRole = "program";  ///< of the input in place of a planned program
inline constexpr const char* partRole = "shaft";       ///< of the part
inline constexpr const char* spindleRole = "spindle";  ///< of the machine

/// Shown name of a built-in post; of another one its name.
Text labelOfPost(const std::string& post);

/// The built-in posts as choices of a field.
std::vector<FieldChoice> postChoices();

/// A program that was changed by hand.
struct TurningDraft {
    int setup = 1;               ///< clamping, 1 or 2
    std::string of_sha256;       ///< of the program before the changes
    std::string text;            ///< the whole program, UTF-8
    std::string checked_sha256;  ///< of the text that was asked to be checked; another one: its check is void
    friend bool operator==(const TurningDraft&, const TurningDraft&) = default;
};

const std::vector<Field<TurningDraft>>& fieldsOf(const TurningDraft*);

struct TurningQuestion {
    std::string post = "fanuc_a";      ///< control that the program is for: a built-in post, or the path of one
    TurningParameters plan;            ///< clampings, relation, part, operations that are left out
    Job job;                           ///< job of the form; has precedence if it has tools
    std::string job_of;                ///< identity() of the job that the form was changed from
    std::vector<TurningDraft> drafts;  ///< changes by hand, at most one for each clamping

    TurningQuestion();
};

/// Fields of the job, `job_of` and drafts are kept by a window.
const std::vector<Field<TurningQuestion>>& fieldsOf(const TurningQuestion*);

/// Identity of the job that is given, a file or an item; empty without one.
std::string identity(const project::PanelState& state);

/// Whether the form has precedence over the file.
bool formRules(const TurningQuestion& question, const project::PanelState& state);

bool hasTools(const project::PanelState& state);  ///< in the form

}  // namespace lathelier::cam
