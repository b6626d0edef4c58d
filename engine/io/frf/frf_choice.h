// Selection of one of several frequency responses in a file, by number or by nodes.
#pragma once

#include <span>
#include <string>

#include "engine/io/frf/measured_frf.h"

namespace lathelier::io {

/// "3" is the third, "12/5" the one of response node 12 and reference node 5, empty the first. Of several with these
/// nodes the first. Error valueNotUnderstood (parameter "response") lists the available ones.
const MeasuredFrf& chosenResponse(std::span<const MeasuredFrf> responses, const std::string& choice);

/// "12/5"; empty when the nodes are not stated.
std::string nodePair(const MeasuredFrf& measured);

}  // namespace lathelier::io
