// SPDX-License-Identifier: GPL-3.0-or-later
// Who is rung from any thread answers on their own, once for many rings, and not after they went.
#include "tests/support/test_registry.h"
#include "ui/context/doorbell.h"

#include <QCoreApplication>
#include <QTest>
#include <QThread>

#include <optional>
#include <thread>

using namespace gripscope;

class DoorbellTest : public QObject {
    Q_OBJECT
private slots:
    void manyRingsAreOneAnswerOnTheOwnersThread()
    {
        int answered = 0;
        const QThread* where = nullptr;
        const Doorbell bell(this, [&] {
            ++answered;
            where = QThread::currentThread();
        });
        std::thread other([button = bell.button()] {
            for (int i = 0; i < 100; ++i)
                button();
        });
        other.join();
        QCOMPARE(answered, 0); // not before the owner's turn
        QCoreApplication::processEvents();
        QCOMPARE(answered, 1);
        QCOMPARE(where, QThread::currentThread());
        bell.button()();
        QCoreApplication::processEvents();
        QCOMPARE(answered, 2);
    }
    void whoAnswersMayBeRungMeanwhile()
    {
        int answered = 0;
        std::function<void()> button;
        const Doorbell bell(this, [&] {
            if (++answered == 1)
                button();
        });
        button = bell.button();
        button();
        QCoreApplication::processEvents();
        QCoreApplication::processEvents();
        QCOMPARE(answered, 2);
    }
    void aBellThatWentIsNotAnswered()
    {
        int answered = 0;
        std::optional<Doorbell> bell(std::in_place, this, [&] { ++answered; });
        const std::function<void()> button = bell->button();
        button();
        bell.reset();
        button();
        QCoreApplication::processEvents();
        QCOMPARE(answered, 0);
    }
};

GRIPSCOPE_TEST(DoorbellTest)
#include "doorbell_test.moc"
