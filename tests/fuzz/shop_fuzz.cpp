// SHOP.json: any bytes are refused with a code of rejected input, or give a shop that is written and read again as the
// same; a stub that is given to it is answered with a job and a set-up, or refused with a code.
#include <cstdint>
#include <cstdlib>

#include "engine/shop/shop_file.h"
#include "engine/shop/shop_job.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace lathelier;
    shop::StatedShop stated;
    try {
        Notes notes;
        stated = shop::readShop(std::string(reinterpret_cast<const char*>(data), size), notes);
    } catch (const Error& error) {
        if (error.code().kind != ErrorKind::InputRejected) std::abort();
        return 0;
    }
    Notes again;
    const std::string text = shop::shopText(stated);
    if (shop::shopText(shop::readShop(text, again)) != text || !again.empty()) std::abort();
    try {
        Shaft stub;
        stub.segments = {{12, 40, 40, 0, {}, ""}, {18, 60, 60, 0, {}, ""}};
        const cam::Job job = shop::jobOf(stated.shop(), stub);
        if (!(job.stock.diameter_mm >= 60)) std::abort();
    } catch (const Error&) {
    }
    return 0;
}
