#include "app/cli/recipe_shop.h"

#include "app/cli/shop_option.h"

namespace lathelier::cli {

task::Completion completedByRecipe(const batch::Recipe& recipe, const Progress& progress)
{
    Request request;
    request.parameters = recipe.parameters;
    for (const auto& [key, value] : recipe.parameters) request.typed.insert(key);
    const batch::RecipeShop& shop = recipe.shop;
    return completedFromShop(*recipe.task, shop.name.empty() ? shop.file.path : shop.name, request, progress);
}

}  // namespace lathelier::cli
