// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/layout_pages.h"
#include "ui/context/language.h"

using namespace Qt::StringLiterals;
using namespace gripscope::test;

/// German words are longer: they fit too.
class GermanLayoutTest : public QObject {
    Q_OBJECT

    static QString message() { return u"Etwas ging schief. Tun Sie dies, dann versuchen Sie es erneut."_s; }

private slots:
    void init() { QVERIFY(gripscope::applyLanguage(u"de"_s)); }
    void cleanup() { QVERIFY(gripscope::applyLanguage(u"en"_s)); }

    void aPageAtWork_data() { pageRows(); }
    void aPageAtWork() { walkPageAtWork(message()); }

    void anEmptyPage_data() { pageRows(); }
    void anEmptyPage() { walkEmptyPage(message()); }
};

GRIPSCOPE_TEST(GermanLayoutTest)
#include "german_layout_test.moc"
