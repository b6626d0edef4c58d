#include "engine/archive/chain.h"

#include <algorithm>
#include <bit>
#include <map>
#include <nlohmann/json.hpp>

#include "engine/io/file.h"
#include "engine/io/io_codes.h"

namespace lathelier::archive {
namespace {

/// Bytes that tell where each field begins and ends.
class Serial {
public:
    void add(std::string_view text) { bytes_.append("t").append(std::to_string(text.size())).append(":").append(text); }
    void add(std::int64_t number) { bytes_.append("i").append(std::to_string(number)).append(":"); }
    void add(double number)
    {
        bytes_ += 'd';
        const auto bits = std::bit_cast<std::uint64_t>(number);
        for (int shift = 56; shift >= 0; shift -= 8) bytes_ += static_cast<char>(bits >> shift & 0xFFU);
    }
    void add(const std::optional<double>& number)
    {
        if (number)
            add(*number);
        else
            bytes_ += 'n';
    }
    const std::string& bytes() const { return bytes_; }

private:
    std::string bytes_;
};

std::string wordOf(const std::optional<Verdict>& verdict)
{
    return verdict ? std::string(lathelier::key(*verdict)) : std::string();
}

double withoutSign(double number)
{
    return number == 0 ? 0.0 : number;
}

std::optional<double> withoutSign(const std::optional<double>& number)
{
    return number ? std::optional(withoutSign(*number)) : number;
}

bool isEqual(const std::optional<double>& a, const std::optional<double>& b)
{
    return withoutSign(a) == withoutSign(b);
}

/// Every value that the result has too is the same there. The result may have more, and the value `answer` stands in no
/// result.
bool fitsResult(const Row& row)
{
    const Json result = Json::parse(row.result, nullptr, false);
    if (result.is_discarded()) return false;
    std::map<std::string, task::Characteristic> stated;
    for (task::Characteristic& one : task::characteristicsOf(result)) stated.emplace(one.key, std::move(one));
    return std::all_of(row.values.begin(), row.values.end(), [&stated](const task::Characteristic& value) {
        const auto found = stated.find(value.key);
        return found == stated.end() ||
               (found->second.unit == value.unit && isEqual(found->second.value, value.value) &&
                isEqual(found->second.expanded_uncertainty, value.expanded_uncertainty) &&
                isEqual(found->second.lower_limit, value.lower_limit) &&
                isEqual(found->second.upper_limit, value.upper_limit));
    });
}

[[noreturn]] void refuse(const char* expected)
{
    throw Error(errors::malformed,
                {{"found", std::string("a row of the archive")}, {"expected", std::string(expected)}});
}

}  // namespace

std::string hashOf(const Row& row)
{
    Serial serial;
    serial.add("lathelier archive 1");
    for (const std::string* field :
         {&row.previous_hash, &row.uuid, &row.writer, &row.recorded_at, &row.attestation.person,
          &row.attestation.instrument, &row.attestation.calibrated_on, &row.task, &row.version, &row.recipe_sha256,
          &row.recipe_content_sha256, &row.key, &row.inputs, &row.verdict, &row.result, &row.supersedes, &row.reason})
        serial.add(std::string_view(*field));
    serial.add(row.sequence);
    serial.add(static_cast<std::int64_t>(row.exit_code));
    serial.add(static_cast<std::int64_t>(row.values.size()));
    for (const task::Characteristic& value : row.values) {
        serial.add(std::string_view(value.key));
        serial.add(std::string_view(value.unit));
        serial.add(value.value);
        serial.add(value.expanded_uncertainty);
        serial.add(value.lower_limit);
        serial.add(value.upper_limit);
        serial.add(std::string_view(wordOf(value.verdict)));
    }
    return io::sha256(serial.bytes());
}

Row rowOf(const Evaluation& evaluation)
{
    Row row;
    row.task = evaluation.task;
    row.version = evaluation.version;
    row.recipe_sha256 = evaluation.recipe_sha256;
    row.key = evaluation.key();
    Evaluation inputs_only;  // the result need not be parsed for them
    inputs_only.inputs = evaluation.inputs;
    row.inputs = toJson(inputs_only)["inputs"].dump();
    row.exit_code = evaluation.exit_code;
    row.verdict = wordOf(evaluation.verdict);
    row.result = evaluation.result;
    row.values = evaluation.characteristics;
    for (task::Characteristic& value : row.values) {
        value.value = withoutSign(value.value);
        for (auto* beside : {&value.expanded_uncertainty, &value.lower_limit, &value.upper_limit})
            *beside = withoutSign(*beside);
    }
    return row;
}

Evaluation evaluationOf(const Row& row)
{
    Evaluation made;
    made.task = row.task;
    made.recipe_sha256 = row.recipe_sha256;
    made.version = row.version;
    const Json inputs = Json::parse(row.inputs, nullptr, false);
    if (!inputs.is_array()) refuse("a list of inputs");
    for (const Json& input : inputs) {
        const auto word = [&input](const char* key) {
            const auto found = input.is_object() ? input.find(key) : input.end();
            if (!input.is_object() || found == input.end() || !found->is_string()) refuse("an input");
            return found->get<std::string>();
        };
        const std::string role = word("role");
        const auto bytes = input.find("bytes");
        if (bytes == input.end() || !bytes->is_number_integer()) refuse("a number of bytes");
        made.inputs.push_back({role, {word("path"), bytes->get<std::int64_t>(), word("sha256")}});
    }
    made.exit_code = row.exit_code;
    made.verdict = verdictOf(row.verdict);
    made.characteristics = row.values;
    if (!Json::accept(row.result)) refuse("the JSON of a result");
    made.result = row.result;
    return made;
}

std::string fileOf(const std::string& inputs)
{
    const Json json = Json::parse(inputs, nullptr, false);
    if (!json.is_array() || json.empty() || !json.front().is_object()) return {};
    const auto path = json.front().find("path");
    if (path == json.front().end() || !path->is_string()) return {};
    const std::string whole = path->get<std::string>();
    const std::size_t slash = whole.find_last_of('/');
    return slash == std::string::npos ? whole : whole.substr(slash + 1);
}

std::optional<Fault> faultOf(const Row& row, const std::optional<std::string>& recipe)
{
    if (!row.is_file_right || !fitsResult(row)) return Fault::Values;
    if (hashOf(row) != row.hash) return Fault::Content;
    if (!row.recipe_content_sha256.empty() && (!recipe || io::sha256(*recipe) != row.recipe_content_sha256))
        return Fault::Recipe;
    try {
        if (evaluationOf(row).key() != row.key) return Fault::Content;
    } catch (const Error&) {
        return Fault::Content;
    }
    return std::nullopt;
}

std::string_view key(Fault fault)
{
    switch (fault) {
        case Fault::Content: return "content";
        case Fault::Order: return "order";
        case Fault::Missing: return "missing";
        case Fault::Duplicated: return "duplicated";
        case Fault::Values: return "values";
        case Fault::Recipe: return "recipe";
        case Fault::StrayValues: return "stray_values";
    }
    return "content";
}

Text name(Fault fault)
{
    switch (fault) {
        case Fault::Content: return LT_TEXT("Engine", "its content is not what was recorded");
        case Fault::Order: return LT_TEXT("Engine", "it does not follow the row before it");
        case Fault::Missing: return LT_TEXT("Engine", "it is missing");
        case Fault::Duplicated: return LT_TEXT("Engine", "its place is taken twice");
        case Fault::Values: return LT_TEXT("Engine", "its values are not those of its result");
        case Fault::Recipe: return LT_TEXT("Engine", "its recipe is not what was recorded");
        case Fault::StrayValues: return LT_TEXT("Engine", "values belong to no row");
    }
    return {};
}

}  // namespace lathelier::archive
