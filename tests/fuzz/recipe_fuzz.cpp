// RECIPE.json: any bytes are refused with a code of rejected input, or give a recipe that is written and read again as
// the same, with one identity.
#include <cstdint>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "engine/batch/recipe_file.h"
#include "engine/cad/task/compare_task.h"
#include "engine/trajectory/task/roundness_task.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace lathelier;
    static const batch::Tasks tasks{&cad::compareTask(), &trajectory::roundnessTask()};
    batch::Recipe recipe;
    try {
        recipe = batch::readRecipe(std::string(reinterpret_cast<const char*>(data), size), "/folder", tasks);
    } catch (const Error& error) {
        if (error.code().kind != ErrorKind::InputRejected) std::abort();
        return 0;
    }
    const auto textOf = [](const batch::Recipe& one) {
        return batch::toJson(one, "/folder").dump(1, ' ', false, Json::error_handler_t::replace);
    };
    const std::string text = textOf(recipe);
    const batch::Recipe again = batch::readRecipe(text, "/folder", tasks);
    if (textOf(again) != text || batch::identityOf(again) != batch::identityOf(recipe)) std::abort();
    return 0;
}
