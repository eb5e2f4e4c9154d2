// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/finding.h"

#include <QCoreApplication>

namespace gripscope {

/// What core and devices say to a person. Core says values: `Words::say("The type needs a name.")`, worded by
/// Finding::describe() at the edge; where the words are a constant: QT_TRANSLATE_NOOP("Words", "...").
/// English where no translator is installed, as on the command line.
class Words {
    Q_DECLARE_TR_FUNCTIONS(Words)
public:
    /// The sentence, by its English, which is a literal that translators are shown.
    [[nodiscard]] static Finding say(const char* sentence);

    /// The one of `sentences`, their places open, that `english` says, filled in; else the text as it is.
    [[nodiscard]] static Finding heard(const Findings& sentences, const QString& english);

    /// As QString::number(), with the decimal sign of QLocale(): for sentences, never for documents.
    [[nodiscard]] static QString number(double value, char format = 'g', int digits = 6);
};

} // namespace gripscope
