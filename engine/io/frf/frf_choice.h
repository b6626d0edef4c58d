// Selection of one of several frequency responses in a file, by number, by nodes, or by a rule.
#pragma once

#include <span>
#include <string>

#include "engine/core/error.h"
#include "engine/io/frf/frf_reader.h"
#include "engine/io/frf/measured_frf.h"

namespace lathelier::io {

/// "3" is the third, "12/5" the one of response node 12 and reference node 5, empty that of preferredResponse(). Of
/// several with these nodes the first. Error valueNotUnderstood (parameter "response") lists the available ones.
const MeasuredFrf& chosenResponse(std::span<const MeasuredFrf> responses, const std::string& choice);

/// FrfOptions::response.
const MeasuredFrf& chosenResponse(std::span<const MeasuredFrf> responses, const FrfOptions& options);

/// The response that is taken when none is named: of the driving points that of largestFlexibility(), as it
/// limits the depth of cut most; without a driving point the first. Of equals the first.
const MeasuredFrf& preferredResponse(std::span<const MeasuredFrf> responses);

/// Largest -Re of the receptance that three lines in a row reach, which a single noisy line does not; lines of a stated
/// coherence below 0.8, and those that hardly exceed their noise, are left out. 0 without such lines.
double largestFlexibility(const Frf& frf);

/// Of several responses severalResponses, which names the nodes used and the others, and noDrivingPoint where all
/// state their nodes and none is a driving point. The notes contain `path`; none for a single response.
Notes notesOfChoice(std::span<const MeasuredFrf> responses, const MeasuredFrf& used, const std::string& path);

/// "12/5"; empty when the nodes are not stated.
std::string nodePair(const MeasuredFrf& measured);

/// "12x/5x" with the stated directions; empty when the nodes are not stated.
std::string responseName(const MeasuredFrf& measured);

}  // namespace lathelier::io
