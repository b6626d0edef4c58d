// The controls that are known. Adding one: a source controls/<key>.cpp with its description, a line here, its place in
// the list of controls.cpp (and, when it is read, its name in readControls()), and its tests: a program in
// tests/data/nc with its moves, a golden line. A post that names the key writes programs for it.
#pragma once

#include <string_view>
#include <vector>

#include "engine/core/fields.h"
#include "engine/gcode/control.h"

namespace lathelier::gcode {

// Read: in the order of the choices.
Control fanuc();      ///< G code system A of turning; the control that is assumed where a text tells none
Control fanucB();     ///< G code system B
Control fanucC();     ///< G code system C
Control haas();       ///< words of Fanuc's system A, with cycles in one block
Control sinumerik();  ///< 840D and its kin, in their own language (G290)
Control linuxCnc();   ///< also the subset of GRBL

// Recognised and refused by name.
Control sinumerik802();
Control sinumerik800();
Control heidenhain();
Control okuma();
Control philips();
Control mazatrol();
Control fagor();

inline constexpr const char* automaticControl = "auto";  ///< choice of a form: the control is told from the program

/// G words of ISO 6983 that mean the same to all controls that are read: motion, planes, nose compensation, cutting
/// speed.
std::map<int, G> commonWords();

/// All of them, each made once.
const std::vector<ControlPtr>& allControls();

/// The one that is assumed where nothing tells: the first of the list.
const ControlPtr& usualControl();

/// By its key; nullptr: none has this key, as for automaticControl.
ControlPtr controlNamed(std::string_view key);

/// Those that are read, as choices of a field: automaticControl and their keys.
const std::vector<FieldChoice>& controlChoices();

/// Names of those that are read, for the message that another one is not.
Text readControls();

/// Extension for a new file of its programs, ".nc"; nullptr or one that is not read: that of usualControl().
std::string extensionOf(const ControlPtr& control);

}  // namespace lathelier::gcode
