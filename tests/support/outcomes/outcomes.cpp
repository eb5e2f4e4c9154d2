// SPDX-License-Identifier: GPL-3.0-or-later
// Classes that end in every way; outcome_test.cpp looks at what ctest makes of them.
#include "tests/support/test_registry.h"

class Passes : public QObject {
    Q_OBJECT
private slots:
    void well() { QVERIFY(true); }
};

class Skips : public QObject {
    Q_OBJECT
private slots:
    void well() { QVERIFY(true); }
    void notHere() { QSKIP("there is no such thing here"); }
};

class SkipsAll : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { QSKIP("there is no such thing here"); }
    void well() { QVERIFY(true); }
};

class FailsAndSkips : public QObject {
    Q_OBJECT
private slots:
    void badly() { QVERIFY(false); }
    void notHere() { QSKIP("there is no such thing here"); }
};

/// As many as the skip's own status, and as many as a status has no room for.
class FailsOften : public QObject {
    Q_OBJECT
protected:
    explicit FailsOften(int times) : m_times(times) {}

private slots:
    void badly_data()
    {
        QTest::addColumn<int>("number");
        for (int i = 0; i < m_times; ++i)
            QTest::addRow("%d", i) << i;
    }
    void badly() { QVERIFY(false); }

private:
    int m_times;
};
class Fails77 : public FailsOften {
    Q_OBJECT
public:
    Fails77() : FailsOften(77) {}
};
class Fails256 : public FailsOften {
    Q_OBJECT
public:
    Fails256() : FailsOften(256) {}
};

GRIPSCOPE_TEST(Passes)
GRIPSCOPE_TEST(Skips)
GRIPSCOPE_TEST(SkipsAll)
GRIPSCOPE_TEST(FailsAndSkips)
GRIPSCOPE_TEST(Fails77)
GRIPSCOPE_TEST(Fails256)
#include "outcomes.moc"
