#include "engine/gcode/toolpath.h"

#include "engine/core/units.h"

namespace lathelier::gcode {

ControlPtr controlOf(const ToolpathParameters& parameters)
{
    return parameters.control ? parameters.control : controlNamed(parameters.dialect);
}

const std::vector<ProgramPart>& partsOf(const ToolpathParameters& parameters)
{
    static const std::vector<ProgramPart> none;
    return parameters.parts ? *parameters.parts : none;
}

const std::vector<Field<ToolpathParameters>>& fieldsOf(const ToolpathParameters*)
{
    using P = ToolpathParameters;
    static const std::vector<Field<P>> all{
        choice("dialect", &P::dialect, controlChoices(),
               Label{LT_TEXT("Engine", "Control"), LT_TEXT("Engine", "Language of the program.")}),
        field("nose_radius_mm", &P::nose_radius_mm, {0, 100},
              Label{LT_TEXT("Engine", "Nose radius"), LT_TEXT("Engine", "Of every tool, for G41 and G42."), unit::mm}),
        field("tip", &P::tip, {1, 9},
              Label{LT_TEXT("Engine", "Tip"),
                    LT_TEXT("Engine",
                            "Where the imaginary tip lies seen from the nose centre, as Fanuc counts: 3 towards the "
                            "axis and the chuck.")}),
        field("integer_words", &P::integer_words,
              {{"mm", LT_TEXT("Engine", "millimetres")}, {"um", LT_TEXT("Engine", "micrometres")}},
              Label{LT_TEXT("Engine", "Numbers without a point"),
                    LT_TEXT("Engine", "What X50 means to a Fanuc or Haas control: 50 mm or 50 µm.")}),
        field("arc_tolerance_um", &P::arc_tolerance_um, {0, 1000},
              Label{LT_TEXT("Engine", "Arc tolerance"),
                    LT_TEXT("Engine",
                            "An arc may end so far off the circle of its centre; it is a note. Farther off it is an "
                            "error."),
                    unit::um}),
        field("subprograms", &P::subprograms,
              Label{LT_TEXT("Engine", "Folder of subprograms"),
                    LT_TEXT("Engine",
                            "Programs that are called and not in the file are looked for there, by their names.")})};
    return all;
}

}  // namespace lathelier::gcode
