// The label of a field that has to be stated.
#pragma once

#include "engine/core/fields_make.h"

namespace lathelier::cam {

inline Label required(Text name, Text help, Text unit = {})
{
    Label label{name, help, unit};
    label.required = true;
    return label;
}

}  // namespace lathelier::cam
