#include "engine/link/link_kind.h"

#include <gtest/gtest.h>

#include "engine/io/input_files.h"
#include "engine/link/link_codes.h"
#include "tests/engine/link/paper_case.h"

namespace lathelier::link {
namespace {

io::FileFacts factsOf(const std::string& path)
{
    io::InputFiles inputs;
    Notes notes;
    io::FileFacts facts = assistFiles().facts({path, inputs.open(path), {}, inputs, {}}, notes);
    EXPECT_TRUE(notes.empty());
    return facts;
}

TEST(LinkKind, says_which_controls_are_linked_and_what_answers)
{
    const ScratchFolder scratch;
    const std::string path = (scratch / "assist.json").string();
    io::writeFile(path,
                  barConfigText(R"("inputs": {"spindle": {"path": "spindle.json"}}, "program": {"clearance_mm": 20},
        "loopback": {"port": 7660}, "linuxcnc": {"component": "lathe"})"));
    const io::FileKind& kind = assistFiles();
    EXPECT_EQ(io::findKind({&kind}, path).likeness, io::Likeness::Certain);
    const io::FileFacts facts = factsOf(path);
    EXPECT_EQ(facts.format, "assist");
    const Rows controls{
        {{{{"link", "loopback"}, {"is_verified", true}}}, {{{"link", "linuxcnc"}, {"is_verified", true}}}}};
    const Rows files{{{{{"role", "spindle"}, {"path", (scratch / "spindle.json").string()}}}}};
    const Values expected{{"schema_version", std::int64_t{1}},
                          {"controls", controls},
                          {"files", files},
                          {"highest_rpm", 6000.0},
                          {"takes_program", true}};
    EXPECT_EQ(facts.details, expected);
}

TEST(LinkKind, is_no_other_json)
{
    const io::FileKind& kind = assistFiles();
    EXPECT_EQ(kind.sniff("", R"({"schema": "lathelier-dossier", "steps": []})", {}), io::Likeness::No);
    EXPECT_EQ(kind.sniff("", "lathelier-assist", {}), io::Likeness::No);
}

TEST(LinkKind, what_is_refused_has_its_file_and_place)
{
    const ScratchFolder scratch;
    const std::string path = (scratch / "assist.json").string();
    io::writeFile(path, "{\"schema\": \"lathelier-assist\", \"schema_version\": 1,\n \"limit\": {}}");
    try {
        factsOf(path);
        FAIL() << "not refused";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), errors::linkMemberUnknown);
        EXPECT_EQ(*find(error.values(), "path"), Value(path));
        EXPECT_EQ(*find(error.values(), "line"), Value(std::int64_t{2}));
    }
}

}  // namespace
}  // namespace lathelier::link
