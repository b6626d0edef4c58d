// The task frf: natural frequencies, shapes, response and compliance of a shaft, free or held. The verb and the panel
// Shaft.
//
// Precedence: a table of segments that was changed by hand rules over the file it was changed from. The material is
// that which is stated, else that of the library, else of a material file, else that of the shaft, else steel is
// assumed. At the chuck the spindle that is given, unless something else is chosen.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/receptance/library.h"
#include "engine/receptance/shaft/shaft_receptance.h"
#include "engine/receptance/shaft/shaft_study.h"
#include "engine/receptance/shaft/shaft_supports.h"
#include "engine/task/edited_segments.h"
#include "engine/task/task.h"

namespace lathelier::receptance {

/// Support of the shaft at its chuck face. Given: the spindle of the input, else none.
enum class Hold { Given, Springs, Clamped, Free };

struct ShaftQuestion {
    std::vector<ShaftSegment> segments;   ///< the table; empty: as the file has them
    std::string segments_of;              ///< task::identity() of the input they were changed from
    std::string material = statedChoice;  ///< key of the library, unless own_material is given
    std::optional<Material> own_material;
    Hold hold = Hold::Given;
    SpindleSprings springs;         ///< of Hold::Springs
    ShaftSupports supports;         ///< beside the chuck
    ReceptanceParameters response;  ///< places, range, step, method
};

const std::vector<Field<ShaftQuestion>>& fieldsOf(const ShaftQuestion*);

inline constexpr const char* shaftRole = "shaft";
inline constexpr const char* spindleRole = "spindle";
inline constexpr const char* materialRole = "material";

struct ShaftOutcome : task::Answered {
    ShaftQuestion question;    ///< the parameters as a value
    Shaft shaft;               ///< as computed
    ShaftHolding holding;      ///< likewise
    ShaftStudy study;          ///< result
    bool table_rules = false;  ///< segments of the table, not of the input

    /// The receptance as an item keeps it: lines without a finite value are left out (a free shaft at 0 Hz).
    Frf usableResponse() const;
};

/// Errors: those of the readers and of studyShaft(), with the path of the shaft. Throws Cancelled.
ShaftOutcome answerShaft(const project::PanelState& state, Stores& stores, task::Sources& sources,
                         const Progress& progress);

task::Outcome outcomeOf(const std::shared_ptr<const ShaftOutcome>& outcome);

inline constexpr const char* responseExport = "csv";
inline constexpr const char* universalExport = "uff";
inline constexpr const char* shaftExport = "write-shaft";
inline constexpr const char* stockExport = "write-stock";

const task::Task& shaftTask();

}  // namespace lathelier::receptance
