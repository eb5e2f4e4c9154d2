// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/people/secret.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace Qt::StringLiterals;
using namespace gripscope;

/// PINs and passwords are hashed, judged and wiped.
class SecretTest : public QObject {
    Q_OBJECT
private slots:
    void theHashIsArgon2idAndNeverTheSecret()
    {
        const Secret secret(u"correct horse"_s);
        const auto one = hashOf(secret);
        const auto other = hashOf(secret);
        QVERIFY(one && other);
        QVERIFY2(one->startsWith("$argon2id$v=19$m=65536,t=2,"_L1), qPrintable(*one));
        QVERIFY(!one->contains(u"horse"_s));
        QVERIFY(*one != *other); // each has a salt of its own
        QVERIFY(matches(secret, *one) && matches(secret, *other));
        QVERIFY(!matches(Secret(u"correct horsf"_s), *one));
        QVERIFY(!matches(Secret(u""_s), *one));
        QVERIFY(!matches(secret, u"not a hash"_s));
    }
    void whatIsTooShortIsRefusedInWords_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<bool>("will");
        QTest::newRow("empty") << u""_s << false;
        QTest::newRow("5 digits") << u"12345"_s << false;
        QTest::newRow("6 digits") << u"123456"_s << true;
        QTest::newRow("7 letters") << u"abcdefg"_s << false;
        QTest::newRow("8 letters") << u"abcdefgh"_s << true;
        QTest::newRow("7 letters of two bytes") << u"äöüäöüä"_s << false;
        QTest::newRow("8 letters of two bytes") << u"äöüäöüäö"_s << true;
        QTest::newRow("digits and a letter") << u"12345a"_s << false;
        QTest::newRow("128") << QString(128, u'x') << true;
        QTest::newRow("129") << QString(129, u'x') << false;
    }
    void whatIsTooShortIsRefusedInWords()
    {
        QFETCH(QString, text);
        QFETCH(bool, will);
        QCOMPARE(!Secret(text).problem().has_value(), will);
    }
    void textIsWipedWhereItIsSharedToo()
    {
        QString text = u"123456 "_s + QString::number(7); // of its own, not a literal
        const QString shared = text;
        wipe(text);
        QVERIFY(text.isEmpty());
        QCOMPARE(shared, QString(8, QChar(0)));
    }
};

GRIPSCOPE_TEST(SecretTest)
#include "secret_test.moc"
