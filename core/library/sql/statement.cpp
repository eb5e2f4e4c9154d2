// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/sql/statement.h"

#include "core/base/words.h"
#include "core/library/sql/time_ordered_id.h"

#include <QCryptographicHash>
#include <QSqlError>
#include <QSysInfo>
#include <QTimeZone>
#include <QVariant>

#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// The table that a statement puts rows into; empty where it does something else.
QString insertedInto(const QString& sql)
{
    constexpr auto begins = "INSERT INTO "_L1;
    if (!sql.startsWith(begins))
        return {};
    const QString rest = sql.mid(begins.size());
    return rest.left(rest.indexOf(u' '));
}

} // namespace

Statement::Statement(Database& database, QString doing, const QString& sql)
    : m_database(database), m_doing(std::move(doing)), m_insertsInto(insertedInto(sql)),
      m_query(database.connection())
{
    const SqlDialect& dialect = database.dialect();
    m_query.setForwardOnly(dialect.streams());
    const QString spelled = dialect.spelled(m_insertsInto.isEmpty() ? sql : sql + dialect.answersRowNumber());
    m_prepared = prepare(spelled);
    if (!m_prepared && database.isLost()) // a server that had ended an idle connection: nothing was under way
        m_prepared = prepare(spelled);
}

bool Statement::prepare(const QString& sql)
{
    if (auto connected = m_database.reconnectIfLost(); !connected) {
        m_problem = connected.error();
        return false;
    }
    m_problem.reset();
    if (m_query.prepare(sql))
        return true;
    m_problem = m_database.error(m_query.lastError(), m_doing).value();
    return false;
}

void Statement::refuseUnlessTaken(const QString& text)
{
    if (!m_problem)
        m_problem = m_database.whyNotStored(text, m_doing);
}

Statement& Statement::bind(const QString& text)
{
    refuseUnlessTaken(text);
    m_query.addBindValue(text.isNull() ? u""_s : text); // Qt takes a null string for NULL
    return *this;
}

Statement& Statement::bindOrNull(const QString& text)
{
    refuseUnlessTaken(text);
    m_query.addBindValue(text.isEmpty() ? QVariant(QMetaType::fromType<QString>()) : QVariant(text));
    return *this;
}

Statement& Statement::bind(double number)
{
    m_query.addBindValue(m_database.dialect().bound(number));
    return *this;
}

Statement& Statement::bind(const std::optional<double>& number)
{
    m_query.addBindValue(number ? m_database.dialect().bound(*number)
                                : QVariant(QMetaType::fromType<double>()));
    return *this;
}

Statement& Statement::bind(qint64 number)
{
    m_query.addBindValue(number);
    return *this;
}

Statement& Statement::bindOptional(const std::optional<qint64>& number)
{
    m_query.addBindValue(number ? QVariant(*number) : QVariant(QMetaType::fromType<qint64>()));
    return *this;
}

Statement& Statement::bindOptional(const std::optional<QString>& text)
{
    if (text)
        return bind(*text);
    m_query.addBindValue(QVariant(QMetaType::fromType<QString>()));
    return *this;
}

Statement& Statement::bindBytes(const QByteArray& bytes)
{
    m_query.addBindValue(bytes);
    return *this;
}

Expected<void> Statement::run()
{
    if (m_problem)
        return tl::unexpected(*m_problem);
    if (!m_prepared || !m_query.exec())
        return m_database.error(m_query.lastError(), m_doing);
    if (m_insertsInto.isEmpty() || m_query.numRowsAffected() != 1)
        return {};
    if (!m_database.isOnServer())
        m_database.noteInserted({m_insertsInto, m_query.lastInsertId().toLongLong()});
    else if (m_query.next())
        m_database.noteInserted({m_insertsInto, m_query.value(0).toLongLong()});
    return {};
}

Expected<void> Statement::forEach(const std::function<void(Statement&)>& row)
{
    RETURN_IF_ERROR(run());
    while (m_query.next()) {
        m_column = 0;
        row(*this);
    }
    if (m_query.lastError().isValid())
        return m_database.error(m_query.lastError(), m_doing);
    m_query.finish();
    return {};
}

QString Statement::takeText()
{
    return m_query.value(m_column++).toString();
}

std::optional<QString> Statement::takeOptionalText()
{
    const QVariant value = m_query.value(m_column++);
    return value.isNull() ? std::nullopt : std::optional(value.toString());
}

double Statement::takeReal()
{
    return m_query.value(m_column++).toDouble();
}

std::optional<double> Statement::takeOptionalReal()
{
    const QVariant value = m_query.value(m_column++);
    const double number = value.toDouble();
    // An infinity got in past this program: it is no number to count with.
    return value.isNull() || !std::isfinite(number) ? std::nullopt : std::optional(number);
}

qint64 Statement::takeInteger()
{
    return m_query.value(m_column++).toLongLong();
}

std::optional<qint64> Statement::takeOptionalInteger()
{
    const QVariant value = m_query.value(m_column++);
    return value.isNull() ? std::nullopt : std::optional<qint64>(value.toLongLong());
}

QByteArray Statement::takeBytes()
{
    return m_query.value(m_column++).toByteArray();
}

QDateTime Statement::takeUtc()
{
    return QDateTime::fromString(takeText(), Qt::ISODateWithMs);
}

QString utcText(const QDateTime& time)
{
    return time.toUTC().toString(Qt::ISODateWithMs);
}

QString stationId()
{
    static const QString id = [] {
        const QByteArray machine = "gripscope station " + QSysInfo::machineUniqueId();
        const QByteArray digits =
            QCryptographicHash::hash(machine, QCryptographicHash::Sha256).toHex().left(8);
        return QSysInfo::machineHostName() + u'-' + QString::fromLatin1(digits);
    }();
    return id;
}

RowStamp RowStamp::now()
{
    return {newTimeOrderedId(), stationId(), utcText(QDateTime::currentDateTimeUtc())};
}

} // namespace gripscope
