// One line of tests/golden/*.txt:
//   [directive]… word… => EXIT | expectation | expectation
// Commands joined by && run one after the other in the same {out}; those before the last one must answer (exit 0).
// Words and expectations may hold {data} (files made by the test), {out} (an empty folder of this line's own), {kept}
// (tests/data) and "quoted words".
// Directives: [env NAME=VALUE] [stdout FILE] [interrupt MILLISECONDS] [limit BYTES] (largest file) [feed PIPE FILE]
// [not-root] (without the right of root to read anything).
// Expectations on the JSON object (PATH is dotted, array indices included):
//   PATH = JSON            PATH ~ NUMBER TOLERANCE      PATH < NUMBER      PATH > NUMBER
//   PATH exists            PATH absent                  PATH has JSON (an item, or an item's "code")
// on the rest of the run:
//   stdout has TEXT        stderr has TEXT              stdout empty       stderr empty
//   left NAME…             what is in {out} afterwards, nothing else ("left" alone: nothing)
//   FILE has TEXT          a file in {out}
//   again WORD…            the same command with these words added prints the same bytes
//   truth axial_um|radial_um|axis_deg < NUMBER          the transform against {data}/sample/truth.json
//   zone FROM TO ~ MICROMETRES TOLERANCE                mean deviation of the zones between two z
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace lathelier::golden {

struct Run {
    std::vector<std::string> words;
    std::vector<std::string> environment;  ///< NAME=VALUE
    std::string stdout_file;               ///< empty: captured
    std::optional<int> interrupt_ms;
    std::optional<long> largest_file;
    bool not_as_root = false;  ///< without the right of root to read anything
    std::string feed_pipe;     ///< this pipe is fed…
    std::string feed_file;     ///< …with this file
};

struct Line {
    std::string name;                              ///< "compare.txt:12"
    std::string source;                            ///< as written
    std::vector<std::vector<std::string>> before;  ///< words of the commands before it
    Run run;
    int exit_code = 0;
    std::vector<std::string> expectations;
};

/// The lines of one file; empty ones and those starting with # are left out. Throws std::runtime_error.
std::vector<Line> readLines(const std::string& path);

std::string replaced(std::string text, const std::string& name, const std::string& value);

/// Splits at spaces; "quoted words" stay whole.
std::vector<std::string> split(const std::string& text);

}  // namespace lathelier::golden
