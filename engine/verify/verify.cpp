#include "engine/verify/verify.h"

#include <algorithm>

#include "engine/core/core_codes.h"
#include "engine/deflection/deflection_verification.h"
#include "engine/form/verify/form_verification.h"
#include "engine/receptance/receptance_verification.h"
#include "engine/registration/registration_verification.h"
#include "engine/stability/stability_verification.h"

namespace lathelier::verify {
namespace {

const std::string& topicOf(const VerifyPart& part)
{
    return part.topic.empty() ? part.key : part.topic;
}

}  // namespace

const std::vector<const VerifyPart*>& verifyParts()
{
    static const std::vector<const VerifyPart*> all{
        &form::formVerification(), &registration::registrationVerification(), &receptance::receptanceVerification(),
        &stability::stabilityVerification(), &deflection::deflectionVerification()};
    return all;
}

std::vector<std::string> topics()
{
    std::vector<std::string> all;
    for (const VerifyPart* part : verifyParts())
        if (const std::string topic = topicOf(*part); std::find(all.begin(), all.end(), topic) == all.end())
            all.push_back(topic);
    return all;
}

std::vector<const VerifyPart*> partsOf(const std::string& topic)
{
    std::vector<const VerifyPart*> found;
    for (const VerifyPart* part : verifyParts())
        if (topic == allTopics || topicOf(*part) == topic) found.push_back(part);
    if (!found.empty()) return found;
    std::string names = allTopics;
    for (const std::string& one : topics()) names += ", " + one;
    throw Error(errors::valueNotUnderstood, {{"parameter", "kind"}, {"found", topic}, {"expected", names}});
}

VerifyResult verify(const std::vector<const VerifyPart*>& parts, const std::string& reference_data,
                    const Progress& progress)
{
    VerifyResult result;
    result.reference_data = reference_data;
    // Unreadable sets are reported before the built-in checks run.
    std::vector<VerifyKind> of_directory;
    if (!reference_data.empty())
        for (const VerifyPart* part : parts)
            if (part->of_directory) of_directory.push_back(part->of_directory(reference_data, progress.part(0, 0)));
    std::size_t total = 1;
    for (const VerifyPart* part : parts) total += part->checks.size();
    const auto share = [&](std::size_t done) { return static_cast<double>(done) / static_cast<double>(total); };
    for (const VerifyPart* part : parts)
        for (const auto& check : part->checks) {
            const std::size_t done = result.kinds.size();
            progress.report(share(done));
            result.kinds.push_back(check(progress.part(share(done), share(done + 1))));
        }
    result.kinds.insert(result.kinds.end(), of_directory.begin(), of_directory.end());
    result.pass = std::all_of(result.kinds.begin(), result.kinds.end(), [](const VerifyKind& k) { return k.pass; });
    progress.report(1);
    return result;
}

}  // namespace lathelier::verify
