// The questions of a part that rest on one another, in the order of the work: recognise, drawing, shaft, spindle, tap,
// frf, lobes, pass, speed, turning, program, deflection, correction, compare. Titles are those of the tasks.
#pragma once

#include <vector>

#include "engine/walk/place.h"

namespace lathelier::walk {

/// With what the tasks miss and answer; a window replaces both where its panels ask for more.
std::vector<Place> partPlaces();

}  // namespace lathelier::walk
