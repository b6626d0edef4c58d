// Interpreter of NC programs as a state machine over the blocks. Internal to the room; the public function is
// findToolpath().
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/core/units.h"
#include "engine/gcode/cycle_arguments.h"
#include "engine/gcode/cycles.h"
#include "engine/gcode/expression.h"
#include "engine/gcode/frame.h"
#include "engine/gcode/path_builder.h"
#include "engine/gcode/toolpath.h"

namespace lathelier::gcode {

/// Modal state.
struct Modal {
    bool is_inch = false;
    bool inch_feed = false;
    bool is_diameter = true;
    bool is_diameter_absolute_only = false;  ///< Name::DiameterAbsolute
    bool is_incremental = false;
    bool arc_is_absolute = false;
    bool per_revolution = true;
    bool is_css = false;
    bool is_stopped = false;
    double feed = notANumber;            ///< in mm, per revolution or minute
    double thread_lead_mm = notANumber;  ///< of E, until the next F
    bool feed_is_stale = false;
    double speed = notANumber;  ///< 1/min or m/min
    double limit_rpm = notANumber;
    int tool = 0;
    int offset = 0;  ///< number of the tool offset
    int work_offset = 540;
    G motion = G::Unknown;  ///< of the group of motions; cycles too
    NoseSide side = NoseSide::Off;
    double nose_radius_mm = notANumber;  ///< of G::NoseLeftByWords
    int nose_tip = 9;
    double round_mm = 0;             ///< Name::RoundModal
    Point at;                        ///< programmed position, in coordinates of the work
    Frame frame;                     ///< of TRANS, ROT…
    Point coarse{0, 0}, fine{0, 0};  ///< of TranslateCoarse, TranslateFine
    Point local{0, 0};               ///< LocalShift
    Point stated{0, 0};              ///< SetPosition
    Point stated_kept{0, 0};         ///< for SetPositionBack
    Point zero{0, 0};                ///< the work offset against that at the start
    Frame whole;                     ///< of coarse, fine and frame: updateFrame()
    Point shift{0, 0};               ///< of zero, stated and local: updateFrame()
    bool is_shifted = false;
    const Word* milled_by = nullptr;  ///< MillOn in force
    const Word* plane_by = nullptr;   ///< another plane than that of turning
    const Word* held_by = nullptr;    ///< the spindle is held at an angle
};

/// The words of one block, computed.
struct BlockWords {
    std::array<double, 32> value{};
    std::array<const Word*, 32> word{};
    std::uint32_t given = 0;
    std::uint32_t known = 0;  ///< letters that the control has
    std::uint32_t used = 0;
    std::array<G, 12> g{};
    std::array<const Word*, 12> g_word{};
    std::array<int, 12> g10{};
    int g_count = 0;
    std::array<int, 8> m{};
    int m_count = 0;
    std::uint32_t incremental = 0;  ///< letters given as IC(…)
    std::uint32_t absolute = 0;     ///< given as AC(…)
    /// Values of names, by Name; NaN: not given.
    std::array<double, static_cast<std::size_t>(Name::EndAngle) + 1> named{};
    bool is_machine = false;        ///< Name::MachineMove
    const Word* blocker = nullptr;  ///< a word that is not understood and may own the coordinates
    const Word* unknown_m = nullptr;
    const Word* called = nullptr;  ///< a program or a cycle by its name
    bool is_modal_call = false;    ///< Name::CallModal
    Name frame = Name::Unknown;    ///< the one that the block states
    bool has_axis_point = false;   ///< Name::AxisPoint

    BlockWords() { named.fill(notANumber); }
    double valueOf(Name name) const { return named[static_cast<std::size_t>(name)]; }

    static int slot(char letter)
    {
        return letter >= 'a' ? (letter == 'c' ? 26 : letter == 'r' ? 27 : letter == 'a' ? 28 : 29) : letter - 'A';
    }
    bool has(char letter) const { return (given & known) >> slot(letter) & 1U; }
    bool hasG(G meaning) const { return wordOfG(meaning) != nullptr; }
    const Word* wordOfG(G meaning) const
    {
        for (std::size_t i = 0; i < static_cast<std::size_t>(g_count); ++i)
            if (g[i] == meaning) return g_word[i];
        return nullptr;
    }
    bool isDrilled() const { return std::any_of(g.begin(), g.begin() + g_count, isDrilling); }
};

/// A block or program by its number, "N100".
inline std::string named(char letter, long number)
{
    std::string name(1, letter);
    name += std::to_string(number);
    return name;
}

class Interpreter {
public:
    Interpreter(Program& program, const ToolpathParameters& parameters, const ToolTable& tools,
                const Progress& progress);
    Toolpath run();

private:
    // flow (interpreter_flow.cpp)
    struct FlowStatement {
        std::size_t block = 0;
        std::string label;     ///< O word
        std::string keyword;   ///< in capitals
        std::size_t rest = 0;  ///< offset of what follows the keyword
    };
    struct CallFrame {
        std::size_t back = 0;
        std::size_t first = 0;
        long repeats = 1;
        bool has_variables = false;
        std::size_t loops = 0;                 ///< open loops of the caller
        std::size_t last = std::string::npos;  ///< a repeated part ends behind this block; npos: by its own words
    };
    struct Loop {
        std::size_t head = 0;  ///< block of WHILE, DO, FOR, REPEAT
        double left = 0;       ///< of REPEAT with a number
    };
    void indexFlow();
    void runAll();
    void runStatement(const Word& word);
    void runMacro(const Word& word);
    void runLabelled(const FlowStatement& at);
    void runStructured(const FlowStatement& at);
    const FlowStatement* statementOf(std::size_t block) const;
    std::optional<std::size_t> findSequence(long number, std::size_t from) const;
    std::pair<std::size_t, std::size_t> sectionOf(std::size_t block) const;
    void jump(std::size_t to);
    bool countLoop();
    void call(std::size_t first, long repeats, bool withVariables, std::unordered_map<long, double> arguments = {});
    void returnFromCall();
    void callProgram(BlockWords& words, bool isMacro);
    std::unordered_map<long, double> argumentsOf(BlockWords& words);
    void callByName(const Word& word, long repeats);
    void callMissing(const Word* word, const std::string& name);
    std::optional<std::size_t> programNamed(const std::string& name) const;
    void declare(std::string_view list);
    void repeatPart(std::string_view text, const Word& word, bool is_one_block);
    std::optional<std::size_t> labelled(std::string_view label) const;
    bool condition(std::string_view text, std::size_t* end = nullptr);
    void checkPairs();
    void callBlock(BlockWords& words);
    void returnOrRepeat(BlockWords& words);
    static bool standsAlone(const BlockWords& words, M meaning);
    std::size_t matching(std::size_t index, const char* open, const char* close, int step) const;
    void stop() { stopped_ = true; }

    // one block (interpreter.cpp)
    void execute(std::size_t block);
    bool gather(BlockWords& words);
    void assign(const Word& word);
    void takeName(const Word& word, BlockWords& words);
    bool takeProgramName(const Word& word, BlockWords& words);
    void reportUnknown(const Word& word, const std::string& variable);
    void sharePosition();
    std::optional<double> valueOf(const Word& word, Computed* computed = nullptr);
    void takeModes(BlockWords& words);
    void takeSpindle(BlockWords& words);
    void takeM(BlockWords& words);
    void checkUnused(const BlockWords& words);

    // motion (interpreter_motion.cpp)
    void move(BlockWords& words);
    void dwell(BlockWords& words);
    bool isOfDwell(const BlockWords& words, char letter) const;
    void reference(BlockWords& words);
    void leaveOut(BlockWords& words, const Word* because);
    const Word* milledBy(const BlockWords& words);
    void takeFrame(BlockWords& words);
    void takeShift(BlockWords& words, G which);
    void setData(BlockWords& words);
    void changeOffset(int number10, const Word* word);
    Point statedShift(BlockWords& words, const Point& otherwise);
    void updateFrame();
    Point ofWork(const Point& stated) const { return plus(modal_.whole.applied(stated), modal_.shift); }
    Point ofProgram(const Point& work) const;
    static Point plus(const Point& a, const Point& b) { return {a.x_mm + b.x_mm, a.z_mm + b.z_mm}; }
    void thread(BlockWords& words);
    double threadLead_mm(BlockWords& words);
    void arc(BlockWords& words, const Point& end);
    bool hasAxes(const BlockWords& words) const;
    Point target(BlockWords& words);
    Point statedTarget(BlockWords& words, const Point& from);
    void reportNose();
    double length_mm(BlockWords& words, char letter);
    double micro_mm(BlockWords& words, char letter);
    double plain(BlockWords& words, char letter, double otherwise = 0);
    Corner cornerOf(BlockWords& words);
    void line(BlockWords& words);
    std::optional<double> angleOf(BlockWords& words);
    bool isChamferC(const BlockWords& words);
    void unclosedLine();
    void emit(MoveKind kind, const Point& to, const Corner& corner = {}, const Point& centre = {},
              bool clockwise = false, double lead = notANumber);
    void emitCycle(const CycleMoves& moves, double lead = notANumber);
    void updateNose();
    std::optional<Tool> noseTool() const;
    Move filled(MoveKind kind, const Point& to) const;

    // cycles (interpreter_cycles.cpp)
    bool isCycle(const BlockWords& words) const;
    bool cycle(BlockWords& words);
    void singleCycle(BlockWords& words);
    void drill(BlockWords& words);
    void threadMulti(BlockWords& words);
    void driveThread(BlockWords& words);
    void peck(BlockWords& words, bool alongX);
    void contourCycle(BlockWords& words, G which);
    void unclosedCycle();
    void subroutineCycle(BlockWords& words, G which);
    std::optional<std::vector<Piece>> subroutineContour(std::size_t first, std::size_t last, Point from);
    int passesOf(double stated);
    std::vector<std::int64_t> linesOf(long number) const;
    std::vector<ContourPiece> collect(std::size_t first, std::size_t last);

    // cycles and programs that are called by their names (interpreter_called_cycles.cpp)
    void takeCalls(BlockWords& words);
    void callModally();
    void runCalled(const Word& word, long repeats);
    void stockRemovalCycle(const Word& word, const CycleArguments& given);
    void threadTurningCycle(const Word& word, const CycleArguments& given);
    void groovingCycle(const Word& word, const CycleArguments& given);
    void leaveCycleOut(const Word& word);
    std::optional<std::pair<std::size_t, std::size_t>> contourNamed(const Word& word, const std::string& name);
    std::vector<ContourPiece> contourBetween(std::size_t first, std::size_t last);
    void finishContour(std::size_t first, std::size_t last);

    std::uint32_t placeOf(const Word* word) const;
    void error(const ErrorCode& code, const Word* word = nullptr, Values values = {});
    void warn(const NoteCode& code, const Word* word = nullptr, Values values = {}, std::optional<GapEffect> gap = {});
    void assume(const std::string& what, const Text& value);
    Computed evaluated(std::string_view text);
    std::string shownWord(const Word& word) const { return shown(program_, program_.textOf(word)); }
    void notUnderstood(const Word* word);
    void drainProblems();

    Program& program_;
    const ToolpathParameters& parameters_;
    const ToolTable& tools_;
    const Progress& progress_;
    const Control& control_;
    Toolpath result_;
    Diagnostics diagnostics_;
    Variables variables_;
    Modal modal_;
    PathBuilder path_;
    std::size_t pc_ = 0;    ///< block being executed
    std::size_t next_ = 0;  ///< next block
    bool stopped_ = false;
    int repeatedErrors_ = 0;  ///< suppressed repetitions of errors
    bool inContour_ = false;  ///< true while the contour of a cycle is collected
    bool inFinish_ = false;   ///< G70 runs it
    std::optional<std::pair<std::size_t, std::size_t>> noseUnknown_;  ///< first and last block of reportNose()
    bool statedSkip_ = false;
    bool statedDiameter_ = false;
    bool statedFeedMode_ = false;
    bool statedUnit_ = false;
    std::vector<Assumed> assumed_;
    std::set<std::string> vacant_;  ///< variables that are listed as assumed
    /// A line of which the angle alone is stated: it ends where the next one, of angle and end, begins.
    struct OpenLine {
        std::size_t block = 0;
        double angle_deg = 0;
        Corner corner;
    };
    std::optional<OpenLine> openLine_;
    std::optional<bool> usesCAxis_;                ///< found on first use
    std::map<int, Point> offsets_;                 ///< of SetData, by ten times the number of the work offset
    std::map<std::string, std::size_t> programs_;  ///< first blocks of programs within the file, by name
    std::int64_t loops_ = 0;
    std::vector<FlowStatement> statements_;
    std::vector<std::size_t> statementAt_;
    std::vector<std::size_t> sections_;  ///< first blocks of programs within the file
    std::unordered_map<long, std::vector<std::size_t>> sequences_;
    bool isIndexed_ = false;
    std::vector<CallFrame> calls_;
    /// Of Name::CallModal.
    struct ModalCall {
        const Word* word = nullptr;
        long repeats = 1;
        std::size_t depth = 0;    ///< of the calls in which it stands
        std::size_t running = 0;  ///< depth of what it calls while that runs; 0: it does not
    };
    std::optional<ModalCall> modalCall_;
    bool endsNothing_ = false;  ///< the end of a program that holds a contour is no end
    std::vector<Loop> open_;

    // state of modal and two-block cycles
    std::optional<Point> cycleStart_;
    double cycleX_ = notANumber, cycleZ_ = notANumber, cycleR_ = 0;
    Drilling drilling_;
    double roughDepth_mm_ = notANumber, roughRetreat_mm_ = 0.5;
    double patternX_mm_ = 0, patternZ_mm_ = 0;
    int patternCount_ = 1;
    std::optional<std::size_t> openRough_;  ///< first of the two blocks of a cycle of a contour
    double threadLeast_mm_ = 0, threadFinish_mm_ = 0, threadRun_ = 0;
    int threadLast_ = 1;
    double peckRetreat_mm_ = 0;
};

}  // namespace lathelier::gcode
