// The libraries inside the program, one definition for all workspaces, and their entries as choices of a form.
#pragma once

#include <vector>

#include "engine/core/fields.h"
#include "engine/cutting/insert_library.h"
#include "engine/receptance/library.h"

namespace lathelier::chatter_common {

/// Stated: what file or set-up say. The others are the entries of the library, in its order.
enum class MaterialChoice { Stated, Steel, Stainless, Aluminium, Brass, Titanium, CastIron };
enum class MachineChoice { Stated, Papers, Stiff, Soft };
enum class InsertChoice {
    Stated,
    Cnmg120404,
    Cnmg120408,
    Cnmg120412,
    Wnmg080408,
    Dnmg150608,
    Vnmg160404,
    Tnmg160408,
    Snmg120408,
    Ccmt09t304,
    Dcmt11t304
};

/// For the field of such a choice; `stated` is the label of its first one.
std::vector<FieldChoice> materialChoices(Text stated);
std::vector<FieldChoice> machineChoices(Text stated);
std::vector<FieldChoice> insertChoices(Text stated);

/// An entry that was chosen, with its name for people. entry: nullptr for Stated.
template <class T>
struct Chosen {
    const LibraryEntry<T>* entry;
    Text name;
};

/// Of the libraries, which are read once from the program's resources. Safe from any thread.
Chosen<Material> chosen(MaterialChoice choice);
Chosen<receptance::SpindleSprings> chosen(MachineChoice choice);
Chosen<cutting::ToolGeometry> chosen(InsertChoice choice);

}  // namespace lathelier::chatter_common
