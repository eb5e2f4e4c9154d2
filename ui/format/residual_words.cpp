// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/format/residual_words.h"

#include "core/base/words.h"

#include <QCoreApplication>

#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr double usualLevel = 0.005;

QString residualWord(const char* text)
{
    return QCoreApplication::translate("gripscope::ResidualWords", text);
}

const ValidityCheck* findCheck(const Identification& identification, const QString& id)
{
    for (const ValidityCheck& check : identification.validity.checks)
        if (check.id == id)
            return &check;
    return nullptr;
}

ResidualFinding finding(std::optional<double> p, const ValidityCheck* check, bool recommended,
                        const QString& good, const QString& bad)
{
    if (!p || !std::isfinite(*p))
        return {};
    const bool stated = check && check->limit && *check->limit > 0 && *check->limit < 1;
    const bool rejected = *p < (stated ? *check->limit : usualLevel);
    const bool passed = recommended && check && check->ok;
    return {u"%1, %2"_s.arg(rejected ? bad : good, pValueText(*p)), rejected && !passed};
}

} // namespace

QString pValueText(double p)
{
    if (!std::isfinite(p))
        return {};
    if (p < 0.001)
        return u"p < 0.001"_s;
    return u"p = %1"_s.arg(Words::number(p, 'f', p < 0.0995 ? 3 : 2));
}

ResidualFindings residualFindings(const Identification& identification, const Estimate* estimate)
{
    if (!estimate || estimate->residual.empty())
        return {};
    const ResidualSummary& residuals = estimate->residuals;
    const bool recommended = estimate->estimator == identification.recommended;
    const bool modelled = estimate->noise && !estimate->noise->coefficients.empty();
    return {finding(residuals.whitenessP, findCheck(identification, u"residual_whiteness"_s), recommended,
                    residualWord(QT_TRANSLATE_NOOP("gripscope::ResidualWords", "white")),
                    modelled
                        ? residualWord(QT_TRANSLATE_NOOP("gripscope::ResidualWords", "modelled, not white"))
                        : residualWord(QT_TRANSLATE_NOOP("gripscope::ResidualWords", "not white"))),
            finding(residuals.inputIndependenceP, findCheck(identification, u"input_independence"_s),
                    recommended, residualWord(QT_TRANSLATE_NOOP("gripscope::ResidualWords", "independent")),
                    residualWord(QT_TRANSLATE_NOOP("gripscope::ResidualWords", "dependent")))};
}

} // namespace gripscope
