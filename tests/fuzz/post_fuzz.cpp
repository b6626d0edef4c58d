// POST.json: any bytes are refused with a code of rejected input, or give a post that is written and read again as the
// same, and that writes a program.
#include <cstdint>
#include <cstdlib>

#include "engine/cam/post/post.h"
#include "engine/cam/post/program_writer.h"
#include "engine/core/error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace lathelier;
    try {
        Notes notes;
        const cam::Post post = cam::readPost(std::string(reinterpret_cast<const char*>(data), size), notes);
        Notes none;
        if (!(cam::readPost(cam::postText(post), none) == post) || !none.empty()) std::abort();
        cam::Operation operation;
        operation.tool = 1;
        operation.cutting_speed_m_min = 100;
        cam::MoveList moves(Eigen::Vector2d(0, 0));
        moves.rapid({-2, 10});
        moves.line({5, 9}, 0.1);
        if (!post.thread.empty()) moves.thread({9, 9}, 1.5);
        operation.moves = moves.taken();
        const std::string text = cam::writeProgram(post, {"title", 1, 3000, true, {"comment"}}, {operation}).text;
        if (text.empty()) std::abort();
    } catch (const Error& error) {
        if (error.code().kind != ErrorKind::InputRejected && error.code().kind != ErrorKind::NoAnswer) std::abort();
    }
    return 0;
}
