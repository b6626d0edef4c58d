#include "engine/archive/sql/location.h"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace lathelier::archive::sql {
namespace {

constexpr std::array databaseKeys{"host",    "hostaddr", "port",        "dbname",          "user",
                                  "service", "password", "passfile",    "connect_timeout", "sslmode",
                                  "options", "sslcert",  "sslpassword", "servicefile",     "application_name"};
constexpr std::array schemes{"postgresql://", "postgres://"};
constexpr std::array secretKeys{"password", "sslpassword"};
constexpr std::string_view hidden = "***";

bool isBlank(char sign)
{
    return sign == ' ' || sign == '\t' || sign == '\n' || sign == '\r' || sign == '\f' || sign == '\v';
}

std::size_t schemeLength(const std::string& location)
{
    for (const std::string_view scheme : schemes)
        if (location.starts_with(scheme)) return scheme.size();
    return 0;
}

/// A stretch of the location that is a secret.
struct Stretch {
    std::size_t from = 0, to = 0;
};

/// "%70assword" is a spelling of "password".
std::string decoded(std::string_view word)
{
    std::string plain;
    for (std::size_t i = 0; i < word.size(); ++i) {
        const auto digit = [&](std::size_t at) {
            const std::size_t found =
                at < word.size() ? std::string_view("0123456789abcdef").find(static_cast<char>(word[at] | 0x20))
                                 : std::string_view::npos;
            return found == std::string_view::npos ? -1 : static_cast<int>(found);
        };
        const int high = digit(i + 1), low = digit(i + 2);
        if (word[i] == '%' && high >= 0 && low >= 0) {
            plain += static_cast<char>(high * 16 + low);
            i += 2;
        } else {
            plain += word[i];
        }
    }
    return plain;
}

bool isSecret(std::string_view key)
{
    const std::string plain = decoded(key);
    return std::find(secretKeys.begin(), secretKeys.end(), plain) != secretKeys.end();
}

/// The password of "user:password@host". Up to the last @ before the path, as it may hold one that is not escaped; one
/// with a slash that is not escaped ends at the last @ of all.
std::optional<Stretch> passwordOfUser(const std::string& location, std::size_t begin)
{
    const std::size_t path = std::min(location.find_first_of("/?", begin), location.size());
    const std::size_t colon = location.find(':', begin);
    std::size_t at = location.substr(0, path).rfind('@');
    if (at == std::string::npos || at < begin) at = location.rfind('@');
    if (at == std::string::npos || at < begin || colon >= std::min(at, path) || colon + 1 == at) return std::nullopt;
    return Stretch{colon + 1, at};
}

std::vector<Stretch> secretsOfAddress(const std::string& location, std::size_t begin)
{
    std::vector<Stretch> secrets;
    if (const auto password = passwordOfUser(location, begin)) secrets.push_back(*password);
    std::size_t from = location.find('?', secrets.empty() ? begin : secrets.back().to);
    while (from != std::string::npos) {
        const std::size_t equals = location.find('=', ++from);
        const std::size_t end = std::min(location.find('&', from), location.size());
        if (equals < end && isSecret(std::string_view(location).substr(from, equals - from)))
            secrets.push_back({equals + 1, end});
        from = end < location.size() ? end : std::string::npos;
    }
    return secrets;
}

std::size_t skipBlanks(const std::string& location, std::size_t at)
{
    while (at < location.size() && isBlank(location[at])) ++at;
    return at;
}

/// Value of a pair from `at`, in quotes or up to a blank; returns where it ends.
std::size_t endOfValue(const std::string& location, std::size_t at)
{
    const bool is_quoted = at < location.size() && location[at] == '\'';
    if (is_quoted) ++at;
    for (; at < location.size(); ++at) {
        if (location[at] == '\\')
            ++at;
        else if (is_quoted ? location[at] == '\'' : isBlank(location[at]))
            return is_quoted ? at + 1 : at;
    }
    return location.size();
}

std::vector<Stretch> secretsOfPairs(const std::string& location)
{
    std::vector<Stretch> secrets;
    for (std::size_t at = skipBlanks(location, 0); at < location.size(); at = skipBlanks(location, at)) {
        const std::size_t equals = location.find('=', at);
        if (equals == std::string::npos) break;
        std::size_t end = equals;
        while (end > at && isBlank(location[end - 1])) --end;
        const std::size_t from = skipBlanks(location, equals + 1);
        const std::size_t to = endOfValue(location, from);
        if (isSecret(std::string_view(location).substr(at, end - at)) && to > from) secrets.push_back({from, to});
        at = to;
    }
    return secrets;
}

std::vector<Stretch> secretsOf(const std::string& location)
{
    if (const std::size_t scheme = schemeLength(location)) return secretsOfAddress(location, scheme);
    return namesDatabase(location) ? secretsOfPairs(location) : std::vector<Stretch>();
}

}  // namespace

bool namesDatabase(const std::string& location)
{
    if (schemeLength(location) > 0) return true;
    const std::size_t from = skipBlanks(location, 0);
    std::size_t to = location.find('=', from);
    if (to == std::string::npos) return false;
    while (to > from && isBlank(location[to - 1])) --to;
    const std::string_view key = std::string_view(location).substr(from, to - from);
    return std::find(databaseKeys.begin(), databaseKeys.end(), key) != databaseKeys.end();
}

std::string withoutSecrets(const std::string& location)
{
    std::string shown = location;
    const std::vector<Stretch> secrets = secretsOf(location);
    for (auto secret = secrets.rbegin(); secret != secrets.rend(); ++secret)
        shown.replace(secret->from, secret->to - secret->from, hidden);
    return shown;
}

bool statesPassword(const std::string& location)
{
    return !secretsOf(location).empty();
}

bool isThisMachine(std::string_view host)
{
    if (host.empty() || host.front() == '/' || host.front() == '@') return true;
    if (host == "localhost" || host == "::1") return true;
    const bool is_number = host.find_first_not_of("0123456789.") == std::string_view::npos;
    return is_number && host.starts_with("127.");
}

std::optional<std::string> demandedTls(std::string_view hosts, const std::string& mode, bool is_stated)
{
    bool is_local = true;
    for (std::size_t from = 0; from != std::string_view::npos;) {
        const std::size_t to = hosts.find(',', from);
        is_local = is_local && isThisMachine(hosts.substr(from, to - from));
        from = to == std::string_view::npos ? to : to + 1;
    }
    if (is_local) return std::string();
    if (mode == "require" || mode == "verify-ca" || mode == "verify-full") return mode;
    if (is_stated) return std::nullopt;
    return "verify-full";
}

}  // namespace lathelier::archive::sql
