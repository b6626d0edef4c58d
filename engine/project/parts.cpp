#include "engine/project/parts.h"

#include <algorithm>
#include <utility>

namespace lathelier::project {
namespace {

Part& shown(Project& project)
{
    return project;
}

template <class P, class Of>
std::vector<P*> inOrder(Of& project)
{
    std::vector<P*> all;
    for (auto& other : project.others) all.push_back(&other);
    all.insert(all.begin() + static_cast<std::ptrdiff_t>(std::min(project.place, all.size())), &project);
    return all;
}

/// `except`: the part that gets the name.
std::string freeName(const Project& project, const std::string& name, const Part* except)
{
    const std::vector<const Part*> all = partsOf(project);
    const auto isTaken = [&](const std::string& wanted) {
        return std::any_of(all.begin(), all.end(),
                           [&](const Part* part) { return part != except && part->name == wanted; });
    };
    std::string free = name;
    for (int number = 2; isTaken(free); ++number) free = name + " (" + std::to_string(number) + ")";
    return free;
}

}  // namespace

std::vector<const Part*> partsOf(const Project& project)
{
    return inOrder<const Part>(project);
}

std::vector<Part*> partsOf(Project& project)
{
    return inOrder<Part>(project);
}

std::vector<std::string> partNames(const Project& project)
{
    std::vector<std::string> names;
    for (const Part* part : partsOf(project)) names.push_back(part->name);
    return names;
}

void showPart(Project& project, std::size_t index)
{
    if (index == project.place || index > project.others.size()) return;
    const auto at = [&](std::size_t place) { return project.others.begin() + static_cast<std::ptrdiff_t>(place); };
    project.others.insert(at(project.place), std::move(shown(project)));
    shown(project) = std::move(project.others[index]);
    project.others.erase(at(index));
    project.place = index;
}

void addPart(Project& project, const std::string& name)
{
    Part part;
    part.name = freeName(project, name, nullptr);
    project.others.push_back(std::move(part));
    showPart(project, project.others.size());
}

void removePart(Project& project, std::size_t index)
{
    if (index > project.others.size()) return;
    if (project.others.empty()) {
        shown(project) = {};
        return;
    }
    if (index == project.place) showPart(project, index < project.others.size() ? index + 1 : index - 1);
    const bool before = index < project.place;
    project.others.erase(project.others.begin() + static_cast<std::ptrdiff_t>(before ? index : index - 1));
    if (before) --project.place;
}

void renamePart(Project& project, std::size_t index, const std::string& name)
{
    const std::vector<Part*> all = partsOf(project);
    if (index < all.size()) all[index]->name = freeName(project, name, all[index]);
}

}  // namespace lathelier::project
