// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/context/language.h"

#include <QTest>

namespace gripscope::test {

/// Rows for both languages: German words are longer.
inline void languageRows()
{
    QTest::addColumn<QString>("language");
    for (const char* language : {"en", "de"})
        QTest::newRow(language) << QString::fromLatin1(language);
}

/// The program in the language of the row, for as long as this is there.
class RowLanguage {
public:
    RowLanguage()
    {
        QFETCH(QString, language);
        if (!applyLanguage(language))
            qFatal("there are no words in that language");
    }
    ~RowLanguage() { (void)applyLanguage(QStringLiteral("en")); }
    RowLanguage(const RowLanguage&) = delete;
    RowLanguage& operator=(const RowLanguage&) = delete;
};

} // namespace gripscope::test
