// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/line/bounded_number.h"
#include "app/cli/line/command_line.h"
#include "app/cli/line/commands.h"
#include "app/cli/line/output.h"
#include "app/cli/options/recording_output.h"
#include "core/base/bounded_file.h"
#include "core/identification/design/excitation_design.h"
#include "core/research/study_json.h"
#include "core/signal/excitation/force_levels.h"
#include "core/signal/recording/recording_limits.h"

#include <QLocale>

#include <cmath>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

/// "m,b,k" or "name=m,b,k"; without a name the object's number is its name.
std::optional<DesignObject> readObject(const QString& designText, int number, double scatterPercent)
{
    const qsizetype equals = designText.indexOf(u'=');
    DesignObject object;
    object.name = equals > 0 ? designText.left(equals).trimmed() : QString::number(number);
    Eigen::Vector3d values = Eigen::Vector3d::Zero();
    const QStringList parts = designText.mid(equals + 1).split(u',');
    for (qsizetype i = 0; i < parts.size() && i < 3; ++i) {
        bool ok = false;
        values(i) = QLocale::c().toDouble(parts[i].trimmed(), &ok);
        if (!ok)
            return std::nullopt;
    }
    if (parts.size() != 3 || !values.allFinite() || !(values.minCoeff() > 0))
        return std::nullopt;
    object.mean = {values(0), values(1), values(2)};
    const Eigen::Vector3d scatter = scatterPercent / 100 * values;
    object.covariance = scatter.cwiseAbs2().asDiagonal();
    return object;
}

DesignOptions readDesignOptions(CommandLine& line)
{
    using Range = CommandLine::Range;
    DesignOptions options;
    const double scatter = line.number(u"scatter"_qs, Range::NotNegative);
    const QStringList objects = line.texts(u"object"_qs);
    if (objects.isEmpty())
        line.reject(u"--object m,b,k is missing."_qs);
    for (const QString& designText : objects) {
        const auto object = readObject(designText, static_cast<int>(options.objects.size()) + 1, scatter);
        if (object)
            options.objects.push_back(*object);
        else
            line.reject(u"--object is \"%1\"; m,b,k or name=m,b,k was expected, all three above zero."_qs.arg(
                designText));
    }
    options.peak = line.number(u"peak"_qs, Range::Positive);
    options.bias = line.number(u"bias"_qs);
    options.limit = line.number(u"limit"_qs, Range::Positive);
    options.oneSided = !line.isSet(u"two-sided"_qs);
    options.duration_s = line.number(u"seconds"_qs, Range::Positive);
    options.sampleTime_s = boundedNumber(line, u"sample-time"_qs, shortestSampleTime_s, longestSampleTime_s);
    options.shortestRun_s = line.number(u"shortest-run"_qs, Range::NotNegative);
    options.noiseDeviation = line.number(u"noise-sd"_qs, Range::Positive);
    options.hold = line.choice(u"hold"_qs, {u"zoh"_qs, u"foh"_qs}) == 0 ? ForceHold::Zero : ForceHold::First;
    options.seed = line.seed();
    return options;
}

QString number(double value)
{
    return QString::number(value, 'g', 4);
}

QString rowText(const DesignCandidate& candidate, const DesignOptions& options)
{
    QString designText = u"%1%2%3"_qs.arg(toString(candidate.kind), -18)
                             .arg(candidate.bit_s > 0 ? number(candidate.bit_s) : u"-"_qs, 10)
                             .arg(QString::number(candidate.dEfficiency, 'f', 3), 14);
    if (options.objects.size() > 1)
        designText += number(candidate.separation).rightJustified(12);
    for (const std::optional<Eigen::Vector3d>& errors : candidate.standardErrors)
        designText +=
            errors ? u"   %1, %2, %3"_qs.arg(number((*errors)(0)), number((*errors)(1)), number((*errors)(2)))
                   : u"   not determined"_qs;
    return designText;
}

QString designText(const ExcitationDesign& design, const DesignOptions& options)
{
    QString head = u"excitation               bit  D-efficiency"_qs;
    if (options.objects.size() > 1)
        head += u"  separation"_qs;
    for (const DesignObject& object : options.objects)
        head += u"   errors of %1 (m, b, k)"_qs.arg(object.name);
    QStringList lines{u"%1 samples, %2 to %3, never above %4."_qs.arg(
                          QString::number(options.samples()), number(options.bias - design.amplitude),
                          number(options.bias + design.amplitude), number(options.limit)),
                      head};
    for (const DesignCandidate& candidate : design.candidates)
        lines << rowText(candidate, options);
    return lines.join(u'\n');
}

void addDesignOptions(CommandLine& line)
{
    line.option(u"object"_qs, u"[NAME=]m,b,k"_qs, u"An object; give the option once for each."_qs);
    line.option(u"scatter"_qs, u"PERCENT"_qs, u"How m, b and k vary from squeeze to squeeze of an object."_qs,
                u"0"_qs);
    line.option(u"peak"_qs, u"FORCE"_qs, u"Largest force above and below the bias."_qs, u"10"_qs);
    line.option(u"bias"_qs, u"FORCE"_qs, u"Force in the middle, held before the start."_qs, u"20"_qs);
    line.option(u"limit"_qs, u"FORCE"_qs, u"Crush limit: no force is ever above it."_qs, u"100"_qs);
    line.flag(u"two-sided"_qs, u"The object can be pulled as well: forces below zero are allowed."_qs);
    line.option(u"seconds"_qs, u"SECONDS"_qs, u"How long."_qs, u"1"_qs);
    line.option(u"sample-time"_qs, u"SECONDS"_qs, u"Time from sample to sample."_qs, u"0.0005"_qs);
    line.option(u"shortest-run"_qs, u"SECONDS"_qs, u"The force must stay where it is for so long."_qs,
                u"0"_qs);
    line.option(u"noise-sd"_qs, u"SD"_qs, u"Standard deviation of the noise on the position."_qs, u"1e-5"_qs);
    line.option(u"hold"_qs, u"HOLD"_qs, u"The force between samples: zoh (held) or foh (a straight line)."_qs,
                u"zoh"_qs);
    line.option(u"seed"_qs, u"N"_qs, u"Seed of the sequences that are tried."_qs, u"1"_qs);
    line.shortOption(u'o', u"output"_qs, u"FILE"_qs,
                     u"Writes the best force there, for record --force-file and the Enroll page."_qs);
    addForceOption(line);
}

} // namespace

namespace {

/// The best of the design, where a file for it was named.
Expected<void> writeBest(const CommandLine& line, const ExcitationDesign& design,
                         const DesignOptions& options)
{
    const QString file = line.text(u"output"_qs);
    if (file.isEmpty())
        return {};
    RETURN_IF_ERROR(mayReplace(file, line.isSet(u"force"_qs)));
    const DesignCandidate& best = design.candidates.front();
    ASSIGN_OR_RETURN(const ForceLevels levels,
                     levelsOf(best.force, options.sampleTime_s, {}, toString(best.kind)));
    return writeWhole(file, toCsv(levels));
}

} // namespace

int runDesign(const QStringList& arguments)
{
    CommandLine line(
        u"design"_qs,
        u"Compares excitations for objects with these m, b and k, and searches the binary force that "
        "tells the nearest two apart best."_qs);
    addDesignOptions(line);
    if (const std::optional<int> exit = line.parse(arguments))
        return *exit;
    const DesignOptions options = readDesignOptions(line);
    if (const std::optional<int> exit = line.finish())
        return *exit;
    const bool json = line.isSet(u"json"_qs);
    const Expected<ExcitationDesign> design = designExcitation(options);
    if (!design)
        return fail(design.error(), json);
    if (const Expected<void> written = writeBest(line, *design, options); !written)
        return fail(written.error(), json);
    if (json)
        printJson(toJson(*design, options));
    else
        print(designText(*design, options));
    return 0;
}

} // namespace gripscope::cli
