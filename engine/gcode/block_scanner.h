// One block of an NC program as words: by the grammar of its control.
#pragma once

#include "engine/gcode/program.h"

namespace lathelier::gcode {

/// Appends the words of blocks to a program, which has to outlive the scanner. Text that is not a word becomes a
/// diagnostic (nc_character_unexpected, nc_number_missing, nc_comment_not_closed), and the block is malformed.
class BlockScanner {
public:
    explicit BlockScanner(Program& program);

    /// `block` is the last one of the program; its words must be those added last.
    void scan(Block& block);

private:
    void scanWord();
    void scanAddress(char letter, std::size_t from);
    void scanName(std::size_t from);
    void scanComment();
    void scanVariable();
    bool scanStatement(std::size_t from);
    bool scanLabelled(std::size_t from);
    std::size_t afterValue(std::size_t at) const;
    std::size_t afterExpression(std::size_t at) const;
    std::size_t endOfCode(std::size_t at) const;
    std::size_t skipBlanks(std::size_t at) const;
    Word& add(std::size_t from, std::size_t to, WordKind kind, char letter = 0);
    bool isPlainText(std::size_t at) const;
    void fail(const ErrorCode& code, std::size_t at, std::size_t to);

    Program& program_;
    const std::string& text_;
    const Grammar& grammar_;
    Block* block_ = nullptr;
    std::size_t at_ = 0;
    std::size_t end_ = 0;
};

}  // namespace lathelier::gcode
