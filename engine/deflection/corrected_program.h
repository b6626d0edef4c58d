// The program that allows for the deflection. Its text is parsed and simulated again, so that the residual is that of
// the file.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/quantities.h"
#include "engine/deflection/compensation.h"
#include "engine/deflection/turning_job.h"

namespace lathelier::deflection {

/// One changed or added block of the corrected program with the reason.
struct ProgramChange {
    std::int64_t line = 0;              ///< of the original block; of an added one: the block that it follows
    std::optional<std::string> before;  ///< text of the block; none: added
    std::string after;                  ///< text of the block
    Text reason;                        ///< pattern; {name} is replaced by the named value
    Values values;                      ///< z_mm, correction_um, dx_um, dy_um, F_t_N, F_ap_N, stiffness_N_mm
};

/// The reason in English.
std::string reasonOf(const ProgramChange& change);

/// A corrected program.
struct CorrectedProgram {
    CompensationResult compensation;  ///< counts, residual and robustness are those of `text`
    std::string text;                 ///< the whole program; bytes of unchanged blocks as they were
    std::vector<ProgramChange> changes;
    std::vector<gcode::Move> moves;  ///< of `text`
};

/// Only X words and those of the centres and radii of arcs change, on the grid of the program (0.001 mm of diameter,
/// 0.0001 in), and blocks are divided where a corner is needed. Blocks behind a changed one that state no X, or count
/// from it, get their original X. Errors: those of compensate(); notModelled (`line`) for passes in a bore;
/// ncBlockNotRewritable (line, block, word, reason) under nose radius compensation, in a contour of G70-G73, in blocks
/// executed more than once, for a block of a corrected pass with a word that may shape it. Throws Cancelled.
CorrectedProgram correctProgram(const TurningJob& job, const CompensationParameters& parameters = {},
                                const Progress& progress = {});

const std::vector<QuantityOf<ProgramChange>>& quantitiesOf(const ProgramChange*);
const std::vector<QuantityOf<CorrectedProgram>>& quantitiesOf(const CorrectedProgram*);

}  // namespace lathelier::deflection
