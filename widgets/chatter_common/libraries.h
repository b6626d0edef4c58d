// Built-in libraries, common to all workspaces, and their entries as choices of a form.
#pragma once

#include <vector>

#include "engine/core/fields.h"
#include "engine/core/library.h"
#include "engine/core/tool.h"
#include "engine/receptance/library.h"

namespace lathelier::chatter_common {

/// Stated: values of the file or set-up. The others are the entries of the library, in its order.
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

/// Choices of such a field; `stated` is the label of the first one.
std::vector<FieldChoice> materialChoices(Text stated);
std::vector<FieldChoice> machineChoices(Text stated);
std::vector<FieldChoice> insertChoices(Text stated);

/// A selected entry with its display name. entry: nullptr for Stated.
template <class T>
struct Chosen {
    const LibraryEntry<T>* entry;
    Text name;
};

/// Entries of the libraries, which are read once from the program's resources. Thread-safe.
Chosen<Material> chosen(MaterialChoice choice);
Chosen<receptance::SpindleSprings> chosen(MachineChoice choice);
Chosen<Tool> chosen(InsertChoice choice);

}  // namespace lathelier::chatter_common
