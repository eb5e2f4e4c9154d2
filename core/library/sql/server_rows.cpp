// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/sql/server_rows.h"

#include <QSqlError>
#include <QSqlRecord>
#include <QVariant>

#include <atomic>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr int fewRows = 16;
constexpr int manyRows = 1024;

QString literal(std::string_view text)
{
    QString quoted = QString::fromUtf8(text.data(), qsizetype(text.size()));
    return u'\'' + quoted.replace(u'\'', u"''"_s) + u'\'';
}

} // namespace

ServerRows::ServerRows(Database& database, QString doing, const QString& sql)
    : m_database(database), m_doing(std::move(doing)), m_sql(database.dialect().spelled(sql)),
      m_rows(database.connection())
{
    static std::atomic<quint64> counter{0};
    m_name = u"gripscope_rows_%1"_s.arg(++counter);
}

ServerRows::~ServerRows()
{
    if (!m_error) // else the transaction is at its end
        close();
}

void ServerRows::close()
{
    if (std::exchange(m_declared, false))
        static_cast<void>(m_database.execute(u"CLOSE "_s + m_name, m_doing));
}

void ServerRows::restart(std::initializer_list<std::string_view> texts)
{
    if (m_error)
        return;
    close();
    QString sql = u"DECLARE %1 NO SCROLL CURSOR FOR "_s.arg(m_name);
    const QStringList parts = m_sql.split(u'?');
    auto text = texts.begin();
    for (qsizetype i = 0; i < parts.size(); ++i)
        sql += (i == 0 ? QString() : literal(text != texts.end() ? *text++ : std::string_view())) + parts[i];
    if (const auto declared = m_database.execute(sql, m_doing); !declared)
        m_error = declared.error();
    m_declared = !m_error;
    m_atOnce = fewRows;
    m_left = 0;
    m_rows.clear();
}

bool ServerRows::fetch()
{
    if (!m_rows.exec(u"FETCH %1 FROM %2"_s.arg(m_atOnce).arg(m_name))) {
        m_error = m_database.error(m_rows.lastError(), m_doing).value();
        return false;
    }
    m_left = m_atOnce;
    m_atOnce = manyRows;
    if (m_texts.empty()) // to ask for each row takes longer than to read it
        m_texts.resize(std::size_t(m_rows.record().count()));
    return true;
}

bool ServerRows::next()
{
    for (QByteArray& text : m_texts)
        text.clear();
    if (m_error || !m_declared)
        return false;
    if (m_left == 0 && !fetch())
        return false;
    --m_left;
    if (m_rows.next())
        return true;
    close(); // fewer came than were asked for: another step does not begin anew
    return false;
}

std::string_view ServerRows::text(int column) const
{
    QByteArray& text = m_texts[std::size_t(column)];
    if (text.isNull())
        text = m_rows.value(column).toString().toUtf8();
    return {text.constData(), std::size_t(text.size())};
}

qint64 ServerRows::integer(int column) const
{
    return m_rows.value(column).toLongLong();
}

std::optional<double> ServerRows::real(int column) const
{
    const QVariant value = m_rows.value(column);
    const double number = value.toDouble();
    return value.isNull() || !std::isfinite(number) ? std::nullopt : std::optional(number);
}

} // namespace gripscope
