#include "engine/gcode/controls/controls.h"

#include "engine/gcode/controls/add_words.h"

namespace lathelier::gcode {

std::map<int, G> commonWords()
{
    std::map<int, G> g;
    addWords(g, G::Rapid, {0});
    addWords(g, G::Line, {1});
    addWords(g, G::ArcCw, {2});
    addWords(g, G::ArcCcw, {3});
    addWords(g, G::Dwell, {4});
    addWords(g, G::PlaneOther, {17, 19});
    addWords(g, G::PlaneZX, {18});
    addWords(g, G::NoseOff, {40});
    addWords(g, G::NoseLeft, {41});
    addWords(g, G::NoseRight, {42});
    addWords(g, G::CssOn, {96});
    addWords(g, G::CssOff, {97});
    return g;
}

const std::vector<ControlPtr>& allControls()
{
    static const std::vector<ControlPtr> all = [] {
        std::vector<ControlPtr> list;
        for (Control (*describe)() : {fanuc, fanucB, fanucC, haas, sinumerik, linuxCnc, sinumerik802, sinumerik800,
                                      heidenhain, okuma, philips, mazatrol, fagor})
            list.push_back(std::make_shared<const Control>(describe()));
        return list;
    }();
    return all;
}

Text readControls()
{
    return LT_TEXT("Engine", "Fanuc (G code systems A, B and C), Haas, Sinumerik or LinuxCNC");
}

const ControlPtr& usualControl()
{
    return allControls().front();
}

ControlPtr controlNamed(std::string_view key)
{
    for (const ControlPtr& control : allControls())
        if (control->key == key) return control;
    return nullptr;
}

const std::vector<FieldChoice>& controlChoices()
{
    static const std::vector<FieldChoice> all = [] {
        std::vector<FieldChoice> list{{automaticControl, LT_TEXT("Engine", "from the program")}};
        for (const ControlPtr& control : allControls())
            if (control->is_read) list.push_back({control->key, control->label});
        return list;
    }();
    return all;
}

std::string extensionOf(const ControlPtr& control)
{
    const bool hasOwn = control && control->is_read && !control->extensions.empty();
    return (hasOwn ? control : usualControl())->extensions.front();
}

}  // namespace lathelier::gcode
