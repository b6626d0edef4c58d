#include "widgets/chain/chain_roles.h"

#include "engine/cad/step_kind.h"
#include "engine/cam/job_file.h"
#include "engine/chain/of_project/project_chain.h"
#include "engine/deflection/setup_file.h"
#include "engine/io/image/image_kind.h"
#include "engine/io/shaft/shaft_kind.h"
#include "engine/receptance/spindle/spindle_item.h"
#include "engine/receptance/spindle/spindle_kind.h"
#include "engine/shaft/shaft_item.h"

namespace lathelier::chain_panel {
namespace {

InputRole roleOf(const char* role, Text label, Text hint, io::FileKinds kinds, const char* item = "")
{
    InputRole made;
    made.role = role;
    made.label = label;
    made.hint = hint;
    made.required = false;
    made.kinds = std::move(kinds);
    made.item_kind = item;
    return made;
}

}  // namespace

std::vector<InputRole> chainRoles()
{
    return {
        roleOf(chain::scanRole, LT_TEXT("Engine", "Scan of the worn part"),
               LT_TEXT("Engine", "Else that of the panel Recognise"), {&io::scanFiles()}),
        roleOf(chain::drawingRole, LT_TEXT("Engine", "Drawing"),
               LT_TEXT("Engine", "A confirmed one, in place of what is recognised; else that of the turning program"),
               {&io::shaftFiles(), &cad::stepFiles()}, shaftItem),
        roleOf(chain::machineRole, LT_TEXT("Engine", "Machine"),
               LT_TEXT("Engine", "Else the spindle of the turning program"), {&receptance::spindleFiles()},
               receptance::spindleItem),
        roleOf(chain::jobRole, LT_TEXT("Engine", "Job"), LT_TEXT("Engine", "Else that of the turning program"),
               {&cam::jobFiles()}),
        roleOf(chain::setupRole, LT_TEXT("Engine", "Set-up of deflection"),
               LT_TEXT("Engine", "Else that of Deflection"), {&deflection::setupFiles()}),
        roleOf(chain::copyRole, LT_TEXT("Engine", "Scan of the copy"), LT_TEXT("Engine", "Else the copy of Compare"),
               {&io::scanFiles()}),
        roleOf(chain::beforeRole, LT_TEXT("Engine", "Photograph before"), LT_TEXT("Engine", "Else that of Surface"),
               {&io::imageFiles()}),
        roleOf(chain::afterRole, LT_TEXT("Engine", "Photograph after"), LT_TEXT("Engine", "Else that of Surface"),
               {&io::imageFiles()})};
}

}  // namespace lathelier::chain_panel
