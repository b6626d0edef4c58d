#include "engine/io/import.h"

namespace lathelier::io {

const std::vector<Field<ImportOptions>>& fieldsOf(const ImportOptions*)
{
    static const std::vector<Field<ImportOptions>> all = {
        field("decimal", &ImportOptions::decimal,
              {{"auto", LT_TEXT("Engine", "automatic")},
               {"point", LT_TEXT("Engine", "point")},
               {"comma", LT_TEXT("Engine", "comma")}},
              {LT_TEXT("Engine", "Decimal mark"),
               LT_TEXT("Engine", "How text files write decimals; automatic asks when 1,234 could be a thousand.")}),
        field("delimiter", &ImportOptions::delimiter,
              {{"auto", LT_TEXT("Engine", "automatic")},
               {"space", LT_TEXT("Engine", "blank")},
               {"comma", LT_TEXT("Engine", "comma")},
               {"semicolon", LT_TEXT("Engine", "semicolon")},
               {"tab", LT_TEXT("Engine", "tabulator")},
               {"pipe", LT_TEXT("Engine", "vertical bar")}},
              {LT_TEXT("Engine", "Separator"), LT_TEXT("Engine", "What stands between the columns of a text file.")}),
        field("encoding", &ImportOptions::encoding,
              {{"auto", LT_TEXT("Engine", "automatic")},
               {"utf-8", {"UTF-8"}},
               {"utf-16le", {"UTF-16 LE"}},
               {"utf-16be", {"UTF-16 BE"}},
               {"latin-1", {"Latin-1"}}},
              {LT_TEXT("Engine", "Encoding"), LT_TEXT("Engine", "How a text file stores its characters.")}),
        field("unit", &ImportOptions::unit,
              {{"auto", LT_TEXT("Engine", "automatic")},
               {"mm", {"mm"}},
               {"m", {"m"}},
               {"inch", {"inch"}},
               {"um", {"µm"}}},
              {LT_TEXT("Engine", "Unit of length"),
               LT_TEXT("Engine", "Unit of a file that states none. A stated unit always rules.")}),
    };
    return all;
}

}  // namespace lathelier::io
