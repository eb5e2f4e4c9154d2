// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/ledger/library_witness.h"
#include "core/library/verification/library_verification.h"
#include "core/session/inspect/inspect_session.h"
#include "tests/devices/port_helpers.h"
#include "tests/support/test_registry.h"

#include <QFileInfo>
#include <QTemporaryDir>
#include <QTest>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

constexpr int inspections = 40;
/// 17 kB: a million of them are 17 GB. The raw record of a second takes most of it.
constexpr qint64 mostBytes = 17'000;

/// A session on the virtual gripper, whose channels come in whole counts, as a device sends them.
class InspectingSession {
public:
    explicit InspectingSession(const QString& libraryFile)
        : m_library(libraryFile), m_connection(m_factory), m_inspect(m_connection, m_library)
    {
        m_inspect.setEarlyEnd(false); // each is as long as the recipe says
    }

    [[nodiscard]] bool run()
    {
        if (!m_connection.connectTo(u"virtual:?object=A&seed=5&speed=0"_s) ||
            !until([&] { return m_connection.state() == ConnectSession::State::Connected; }) ||
            !m_connection.arm(u"Ada"_s) || !until([&] { return m_connection.armed(); }))
            return false;
        m_inspect.setOperator(u"Ada"_s);
        m_inspect.setExpectedType(u"A"_s);
        const auto ready = [&] {
            return m_inspect.state() == InspectSession::State::Ready && m_inspect.unstored() == 0;
        };
        for (int i = 0; i < inspections; ++i)
            if (!until(ready) || !m_inspect.squeeze() || !until(ready) || m_inspect.result()->number == 0)
                return false;
        m_connection.disconnect();
        return true;
    }
    [[nodiscard]] std::size_t samples() const { return m_inspect.result()->recording.size(); }

private:
    bool until(const std::function<bool()>& done)
    {
        return waitFor([&] {
            m_connection.poll();
            m_inspect.poll();
            return done();
        });
    }

    DeviceFactory m_factory;
    LibraryService m_library;
    ConnectSession m_connection;
    InspectSession m_inspect;
};

/// With the log brought into it.
qint64 closedSize(const QString& file)
{
    return Library::open(file).has_value() ? QFileInfo(file).size() : 0;
}

} // namespace

/// What an inspection takes in the library's file, recording, estimates and ledger included.
class InspectionSizeTest : public QObject {
    Q_OBJECT
private slots:
    void anInspectionOfTheDefaultRecipeTakesAtMostSoManyBytes()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(u"library.db"_s);
        QVERIFY(Library::open(file).value()->loadExampleTypes());
        const qint64 before = closedSize(file);
        {
            InspectingSession session(file);
            QVERIFY(session.run());
            QVERIFY(session.samples() >= 2000); // a second, 2 kHz
        }
        const qint64 each = (closedSize(file) - before) / inspections;
        QVERIFY2(each > 0 && each <= mostBytes, qPrintable(QString::number(each)));
        const auto found = verifyLibrary(file); // the ledger has them all
        QVERIFY(found && found->whole());
        QFile::remove(witnessFile(file));
    }
};

GRIPSCOPE_TEST(InspectionSizeTest)
#include "inspection_size_test.moc"
