// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/residual_words.h"

#include <QCoreApplication>
#include <QLocale>

#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr double usualLevel = 0.005;

QString words(const char* text)
{
    return QCoreApplication::translate("gripscope::ResidualWords", text);
}

double levelOf(const Identification& identification, const QString& check)
{
    for (const ValidityCheck& one : identification.validity.checks)
        if (one.id == check && one.limit && *one.limit > 0 && *one.limit < 1)
            return *one.limit;
    return usualLevel;
}

ResidualFinding finding(std::optional<double> p, double level, const QString& good, const QString& bad)
{
    if (!p || !std::isfinite(*p))
        return {};
    const bool doubtful = *p < level;
    return {u"%1, %2"_s.arg(doubtful ? bad : good, pValueText(*p)), doubtful};
}

} // namespace

QString pValueText(double p)
{
    if (!std::isfinite(p))
        return {};
    if (p < 0.001)
        return u"p < 0.001"_s;
    return u"p = %1"_s.arg(QLocale::c().toString(p, 'f', p < 0.0995 ? 3 : 2));
}

ResidualFindings residualFindings(const Identification& identification, const Estimate* estimate)
{
    if (!estimate || estimate->residual.empty())
        return {};
    const ResidualSummary& residuals = estimate->residuals;
    return {finding(residuals.whitenessP, levelOf(identification, u"residual_whiteness"_s),
                    words(QT_TRANSLATE_NOOP("gripscope::ResidualWords", "white")),
                    words(QT_TRANSLATE_NOOP("gripscope::ResidualWords", "not white"))),
            finding(residuals.inputIndependenceP, levelOf(identification, u"input_independence"_s),
                    words(QT_TRANSLATE_NOOP("gripscope::ResidualWords", "independent")),
                    words(QT_TRANSLATE_NOOP("gripscope::ResidualWords", "dependent")))};
}

} // namespace gripscope
