// Backup of the files of an earlier run while a step rewrites them; restored if the step is interrupted.
#pragma once

#include <string>
#include <vector>

namespace lathelier::chain {

class EarlierFiles {
public:
    /// `folder`: folder of the chain; backups lie in a subfolder.
    explicit EarlierFiles(std::string folder);
    ~EarlierFiles();  ///< restores the backups, unless forget() was called
    EarlierFiles(const EarlierFiles&) = delete;
    EarlierFiles& operator=(const EarlierFiles&) = delete;

    void setAside(const std::string& name);  ///< moves a file of the folder to the backup, if it exists
    void forget();                           ///< removes the backups after the step has succeeded

private:
    std::string folder_;
    std::vector<std::string> names_;
};

}  // namespace lathelier::chain
