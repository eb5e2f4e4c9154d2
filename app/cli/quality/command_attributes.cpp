// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/line/output.h"
#include "app/cli/quality/quality_commands.h"
#include "core/quality/agreement/attribute_agreement.h"

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

QString sharePercent(const AgreementShare& share)
{
    return share.value() ? QString::number(100 * *share.value(), 'f', 1) : u"-"_qs;
}

QString shareWithLimits(const AgreementShare& share)
{
    if (!share.value())
        return u"-"_qs;
    return u"%1 (%2 to %3)"_qs.arg(sharePercent(share), QString::number(100 * share.lower, 'f', 1),
                                   QString::number(100 * share.upper, 'f', 1));
}

QString raterRow(const RaterAgreement& rater)
{
    // The name stays out of the places: it may hold a % of its own.
    return rater.name.leftJustified(16) + u" %1 %2 %3 %4 %5"_qs.arg(shareWithLimits(rater.repeatability), 24)
                                              .arg(shareWithLimits(rater.effectiveness), 24)
                                              .arg(sharePercent(rater.misses), 8)
                                              .arg(sharePercent(rater.falseAlarms), 12)
                                              .arg(fixed(rater.reference.value, 3), 8);
}

QStringList kappaLines(const AttributeAgreement& study)
{
    QStringList lines;
    for (const RaterPair& pair : study.pairs)
        lines << u"kappa of %1 and %2: %3, standard error %4"_qs.arg(
            study.raters[pair.first].name, study.raters[pair.second].name, fixed(pair.kappa.value, 3),
            fixed(pair.kappa.standardError, 3));
    lines << u"Fleiss' kappa of all verdicts: %1, z %2"_qs.arg(fixed(study.fleiss.value, 3),
                                                               fixed(study.fleiss.z, 2));
    for (const ClassKappa& one : study.fleiss.classes)
        lines << u"  %1: kappa %2, z %3"_qs.arg(study.classes[one.verdict], fixed(one.value, 3),
                                                fixed(one.z, 2));
    return lines;
}

QString text(const AttributeAgreement& study)
{
    QStringList lines{u"%1 %2 %3 %4 %5 %6"_qs.arg(u"rater"_qs, -16)
                          .arg(u"with himself %"_qs, 24)
                          .arg(u"effectiveness %"_qs, 24)
                          .arg(u"misses %"_qs, 8)
                          .arg(u"false alarms"_qs, 12)
                          .arg(u"kappa"_qs, 8)};
    for (const RaterAgreement& rater : study.raters)
        lines << raterRow(rater);
    lines << u"all raters agree on %1 % of the parts"_qs.arg(shareWithLimits(study.all));
    if (study.hasReference)
        lines << u"all raters are right on %1 % of the parts"_qs.arg(shareWithLimits(study.allRight));
    lines << kappaLines(study) << described(study.messages);
    return lines.join(u'\n');
}

void addAttributeOptions(CommandLine& line)
{
    line.option(u"part"_qs, u"COL"_qs, u"Column with the part."_qs);
    line.option(u"rater"_qs, u"COL"_qs, u"Column with who judged it: a person, a gripper, a recipe."_qs);
    line.option(u"verdict"_qs, u"COL"_qs, u"Column with the verdict."_qs);
    line.option(
        u"rater-columns"_qs, u"LIST"_qs,
        u"In place of --rater and --verdict: columns of verdicts, one a rater, separated by commas; an "
        "empty cell is no verdict. Without --part each row is a part."_qs);
    line.option(u"reference"_qs, u"COL"_qs, u"Column with the class that the part is of."_qs);
    line.option(
        u"accepted"_qs, u"CLASS"_qs,
        u"The class of good parts, for misses and false alarms; without it OK, good, pass... if there "
        "is one."_qs);
    line.option(
        u"undecided"_qs, u"CLASS"_qs,
        u"The class of verdicts that decide nothing; without it NotDecidable, undecided... if there is "
        "one."_qs);
}

RatingColumns readRatingColumns(CommandLine& line)
{
    RatingColumns columns{line.text(u"part"_qs), line.text(u"rater"_qs), line.text(u"verdict"_qs),
                          line.list(u"rater-columns"_qs), line.text(u"reference"_qs)};
    if (!columns.raters.isEmpty())
        return columns;
    for (const QString& name : {u"part"_qs, u"rater"_qs, u"verdict"_qs})
        if (line.text(name).isEmpty())
            line.reject(
                u"--%1 is missing: it names a column (or name those of all raters by --rater-columns)."_qs
                    .arg(name));
    return columns;
}

Expected<AttributeAgreement> agreementOf(const CommandLine& line, const RatingColumns& columns)
{
    ASSIGN_OR_RETURN(const StudyTable table, studyTable(line));
    ASSIGN_OR_RETURN(const AttributeRatings ratings, readRatings(table, columns));
    AgreementOptions options;
    options.accepted = line.text(u"accepted"_qs);
    options.undecided = line.text(u"undecided"_qs);
    return studyAgreement(ratings, options);
}

} // namespace

int runAttributeStudy(const QStringList& arguments)
{
    CommandLine line(
        u"study attributes"_qs,
        u"How well verdicts on the same parts agree: each rater's with his own, with the reference "
        "and with the others' (Cohen's and Fleiss' kappa)."_qs,
        u"[TABLE.csv]"_qs);
    addTableOptions(line);
    addAttributeOptions(line);
    if (const std::optional<int> exit = line.parse(arguments))
        return *exit;
    const RatingColumns columns = readRatingColumns(line);
    if (const std::optional<int> exit = line.finish())
        return *exit;
    return showStudy(
        agreementOf(line, columns), line, [](const AttributeAgreement& study) { return toJson(study); },
        [](const AttributeAgreement& study) { return text(study); });
}

} // namespace gripscope::cli
