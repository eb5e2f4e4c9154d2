// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/ledger/ledger_leaf.h"

#include "core/base/byte_writer.h"
#include "core/library/ledger/row_digest.h"

#include <QUuid>

namespace gripscope {

namespace {

constexpr qsizetype uuidSize = 16;

void writeKey(ByteWriter& out, const Cell& key)
{
    if (const auto* integer = std::get_if<qint64>(&key)) {
        out.plain("i").number(*integer);
        return;
    }
    const QString text = keyText(key);
    const QUuid uuid = QUuid::fromString(text);
    if (!uuid.isNull() && uuid.toString(QUuid::WithoutBraces) == text)
        out.plain("u").plain(uuid.toRfc4122());
    else
        out.plain("t").text(text);
}

/// Takes bytes from the front; whatever is asked for behind the end is empty, and it has failed then.
class Reader {
public:
    explicit Reader(QByteArrayView bytes) : m_rest(bytes) {}
    QByteArrayView take(quint64 count)
    {
        if (count > static_cast<quint64>(m_rest.size())) {
            m_failed = true;
            return {};
        }
        const QByteArrayView taken = m_rest.first(static_cast<qsizetype>(count));
        m_rest = m_rest.sliced(static_cast<qsizetype>(count));
        return taken;
    }
    template <typename Number>
    Number number()
    {
        const QByteArrayView bytes = take(sizeof(Number));
        return m_failed ? Number{} : qFromBigEndian<Number>(bytes.data());
    }
    [[nodiscard]] bool failed() const { return m_failed; }
    [[nodiscard]] bool atEnd() const { return m_rest.isEmpty(); }

private:
    QByteArrayView m_rest;
    bool m_failed = false;
};

std::optional<Cell> readKey(Reader& in)
{
    switch (in.number<char>()) {
    case 'u':
        return QUuid::fromRfc4122(in.take(uuidSize)).toString(QUuid::WithoutBraces);
    case 't':
        return QString::fromUtf8(in.take(in.number<quint64>()));
    case 'i':
        return in.number<qint64>();
    default:
        return {};
    }
}

} // namespace

QByteArray packed(const std::vector<LedgerLeaf>& leaves)
{
    ByteWriter out;
    for (const LedgerLeaf& leaf : leaves) {
        out.number(leaf.table);
        writeKey(out, leaf.key);
        out.plain(leaf.digest);
    }
    return out.bytes();
}

std::optional<std::vector<LedgerLeaf>> unpackedLeaves(const QByteArray& bytes)
{
    std::vector<LedgerLeaf> leaves;
    Reader in(bytes);
    while (!in.atEnd()) {
        LedgerLeaf leaf;
        leaf.table = in.number<quint8>();
        const std::optional<Cell> key = readKey(in);
        leaf.digest = in.take(digestSize).toByteArray();
        if (!key || in.failed())
            return {};
        leaf.key = *key;
        leaves.push_back(std::move(leaf));
    }
    return leaves;
}

QString keyText(const Cell& key)
{
    if (const auto* integer = std::get_if<qint64>(&key))
        return QString::number(*integer);
    const auto* text = std::get_if<QString>(&key);
    return text ? *text : QString();
}

} // namespace gripscope
