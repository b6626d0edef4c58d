// Tables of results by their description (engine/core/quantities.h): the caller says which keys, in which order.
#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <vector>

#include "engine/core/quantities.h"
#include "engine/report/cells.h"
#include "engine/report/document.h"

namespace lathelier::report {

/// Name, value, unit of the quantities `keys` of one result. A key unknown to R is std::logic_error.
template <class R>
std::vector<Quantity> quantityRows(const R& result, std::initializer_list<const char*> keys)
{
    std::vector<Quantity> rows;
    for (const char* key : keys) {
        const QuantityOf<R>& quantity = quantityOf<R>(key);
        rows.push_back({quantity.info.label, quantity.get(result), quantity.info.unit, quantity.info.decimals});
    }
    return rows;
}

template <class R>
QuantityTable quantityTable(Caption title, const R& result, std::initializer_list<const char*> keys)
{
    return {std::move(title), quantityRows(result, keys)};
}

/// One row for each of `items`, one column for each key, with the unit in its heading. A key unknown to R is
/// std::logic_error.
template <class R>
Table listTable(Caption title, std::span<const R> items, const std::vector<const char*>& keys)
{
    Table table{std::move(title), {}, {}, {}};
    std::vector<const QuantityOf<R>*> columns;
    for (const char* key : keys) {
        columns.push_back(&quantityOf<R>(key));
        const QuantityInfo& info = columns.back()->info;
        table.columns.push_back(Labelled{info.heading.empty() ? info.label : info.heading, info.unit});
        table.decimals.push_back(info.decimals);
    }
    for (const R& item : items) {
        std::vector<Value>& row = table.rows.emplace_back();
        for (const QuantityOf<R>* column : columns) row.push_back(column->get(item));
    }
    return table;
}

/// A column of CSV: the key, and its heading where it differs.
struct CsvColumn {
    const char* key;
    const char* heading;  ///< first line of the file
    CsvColumn(const char* of) : key(of), heading(of) {}
    CsvColumn(const char* of, const char* named) : key(of), heading(named) {}
};

/// The same table as CSV: decimal point, comma, full precision; missing values are empty.
template <class R>
std::string csvOf(std::span<const R> items, std::initializer_list<CsvColumn> columns)
{
    std::string out;
    for (const CsvColumn& column : columns) out.append(out.empty() ? "" : ",").append(column.heading);
    for (const R& item : items) {
        char before = '\n';
        for (const CsvColumn& column : columns) {
            out += before;
            out += csvCell(quantityOf<R>(column.key).get(item));
            before = ',';
        }
    }
    return out + '\n';
}

}  // namespace lathelier::report
