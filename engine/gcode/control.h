// A control as one value: the words of its programs, what they mean to it, and how it differs from other controls. The
// reader, the interpreter and the rewriter ask it and know no control by name. A control is described in
// controls/<key>.cpp and listed in controls/controls.h; the post that writes programs for it is a file of
// resources/posts that names it by its key ("dialect").
//
// Every property is named after what the control does, and its default is what most controls do. Any Control can be
// given to readProgram(), also one that is in no list: a copy of a listed one in which something is changed. A word
// that is missing in the tables is reported (nc_word_unknown) and has no effect.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/text.h"
#include "engine/gcode/evidence.h"
#include "engine/gcode/word_meanings.h"

namespace lathelier::gcode {

/// Statements that jump, repeat and call.
enum class FlowStyle : std::uint8_t {
    Macro,       ///< IF […] GOTO 10, WHILE […] DO1 … END1
    Labelled,    ///< O words: o100 while […] … o100 endwhile, o100 sub, o100 call [1]
    Structured,  ///< IF … ELSE … ENDIF, FOR R1=1 TO 5, GOTOF LABEL
};

/// How blocks split into words. Everywhere: letters with numbers, comments behind ";", "%" at the ends of a program,
/// "/" before a block that may be skipped.
struct Grammar {
    bool has_bracket_comments = true;     ///< (…)
    bool has_comma_words = false;         ///< ",C2." and ",R1.": chamfer and rounding at the end of a line
    bool is_iso_code = false;             ///< ":100" is O100; ";" ends a block: another one behind it is noted
    bool has_names = false;               ///< words of several letters, labels "A:", and values behind "="
    bool has_number_sign = true;          ///< variables #1 and computed values in […]
    bool has_open_functions = false;      ///< XSIN[30]: a function stands behind a letter without a bracket around it
    bool assigns_many = false;            ///< #1=2 #2=3: an assignment ends with its value instead of with the block
    FlowStyle flow = FlowStyle::Macro;    ///< statements
    std::vector<std::string> statements;  ///< words that begin one; Labelled: none, for an O word does
};

/// A coordinate that a variable holds.
enum class PositionValue : std::uint8_t { X, Z };

/// Variables and what is computed with them.
struct Arithmetic {
    bool has_parentheses = false;       ///< brackets are (…) besides […]
    bool has_named_variables = false;   ///< R5, TRUE, FALSE and names are values; a name may hold digits
    bool has_comparison_signs = false;  ///< < and > beside LT and GT
    bool modulo_is_positive = true;     ///< -1 MOD 3 = 2 instead of -1
    long last_local = 0;                ///< #1 up to this one belong to a called program
    /// Of a variable without a value: #1 up to last_vacant count as not given, up to last_zero as 0; what further ones
    /// hold is not known to a reader of the program.
    long last_vacant = 0, last_zero = 0;
    /// Variables that hold the position, of a radius where position_is_radius.
    std::map<long, PositionValue> position_numbers;
    std::map<std::string, PositionValue, std::less<>> position_names;
    bool position_is_radius = false;
    std::optional<long> alarm;  ///< a value of this variable stops the program with an alarm
};

/// One of the words that state how long a dwell is.
struct DwellWord {
    /// Seconds. SecondsOrMilli: as whole numbers of a length do, those without a point count 1/1000 where
    /// ToolpathParameters::integer_words says so. Milliseconds: a whole number without a point. Revolutions: of the
    /// spindle.
    enum class Unit : std::uint8_t { Seconds, SecondsOrMilli, Milliseconds, Revolutions };
    char letter = 'P';
    Unit unit = Unit::Seconds;
};

/// State before the first block.
struct StartState {
    bool is_diameter = true;        ///< X counts diameters
    bool is_per_revolution = true;  ///< F is a feed per revolution
    bool is_at_origin = false;      ///< the position is X0 Z0; false: not known
    Text assumed_diameter;          ///< named in a note where no word states what X counts; empty: no note
    Text assumed_feed;              ///< named in a note where no word states the kind of feed; empty: no note
    G assumed_motion = G::Unknown;  ///< of coordinates before the first motion, with a note; Unknown: an error
    Text assumed_motion_word;       ///< its word in the note
};

struct Control {
    std::string key;                      ///< stable: option, project file and posts; "fanuc"
    Text label;                           ///< shown name
    std::vector<std::string> extensions;  ///< of the files of its programs, the first one for new files: ".nc"
    bool is_read = true;                  ///< false: known by its evidence only, to be refused by name
    Evidence evidence;
    Grammar grammar;
    Arithmetic arithmetic;

    std::map<int, G> g;                              ///< by ten times the number: G91.1 is 911
    std::map<int, M> m;                              ///< by the number
    std::map<char, Letter> letters;                  ///< but G and M; small: of the comma words
    std::map<std::string, Name, std::less<>> names;  ///< capitals

    StartState start;

    // Words
    bool increments_are_letters = false;     ///< U and W are increments of X and Z
    bool integers_count_increments = false;  ///< numbers without a point are to be noted: some machines count 1 µm, and
                                             ///< P and Q of cycles always do so (times: 1 ms)
    bool set_position_shifts = false;       ///< SetPosition moves the zero; false: it describes the tool
    bool set_position_is_absolute = false;  ///< SetPosition states coordinates where others count increments too
    bool local_shift_is_position = false;   ///< LocalShift and SetPosition state one shift: the later one holds
    bool can_state_diameter = false;        ///< a word says whether X counts diameters
    bool refuses_conflicts = false;         ///< a letter twice or two motions in a block are errors
    bool tool_holds_offset = false;         ///< T0304: tool 3, offset 4
    bool tools_have_names = false;          ///< T="T4": the first number in the name is taken
    std::vector<DwellWord> dwell;           ///< later ones have precedence

    // Feeds and speeds
    bool feed_ends_with_its_kind = false;  ///< another kind of feed (per minute, per revolution) needs a new F; false:
                                           ///< the number stays, which is noted
    bool css_is_per_revolution = false;    ///< constant cutting speed selects feed per revolution
    char css_limit = 0;                    ///< letter of the speed limit in the block of CssOn, until the next CssOff;
                                           ///< 0: SpeedLimit states it

    // Motion and cycles; which cycles there are follows from the table of G words
    bool thread_lead_is_ik = false;  ///< lead of Thread along Z in K or along X in I; false: F, or E turns per inch
    bool has_drawing_words = false;  ///< on a line A is its angle from +Z, R a rounding at its end, I, K and C a
                                     ///< chamfer (C where the program moves no C axis)
    bool drill_level_is_increment = false;  ///< R of drilling counts from the start
    bool groove_step_is_diameter = false;   ///< I of a groove along X in one block counts diameters

    // Programs within the file, besides O numbers
    bool call_stands_alone = false;   ///< other words in the block of CallProgram or Return are refused or left out
    bool call_holds_repeats = false;  ///< P30012 of CallProgram: program 12 three times
    char call_letter = 0;             ///< L12 P3 calls the program of that name three times; 0: none
    std::string program_head;         ///< a line with this and the name begins a program, "%_N_"; empty: none
};

using ControlPtr = std::shared_ptr<const Control>;

/// Meaning of a word; Unknown where the tables lack it. `name`: in capitals or not, also with what follows it.
G meaningOfG(const Control& control, int code10);
M meaningOfM(const Control& control, int number);
Letter meaningOfLetter(const Control& control, char letter);
Name meaningOfName(const Control& control, std::string_view name);

/// Has the control a G word of this meaning?
bool hasWord(const Control& control, G meaning);

}  // namespace lathelier::gcode
