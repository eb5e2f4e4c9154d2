// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/line/output.h"
#include "app/cli/quality/quality_commands.h"
#include "core/base/words.h"
#include "core/quality/gauge/gauge_study.h"

#include <QRegularExpression>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

void addGaugeOptions(CommandLine& line)
{
    addTableOptions(line);
    line.option(u"part"_qs, u"COLUMN"_qs, u"Which part was measured (must be given)."_qs);
    line.option(u"operator"_qs, u"COLUMN"_qs, u"Who measured it."_qs);
    line.option(u"station"_qs, u"COLUMN"_qs, u"Where, or with which gripper."_qs);
    line.option(u"value"_qs, u"LIST"_qs,
                u"Columns of what was measured, separated by commas (must be given); several are judged "
                "together too."_qs);
    line.option(u"uncertainty"_qs, u"LIST"_qs,
                u"Columns of each measurement's own standard uncertainty, as many as values."_qs);
    line.option(
        u"design"_qs, u"DESIGN"_qs,
        u"crossed (all operators measure the same parts), nested (their own), or auto: by the labels, which "
        "a message tells; an operator column called run or trial counts anew within each part."_qs,
        u"auto"_qs);
    line.option(u"inside"_qs, u"FACTOR"_qs,
                u"What is numbered anew inside the other when nested: part, operator (runs of a day), or "
                "labels: what the labels say."_qs,
                u"labels"_qs);
    line.option(u"method"_qs, u"METHOD"_qs,
                u"anova, reml or range; auto: anova where the table is balanced, else reml."_qs, u"auto"_qs);
    line.option(u"tolerance"_qs, u"LIST"_qs,
                u"Width of the tolerance, upper less lower limit: one, or one a value."_qs);
    line.option(u"study-variation"_qs, u"N"_qs, u"Standard deviations in a study variation."_qs, u"6"_qs);
    line.flag(u"no-pooling"_qs, u"Keeps interactions that are not seen (p above 0.25)."_qs);
}

/// The columns and how they are to be studied.
struct GaugeRequest {
    QString part, operators, station;
    QStringList values, uncertainties;
    GaugeOptions options;
};

std::vector<double> readTolerances(CommandLine& line, qsizetype values)
{
    std::vector<double> tolerances;
    for (const QString& text : line.list(u"tolerance"_qs)) {
        bool ok = false;
        const double width = text.toDouble(&ok);
        if (!ok || !(width > 0) || !(width < 1e300))
            line.reject(
                u"--tolerance: \"%1\" is no number above 0: the upper limit less the lower one."_qs.arg(
                    text));
        tolerances.push_back(width);
    }
    if (tolerances.size() > 1 && qsizetype(tolerances.size()) != values)
        line.reject(u"--tolerance: one for all values, or one for each, was expected."_qs);
    return tolerances;
}

GaugeRequest readGaugeRequest(CommandLine& line)
{
    GaugeRequest request;
    request.part = line.text(u"part"_qs);
    request.operators = line.text(u"operator"_qs);
    request.station = line.text(u"station"_qs);
    request.values = line.list(u"value"_qs);
    request.uncertainties = line.list(u"uncertainty"_qs);
    if (request.part.isEmpty())
        line.reject(u"--part COLUMN is missing: which column says which part was measured?"_qs);
    if (request.values.isEmpty())
        line.reject(u"--value COLUMN is missing: which column holds what was measured?"_qs);
    QStringList once = request.values;
    if (once.removeDuplicates() > 0)
        line.reject(u"--value names a column twice."_qs);
    if (!request.uncertainties.isEmpty() && request.uncertainties.size() != request.values.size())
        line.reject(u"--uncertainty: one column for each of --value was expected."_qs);
    GaugeOptions& options = request.options;
    options.design =
        static_cast<GaugeDesign>(line.choice(u"design"_qs, {u"auto"_qs, u"crossed"_qs, u"nested"_qs}));
    options.inside =
        static_cast<NestedInside>(line.choice(u"inside"_qs, {u"labels"_qs, u"part"_qs, u"operator"_qs}));
    options.method = static_cast<GaugeMethod>(
        line.choice(u"method"_qs, {u"auto"_qs, u"anova"_qs, u"reml"_qs, u"range"_qs}));
    options.tolerances = readTolerances(line, request.values.size());
    options.studyVariation = line.number(u"study-variation"_qs, CommandLine::Range::Positive);
    options.pooling = !line.isSet(u"no-pooling"_qs);
    return request;
}

Expected<Eigen::MatrixXd> readColumns(const StudyTable& table, const QStringList& columns)
{
    Eigen::MatrixXd values(Eigen::Index(table.rows()), columns.size());
    for (qsizetype j = 0; j < columns.size(); ++j) {
        ASSIGN_OR_RETURN(const std::vector<double> numbers, table.numbers(columns[j]));
        values.col(j) = Eigen::Map<const Eigen::VectorXd>(numbers.data(), Eigen::Index(numbers.size()));
    }
    return values;
}

bool isCalled(const QString& column, const QString& names)
{
    const QRegularExpression any(u"^(%1)s?([ _.-]*(no|nr|number|nummer|id|name|#|[0-9])\\.?)?$"_qs.arg(names),
                                 QRegularExpression::CaseInsensitiveOption);
    return any.match(column.trimmed()).hasMatch();
}

/// Where a table is nested and labels repeat only the column's name tells what stands inside what.
OperatorsAre operatorsAre(const QString& column)
{
    if (isCalled(column, u"run|trial|repeat|repetition|replicate|replication|lauf|durchlauf|durchgang|"
                         "wiederholung"_qs))
        return OperatorsAre::Runs;
    const bool persons = isCalled(column, u"operator|op|appraiser|inspector|technician|tester|analyst|person|"
                                          "user|rater|worker|bediener|prüfer|werker"_qs);
    return persons ? OperatorsAre::Persons : OperatorsAre::Unknown;
}

Expected<GaugeMeasurements> readMeasurements(const StudyTable& table, const GaugeRequest& request)
{
    GaugeMeasurements measurements;
    measurements.names = request.values;
    ASSIGN_OR_RETURN(measurements.factors.part, table.labels(request.part));
    if (!request.operators.isEmpty()) {
        ASSIGN_OR_RETURN(measurements.factors.operators, table.labels(request.operators));
        measurements.factors.operatorsAre = operatorsAre(request.operators);
    }
    if (!request.station.isEmpty()) {
        ASSIGN_OR_RETURN(measurements.factors.station, table.labels(request.station));
    }
    measurements.values.resize(Eigen::Index(table.rows()), request.values.size());
    measurements.origins.resize(request.values.size());
    for (qsizetype j = 0; j < request.values.size(); ++j) {
        ASSIGN_OR_RETURN(const OffsetColumn column, table.offsets(request.values[j]));
        measurements.origins[j] = column.origin;
        measurements.values.col(j) =
            Eigen::Map<const Eigen::VectorXd>(column.offsets.data(), Eigen::Index(column.offsets.size()));
    }
    ASSIGN_OR_RETURN(measurements.standardUncertainties, readColumns(table, request.uncertainties));
    return measurements;
}

Expected<GaugeStudy> performGaugeStudy(const CommandLine& line, const GaugeRequest& request)
{
    ASSIGN_OR_RETURN(const StudyTable table, studyTable(line));
    ASSIGN_OR_RETURN(const GaugeMeasurements measurements, readMeasurements(table, request));
    return studyGauge(measurements, request.options);
}

QString sixDigits(std::optional<double> value)
{
    return value ? QString::number(*value, 'g', 6) : u"-"_qs;
}

QString intervalText(const VarianceInterval& interval)
{
    return u"%1 to %2"_qs.arg(QString::number(interval.lower, 'g', 4),
                              interval.upper ? QString::number(*interval.upper, 'g', 4) : u"any"_qs);
}

QStringList tableLines(const std::vector<VarianceRow>& table)
{
    QStringList lines;
    if (!table.empty())
        lines << u"%1      df            SS            MS          F          p"_qs.arg(u"source"_qs, -16);
    for (const VarianceRow& row : table)
        lines << u"%1 %2 %3 %4 %5 %6"_qs.arg(toString(row.source), -16)
                     .arg(sixDigits(row.degreesOfFreedom), 7)
                     .arg(sixDigits(row.sumOfSquares), 13)
                     .arg(sixDigits(row.meanSquare), 13)
                     .arg(row.f ? QString::number(*row.f, 'g', 4) : u"-"_qs, 10)
                     .arg(row.p ? QString::number(*row.p, 'g', 3) : u"-"_qs, 10);
    return lines;
}

QStringList componentLines(const GaugeValue& value)
{
    const bool tolerance = value.components.front().percentTolerance.has_value();
    QStringList lines{u"%1      variance  95 % interval          % contribution  % study variation%2"_qs
                          .arg(u"component"_qs, -16)
                          .arg(tolerance ? u"  % tolerance"_qs : QString())};
    for (const VarianceComponent& one : value.components) {
        QString row = u"%1 %2  %3 %4 %5"_qs.arg(toString(one.component), -16)
                          .arg(sixDigits(one.estimate), 13)
                          .arg(intervalText(one.interval), -22)
                          .arg(fixed(one.percentContribution, 2), 14)
                          .arg(fixed(one.percentStudyVariation, 2), 18);
        if (one.percentTolerance)
            row += fixed(one.percentTolerance, 2).rightJustified(13);
        lines << row;
    }
    lines << u"distinct categories %1 (%2)"_qs.arg(
        value.distinctCategories ? QString::number(*value.distinctCategories, 'f', 2) : u"-"_qs,
        intervalText(value.distinctCategoriesInterval));
    return lines;
}

QStringList valueLines(const GaugeValue& value)
{
    QStringList lines{u"%1: mean %2"_qs.arg(value.name, QString::number(value.mean, 'g', 8))};
    lines << tableLines(value.table) << componentLines(value) << described(value.messages);
    return lines;
}

/// Tables of a gauge study and what it says, for a person.
QString gaugeText(const GaugeStudy& study)
{
    QStringList lines{u"%1 design, %2 parts, %3 measurements, %4; %5"_qs.arg(
        study.design == GaugeDesign::Nested ? u"nested"_qs : u"crossed"_qs, QString::number(study.parts),
        QString::number(study.rows), study.balanced ? u"balanced"_qs : u"not balanced"_qs,
        toString(study.method))};
    for (const GaugeValue& value : study.values)
        lines << QString() << valueLines(value);
    if (!study.jointMessages.empty())
        lines << QString() << described(study.jointMessages);
    return lines.join(u'\n');
}

} // namespace

int runGaugeStudy(const QStringList& arguments)
{
    CommandLine line(u"study gauge"_qs,
                     u"Gauge repeatability and reproducibility: how much of what is measured are the parts, "
                     "how much the gripper, its operators and its stations."_qs,
                     u"[TABLE.csv]"_qs);
    addGaugeOptions(line);
    if (const std::optional<int> exit = line.parse(arguments))
        return *exit;
    const GaugeRequest request = readGaugeRequest(line);
    if (const std::optional<int> exit = line.finish())
        return *exit;
    return showStudy(performGaugeStudy(line, request), line, gaugeJson, gaugeText);
}

} // namespace gripscope::cli
