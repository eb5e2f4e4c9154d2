// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/squeeze/series_session.h"
#include "tests/core/session/session_driver.h"

#include <QTemporaryDir>

namespace gripscope::test {

/// What the test of a SeriesSession works on: a library on the disk, an armed fake gripper, the session, by
/// Ada.
template <typename Session>
class SeriesFixture {
protected:
    using State = SeriesSession::State;

    void makeGripper()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_library = std::make_unique<LibraryService>(m_folder->filePath(QStringLiteral("library.db")));
        m_connection = std::make_unique<ArmedConnection>();
    }
    bool makeSession()
    {
        if (!m_connection->open())
            return false;
        m_session = std::make_unique<Session>(m_connection->session, *m_library);
        m_session->setOperator(QStringLiteral("Ada"));
        return true;
    }
    void clear()
    {
        m_session.reset();
        m_connection.reset();
        m_library.reset();
    }

    /// False, too, when the session failed on the way.
    bool until(State state)
    {
        return pollUntil(
                   [this] {
                       m_connection->session.poll();
                       m_session->poll();
                   },
                   [this, state] {
                       return m_session->state() == state || m_session->state() == State::Failed;
                   }) &&
               m_session->state() == state;
    }
    template <typename T>
    T ask(std::function<Expected<T>(Library&)> work)
    {
        return m_library->run<T>(std::move(work)).get().value();
    }
    /// What the library knows of the fake gripper's channels.
    std::optional<MeasuringChainRecord> storedChain()
    {
        using Found = std::optional<MeasuringChainRecord>;
        return ask<Found>([](Library& library) { return library.measuringChain(QStringLiteral("F-1")); });
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<LibraryService> m_library;
    std::unique_ptr<ArmedConnection> m_connection;
    std::unique_ptr<Session> m_session;
};

} // namespace gripscope::test
