// What answers a request: the task speed asked with the values of the control. Loop, replay of a log, and panel ask it;
// no other function decides what is written.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/progress.h"
#include "engine/core/understanding.h"
#include "engine/link/control_values.h"
#include "engine/project/project.h"
#include "engine/task/inputs.h"

namespace lathelier::link {

/// What a control may ask.
struct Limits {
    double highest_rpm = 0;                     ///< of the machine: N_cor above is refused; needed
    std::optional<double> lowest_diameter_mm;   ///< further limits than those of the task's fields
    std::optional<double> highest_diameter_mm;  ///< likewise
    std::optional<double> lowest_length_mm;     ///< likewise
    std::optional<double> highest_length_mm;    ///< likewise
};

/// D and L that a control leaves open: of the program that is loaded on it.
struct OfProgram {
    double clearance_mm = 0;  ///< from the turned length to the chuck: L = turned length + clearance
};

/// D and L of a program (program_bar.h).
struct ProgramBar {
    std::string path;              ///< of the program
    std::string sha256;            ///< of its content
    double diameter_mm = 0;        ///< D
    double length_mm = 0;          ///< L, with the clearance
    std::vector<Assumed> assumed;  ///< by the reader of the program
};

/// What is answered, and what is written with it.
struct Reply {
    State state = State::Idle;
    std::optional<double> n_cor_rpm;     ///< whole 1/min; with State::Ok alone
    std::optional<double> selected_rpm;  ///< of v_c and D, where they were understood
    std::optional<ProgramBar> program;   ///< where D or L came from it
    std::vector<Assumed> assumed;        ///< what was taken in place of what is not stated
    std::optional<Error> error;          ///< why there is no speed
};

/// Whether the response is that of the bar D × L; else it is a shaft's, or measured, or of modes.
bool isOfBar(const project::PanelState& question);

/// The question without the values of the operator's screen.
project::PanelState machineQuestion(project::PanelState question);

class Assistant {
public:
    /// `question`: inputs and parameters of the task speed. What the control states is entered into them; the values of
    /// the operator's screen are the control's alone (machineQuestion()).
    Assistant(project::PanelState question, const Limits& limits, std::optional<OfProgram> of_program = {});

    /// Reads the files and answers once in advance, so that no request waits for it. Errors: those of the readers.
    /// Throws Cancelled.
    void prepare(const Progress& progress);

    /// `program`: path of the program that is loaded, asked for where D or L is needed and is 0 or not there. Never
    /// throws but Cancelled: what keeps it from an answer is its state. Of one thread at a time.
    Reply answer(const ControlValues& values, const std::optional<std::string>& program, const Progress& progress);

    /// Whether D or L of these values is to come from the program.
    bool needsProgram(const ControlValues& values) const;

private:
    std::optional<Reply> refused(const ControlValues& values) const;
    project::PanelState asked(const ControlValues& values) const;
    Reply computed(const ControlValues& values, const Progress& progress);

    project::PanelState question_;
    Limits limits_;
    std::optional<OfProgram> ofProgram_;
    Stores stores_;
};

}  // namespace lathelier::link
