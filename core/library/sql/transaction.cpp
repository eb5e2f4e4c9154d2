// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/library/sql/database.h"

namespace gripscope {

using namespace Qt::StringLiterals;

Expected<void> Database::begin(const QStringList& statements, const QString& doing)
{
    RETURN_IF_ERROR(reconnectIfLost());
    m_inTransaction = true;
    m_failed = false;
    m_newAuditHead.reset();
    m_inserted.clear();
    for (const QString& statement : statements) {
        auto begun = execute(statement, doing);
        if (!begun && m_lost) { // an idle connection that the server had ended: nothing was under way
            m_inTransaction = m_failed = false;
            RETURN_IF_ERROR(reconnectIfLost());
            m_inTransaction = true;
            begun = execute(statement, doing);
        }
        if (!begun) {
            if (isOnServer()) // it has begun, and failed to take the lock
                rollBack(doing);
            m_inTransaction = false;
            return begun;
        }
    }
    return {};
}

Expected<void> Database::commit(const QString& doing)
{
    if (m_failed || m_lost) // a server would take COMMIT for ROLLBACK, and say that all is well
        return failure(ErrorCode::StorageFailed, {doing, Words::tr("a step of it failed on the server")});
    auto done = execute(u"COMMIT"_s, doing);
    m_inTransaction = !done && !m_lost;
    return done;
}

void Database::rollBack(const QString& doing)
{
    if (!m_lost) // with the connection it is gone already
        static_cast<void>(execute(u"ROLLBACK"_s, doing));
    m_inTransaction = m_failed = false;
}

Expected<std::unique_ptr<ReadTransaction>> ReadTransaction::begin(Database& database, const QString& doing)
{
    RETURN_IF_ERROR(database.begin({database.dialect().beginReading()}, doing));
    return std::unique_ptr<ReadTransaction>(new ReadTransaction(database, doing));
}

ReadTransaction::~ReadTransaction()
{
    m_database.rollBack(m_doing); // there is nothing that could be lost
}

Expected<std::unique_ptr<Transaction>> Transaction::begin(Database& database, const QString& doing)
{
    RETURN_IF_ERROR(database.requireSameFile(doing));
    RETURN_IF_ERROR(database.begin(database.dialect().beginWriting(), doing));
    return std::unique_ptr<Transaction>(new Transaction(database, doing));
}

Transaction::~Transaction()
{
    if (m_open) // an error here means that it is rolled back already
        m_database.rollBack(m_doing);
}

Expected<void> Transaction::commit()
{
    const bool wasLost = m_database.isLost();
    auto done = m_database.commit(m_doing);
    m_answerLost = !done && !wasLost && m_database.isLost();
    m_open = !done && !m_answerLost;
    return done ? m_database.requireSameFile(m_doing) : done;
}

} // namespace gripscope
