// Files of an earlier run while a step makes them anew: they come back when the step is stopped before it has an
// answer.
#pragma once

#include <string>
#include <vector>

namespace lathelier::chain {

class EarlierFiles {
public:
    /// `folder`: of the chain; what is set aside lies in a folder below it meanwhile.
    explicit EarlierFiles(std::string folder);
    ~EarlierFiles();  ///< puts back what is set aside, unless forget() was called
    EarlierFiles(const EarlierFiles&) = delete;
    EarlierFiles& operator=(const EarlierFiles&) = delete;

    void setAside(const std::string& name);  ///< of a file within the folder; nothing happens where there is none
    void forget();                           ///< removes them: the step has its answer

private:
    std::string folder_;
    std::vector<std::string> names_;
};

}  // namespace lathelier::chain
