// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/ledger/row_digest.h"

#include "core/base/byte_writer.h"

#include <bit>
#include <sodium.h>

namespace gripscope {

namespace {

std::optional<double> numberIn(const Cell& cell)
{
    if (const auto* number = std::get_if<double>(&cell))
        return *number;
    if (const auto* integer = std::get_if<qint64>(&cell))
        return static_cast<double>(*integer);
    return {};
}

/// A default may be spelled 0 where the column keeps 0.0.
bool isDefault(const Cell& value, const Cell& fallback)
{
    if (value.index() == fallback.index())
        return value == fallback;
    const auto number = numberIn(value);
    return number && number == numberIn(fallback);
}

void write(ByteWriter& out, const Cell& cell)
{
    if (const auto* integer = std::get_if<qint64>(&cell))
        out.plain("i").number(*integer);
    else if (const auto* number = std::get_if<double>(&cell))
        out.plain("d").number(std::bit_cast<quint64>(*number == 0 ? 0.0 : *number));
    else if (const auto* text = std::get_if<QString>(&cell))
        out.plain("t").text(*text);
    else if (const auto* bytes = std::get_if<QByteArray>(&cell))
        out.plain("b").counted(*bytes);
    else
        out.plain("n");
}

} // namespace

QByteArray digestOf(QByteArrayView bytes)
{
    static_assert(crypto_hash_sha256_BYTES == digestSize);
    QByteArray digest(digestSize, Qt::Uninitialized);
    crypto_hash_sha256(reinterpret_cast<unsigned char*>(digest.data()),
                       reinterpret_cast<const unsigned char*>(bytes.data()),
                       static_cast<unsigned long long>(bytes.size()));
    return digest;
}

QByteArray rowDigest(const std::vector<Column>& columns, const TableRows::Row& row)
{
    ByteWriter out;
    for (std::size_t i = 0; i < columns.size() && i < row.size(); ++i) {
        if (isDefault(row[i], columns[i].fallback))
            continue;
        out.text(columns[i].name);
        write(out, row[i]);
    }
    return digestOf(out.bytes());
}

} // namespace gripscope
