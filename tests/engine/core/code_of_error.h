// The code of the error a call ends with.
#pragma once

#include <gtest/gtest.h>

#include "engine/core/core_codes.h"
#include "engine/core/error.h"

namespace lathelier {

template <class Run>
ErrorCode codeOfError(const Run& run)
{
    try {
        run();
    } catch (const Error& error) {
        return error.code();
    }
    ADD_FAILURE() << "no error";
    return errors::internal;
}

}  // namespace lathelier
