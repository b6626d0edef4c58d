#include "engine/link/focas/focas_api.h"

#include <map>

namespace lathelier::link::focas {

std::string resultText(const char* call, short result)
{
    static const std::map<short, const char*> names{
        {protocol, "EW_PROTOCOL"}, {socket, "EW_SOCKET"}, {badHandle, "EW_HANDLE"}, {parity, "EW_PARITY"},
        {reset, "EW_RESET"},       {busy, "EW_BUSY"},     {noPmc, "EW_NOPMC"},      {badLength, "EW_LENGTH"},
        {badRange, "EW_RANGE"},    {badType, "EW_TYPE"},  {noOption, "EW_NOOPT"},   {writeProtected, "EW_PROT"},
        {rejected, "EW_REJECT"}};
    std::string text = std::string(call).append(": ").append(std::to_string(result));
    if (const auto name = names.find(result); name != names.end()) text.append(" (").append(name->second).append(")");
    return text;
}

}  // namespace lathelier::link::focas
