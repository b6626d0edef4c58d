#include "tests/engine/archive/postgres_server.h"

#include <fcntl.h>
#include <grp.h>
#include <pwd.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>
#include <vector>

#include "engine/archive/sql/postgres_connection.h"

namespace lathelier::archive {
namespace {

namespace fs = std::filesystem;

/// The newest of those installed as Debian does.
std::string programFolder()
{
    fs::path newest;
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator("/usr/lib/postgresql", ignored))
        if (fs::exists(entry.path() / "bin/initdb") && entry.path() > newest) newest = entry.path();
    if (newest.empty()) throw std::runtime_error("PostgreSQL is not installed: no /usr/lib/postgresql/*/bin/initdb");
    return newest / "bin";
}

/// The server refuses to run as root.
const passwd* unprivilegedUser()
{
    if (::getuid() != 0) return nullptr;
    const passwd* user = ::getpwnam("nobody");
    if (user == nullptr) throw std::runtime_error("no user nobody to run PostgreSQL");
    return user;
}

std::vector<std::string> wordsOf(const std::string& line)
{
    std::istringstream stream(line);
    std::vector<std::string> words;
    for (std::string word; stream >> word;) words.push_back(word);
    return words;
}

std::string contentOf(const std::string& path)
{
    std::ifstream file(path);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

}  // namespace

PostgresServer& PostgresServer::instance()
{
    static PostgresServer server;
    return server;
}

pid_t PostgresServer::start(const std::string& program, const std::string& arguments) const
{
    const passwd* const user = unprivilegedUser();
    std::vector<std::string> words = wordsOf(program + " " + arguments);
    std::vector<char*> pointers;
    pointers.reserve(words.size() + 1);
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    const std::string log = folder_ + "/log";
    const pid_t parent = ::getpid();
    const pid_t child = ::fork();
    if (child != 0) return child;
    const int output = ::open(log.c_str(), O_CREAT | O_WRONLY | O_APPEND, 0644);
    ::dup2(output, STDOUT_FILENO);
    ::dup2(output, STDERR_FILENO);
    const bool is_other = user != nullptr;
    if (is_other && (::setgroups(0, nullptr) != 0 || ::setgid(user->pw_gid) != 0 || ::setuid(user->pw_uid) != 0))
        ::_exit(126);
    ::prctl(PR_SET_PDEATHSIG, SIGINT);  // after the change of user, which takes it back
    if (::getppid() != parent || ::chdir(folder_.c_str()) != 0) ::_exit(126);
    ::execv(pointers.front(), pointers.data());
    ::_exit(127);
}

PostgresServer::PostgresServer()
{
    const std::string programs = programFolder();
    if (const passwd* user = unprivilegedUser())
        if (::chown(folder_.c_str(), user->pw_uid, user->pw_gid) != 0) throw std::runtime_error("chown " + folder_);
    const std::string data = folder_ + "/data";
    int status = 0;
    const pid_t made = start(programs + "/initdb", "--pgdata=" + data +
                                                       " --username=owner --auth=trust --no-sync --encoding=UTF8 "
                                                       "--locale=C");
    if (::waitpid(made, &status, 0) != made || status != 0)
        throw std::runtime_error("initdb: " + contentOf(folder_ + "/log"));
    server_ = start(programs + "/postgres", "-D " + data + " -k " + folder_ +
                                                " -c listen_addresses= -c fsync=off -c max_connections=40 "
                                                "-c shared_buffers=32MB");
    for (int tries = 0; tries < 600; ++tries) {
        try {
            sql::openPostgres("host=" + folder_ + " user=owner dbname=postgres", false, {});
            return;
        } catch (const Error&) {
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
        }
        if (::waitpid(server_, &status, WNOHANG) == server_) break;
    }
    throw std::runtime_error("postgres: " + contentOf(folder_ + "/log"));
}

PostgresServer::~PostgresServer()
{
    if (server_ <= 0) return;
    ::kill(server_, SIGINT);
    int status = 0;
    ::waitpid(server_, &status, 0);
}

std::string PostgresServer::newDatabase()
{
    const std::string name = "test_" + std::to_string(++databases_);
    sql::openPostgres("host=" + folder_ + " user=owner dbname=postgres", false, {})->run("CREATE DATABASE " + name);
    return "host=" + folder_ + " user=owner dbname=" + name;
}

std::string PostgresServer::withRole(const std::string& location, const std::string& role, const std::string& member_of)
{
    const auto owner = sql::openPostgres(location, false, {});
    if (!owner->word("SELECT rolname FROM pg_roles WHERE rolname = $1", {role}))
        owner->run("CREATE ROLE " + role + " LOGIN");
    if (!member_of.empty()) owner->run("GRANT " + member_of + " TO " + role);
    return forRole(location, role);
}

std::string PostgresServer::forRole(const std::string& location, const std::string& role)
{
    std::string other = location;
    const std::string from = "user=owner";
    return other.replace(other.find(from), from.size(), "user=" + role);
}

}  // namespace lathelier::archive
