// Selection of one of several frequency responses in a file, by number or by nodes.
#pragma once

#include <span>
#include <string>

#include "engine/core/error.h"
#include "engine/io/frf/measured_frf.h"

namespace lathelier::io {

/// "3" is the third, "12/5" the one of response node 12 and reference node 5, empty that of preferredResponse(). Of
/// several with these nodes the first. Error valueNotUnderstood (parameter "response") lists the available ones.
const MeasuredFrf& chosenResponse(std::span<const MeasuredFrf> responses, const std::string& choice);

/// The response that a task takes when none is named: the first of a driving point, else the first.
const MeasuredFrf& preferredResponse(std::span<const MeasuredFrf> responses);

/// Of several responses severalResponses, which names the nodes used and the others, and noDrivingPoint where all
/// state their nodes and none is a driving point. The notes contain `path`; none for a single response.
Notes notesOfChoice(std::span<const MeasuredFrf> responses, const MeasuredFrf& used, const std::string& path);

/// "12/5"; empty when the nodes are not stated.
std::string nodePair(const MeasuredFrf& measured);

}  // namespace lathelier::io
