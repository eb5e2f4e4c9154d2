// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/layout_pages.h"

using namespace gripscope::test;

// Every page, in the state that the tour shows and when it is empty, in every theme and size, with a message
// and without: nothing is cut, nothing lies over another thing, all can be read, hit and named.

class LayoutTest : public QObject {
    Q_OBJECT

    static QString message() { return QStringLiteral("Something went wrong. Do this, then try again."); }

private slots:
    void aPageAtWork_data() { pageRows(); }
    void aPageAtWork() { walkPageAtWork(message()); }

    void anEmptyPage_data() { pageRows(); }
    void anEmptyPage() { walkEmptyPage(message()); }
};

GRIPSCOPE_TEST(LayoutTest)
#include "layout_test.moc"
