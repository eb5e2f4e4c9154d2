// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QString>

namespace gripscope {

/// What core and devices say to a person: `Words::tr("The type needs a name.")`, or
/// QT_TRANSLATE_NOOP("Words",
/// "...") where the words are a constant that Words::tr() gets later. English where no translator is
/// installed, as on the command line.
class Words {
    Q_DECLARE_TR_FUNCTIONS(Words)
public:
    /// As QString::number(), with the decimal sign of QLocale(): for sentences, never for documents.
    [[nodiscard]] static QString number(double value, char format = 'g', int digits = 6);
};

} // namespace gripscope
