// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/quality/process/process_names.h"

#include "core/session/process/process_words.h"
#include "ui/format/date_text.h"
#include "ui/format/number_format.h"

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QString indexText(double value)
{
    return QLocale().toString(value, 'f', 2);
}

QString ppmText(double ppm)
{
    return formatNumber(ppm, {}, {}).value;
}

} // namespace

QString ProcessNames::kind(ProcessKind kind)
{
    switch (kind) {
    case ProcessKind::Individuals:
        return tr("Individuals and moving range");
    case ProcessKind::MeanRange:
        return tr("Mean and range");
    case ProcessKind::MeanDeviation:
        return tr("Mean and standard deviation");
    case ProcessKind::Ewma:
        return tr("Moving average (EWMA)");
    case ProcessKind::Cusum:
        return tr("Cumulative sums (CUSUM)");
    case ProcessKind::Hotelling:
        return tr("m, b and k together (T²)");
    }
    return {};
}

QString ProcessNames::rules(RunRules rules)
{
    switch (rules) {
    case RunRules::WesternElectric:
        return tr("Western Electric rules");
    case RunRules::Nelson:
        return tr("Nelson's rules");
    case RunRules::None:
        return tr("Limits only");
    }
    return {};
}

QString ProcessNames::limits(const ProcessSession& session)
{
    const std::optional<FixedLimits>& fixed = session.fixedLimits();
    if (!fixed)
        return tr("Limits from the inspections shown.");
    const QString count = formatCount(fixed->count);
    const QString from = fixed->last > 0
                             ? tr("%1 inspections, %2 to %3").arg(count).arg(fixed->first).arg(fixed->last)
                             : tr("%1 inspections of another station").arg(count);
    if (!session.usesFixed())
        return tr("Limits from the inspections shown; there are fixed ones, from %1.").arg(from);
    const ProcessLimitsRecord& record = *session.fixedRecord();
    return tr("Limits fixed %1 by %2, from %3.")
        .arg(dateText(record.fixed),
             record.operatorName.isEmpty() ? tr("somebody not named") : record.operatorName, from);
}

QString ProcessNames::missing(const ProcessPicture& picture, std::size_t quantity)
{
    const QString symbol = processSymbol(quantity);
    const SharedColumn<double>& column = picture.values->quantities[quantity];
    qsizetype determined = 0;
    for (const std::uint32_t row : picture.rows)
        determined += std::isfinite(column[row]) ? 1 : 0;
    const int needed = 2 * std::max(1, picture.options.size());
    if (picture.rows.empty())
        return tr("No inspection matches the filters.");
    if (determined == 0)
        return tr("%1 was not determined in any of these inspections.").arg(symbol);
    if (determined < needed)
        return tr("%1: %2 inspections; a chart needs at least %3.").arg(symbol).arg(determined).arg(needed);
    const bool joint = picture.options.kind == ProcessKind::Hotelling;
    const Error* const error = joint ? (picture.joint && !*picture.joint ? &picture.joint->error() : nullptr)
                               : picture.charts[quantity] ? nullptr
                                                          : &picture.charts[quantity].error();
    return error != nullptr ? u"%1: %2"_s.arg(joint ? u"T²"_s : symbol, error->describe()) : QString();
}

QString ProcessNames::time(const ProcessValues& values, std::uint32_t row)
{
    return timeText(QDateTime::fromMSecsSinceEpoch(values.times_ms[row]));
}

std::vector<ControlPanel> ProcessNames::panels(const ProcessPicture& picture, std::size_t quantity)
{
    using What = ControlPanel::What;
    std::vector<ControlPanel> panels;
    if (picture.options.kind == ProcessKind::Hotelling) {
        panels.push_back({What::Joint, 2});
    } else if (quantity >= allQuantities) {
        for (std::size_t i = 0; i < allQuantities; ++i)
            panels.push_back({What::Location, i});
    } else {
        panels.push_back({What::Location, quantity});
        if (takesRules(picture.options.kind))
            panels.push_back({What::Spread, quantity});
    }
    std::erase_if(panels, [&picture](const ControlPanel& panel) {
        return ControlSeries(picture, panel).points() == 0;
    });
    return panels;
}

std::vector<CapabilityLine> CapabilityNumbers::of(const ProcessCapability& capability)
{
    std::vector<CapabilityLine> lines;
    const auto add = [&lines](const QString& name, const std::optional<CapabilityIndex>& index) {
        if (index)
            lines.push_back(
                {name, indexText(index->value),
                 tr("%1 to %2").arg(indexText(index->interval.lower), indexText(index->interval.upper))});
    };
    if (capability.percentiles) {
        add(tr("Pp (percentiles)"), capability.percentiles->spread);
        add(tr("Ppk (percentiles)"), capability.percentiles->nearest);
    }
    const Capability* const found = capability.boxCox   ? &capability.boxCox->capability
                                    : capability.normal ? &*capability.normal
                                                        : nullptr;
    if (found == nullptr)
        return lines;
    const QString more = capability.boxCox ? tr(" (Box-Cox)") : QString();
    add(u"Cp"_s + more, found->within.spread);
    add(u"Cpk"_s + more, found->within.nearest);
    add(u"Pp"_s + more, found->overall.spread);
    add(u"Ppk"_s + more, found->overall.nearest);
    if (!capability.boxCox)
        add(u"Cpm"_s, found->target);
    return lines;
}

QStringList CapabilityNumbers::sentences(const ProcessCapability& capability)
{
    if (!capability.normal)
        return {tr("No tolerance limits: type them here, or give the type its own. The histogram shows how "
                   "the values lie.")};
    const Capability& normal = *capability.normal;
    QStringList sentences{capabilityVerdict(*capability.verdictIndex()).describe()};
    const Capability& told = capability.boxCox ? capability.boxCox->capability : normal;
    sentences << (capability.percentiles
                      ? tr("Beyond the limits: %1 ppm observed.").arg(ppmText(normal.observedPpm))
                      : tr("Beyond the limits: %1 ppm expected, %2 ppm observed.")
                            .arg(ppmText(told.overall.expectedPpm), ppmText(normal.observedPpm)));
    if (!normal.normality)
        sentences << tr("Too few values to tell whether they are normal.");
    else if (normal.normality->p >= 0.05)
        sentences << tr("Nothing speaks against normal values (Anderson-Darling, p %1).")
                         .arg(QLocale().toString(normal.normality->p, 'g', 2));
    else
        sentences << tr("The values are not normal (Anderson-Darling, p %1).")
                         .arg(QLocale().toString(normal.normality->p, 'g', 2));
    if (capability.boxCox)
        sentences << tr("To the power of %1 they are: the indices are of these (Box-Cox).")
                         .arg(QLocale().toString(capability.boxCox->lambda, 'g', 3));
    if (capability.percentiles)
        sentences << tr("The verdict goes by their percentiles, which need no distribution.")
                  << described(capability.percentiles->messages);
    return sentences;
}

} // namespace gripscope
