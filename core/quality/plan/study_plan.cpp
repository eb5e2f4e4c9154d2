// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/plan/study_plan.h"

#include "core/base/csv.h"
#include "core/base/random_stream.h"
#include "core/base/words.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

template <typename Value, std::size_t size>
using PlanNames = std::array<std::pair<Value, const char16_t*>, size>;

constexpr PlanNames<StudyKind, 5> kindNames{{{StudyKind::Gauge, u"gauge"},
                                             {StudyKind::TypeOne, u"type1"},
                                             {StudyKind::Linearity, u"linearity"},
                                             {StudyKind::Attributes, u"attributes"},
                                             {StudyKind::Transfer, u"transfer"}}};
constexpr PlanNames<PlanOrder, 3> orderNames{{{PlanOrder::OperatorAfterOperator, u"operators"},
                                              {PlanOrder::TrialAfterTrial, u"trials"},
                                              {PlanOrder::Mixed, u"mixed"}}};
constexpr PlanNames<StudyQuantity, 3> quantityNames{
    {{StudyQuantity::Mass, u"m"}, {StudyQuantity::Damping, u"b"}, {StudyQuantity::Stiffness, u"k"}}};

template <typename Value, std::size_t size>
QString planNameOf(Value value, const PlanNames<Value, size>& names)
{
    for (const auto& [known, name] : names)
        if (known == value)
            return QString::fromUtf16(name);
    return {};
}

template <typename Value, std::size_t size>
std::optional<Value> planValueOf(const QString& text, const PlanNames<Value, size>& names)
{
    for (const auto& [known, name] : names)
        if (QString::fromUtf16(name) == text)
            return known;
    return std::nullopt;
}

int oneAtLeast(const QStringList& labels)
{
    return int(std::max<qsizetype>(1, labels.size()));
}

Error planUsage(const Finding& why)
{
    return Error{ErrorCode::Usage, {why}};
}

std::optional<Error> labelProblem(const QStringList& labels)
{
    QStringList once = labels;
    if (once.removeDuplicates() > 0)
        return planUsage(Words::say("The labels of a study differ: one is there twice."));
    for (const QString& label : labels)
        if (label.trimmed().isEmpty() || label.size() > longestPlanLabel)
            return planUsage(
                Words::say("A label of a study has 1 to %1 characters.").arg(int(longestPlanLabel)));
    return std::nullopt;
}

bool isNumberText(const QString& text)
{
    const QByteArray utf8 = text.toUtf8();
    return parseNumber({utf8.constData(), std::size_t(utf8.size())}).has_value();
}

std::optional<Error> referenceProblem(const PlanDesign& design)
{
    const bool needed = design.kind == StudyKind::TypeOne || design.kind == StudyKind::Linearity;
    if (design.references.isEmpty() && !needed)
        return std::nullopt;
    if (design.references.size() != design.parts.size())
        return planUsage(Words::say("A study against references needs one for each part."));
    if (design.kind != StudyKind::Attributes && !std::ranges::all_of(design.references, isNumberText))
        return planUsage(Words::say("A reference value is a number."));
    if (design.kind == StudyKind::Attributes && design.references.contains(QString()))
        return planUsage(Words::say("A study against references needs one for each part."));
    return std::nullopt;
}

std::optional<Error> sizeProblem(const PlanDesign& design)
{
    const qsizetype parts = design.parts.size(), operators = oneAtLeast(design.operators);
    const auto rows = double(parts) * double(operators) * oneAtLeast(design.stations) * design.trials;
    if (design.trials < 1 || parts < 1 || rows > double(mostPlanRows))
        return planUsage(
            Words::say("A study has 1 to %1 squeezes of at least one part.").arg(int(mostPlanRows)));
    const bool repeated = design.trials > 1 || operators > 1;
    switch (design.kind) {
    case StudyKind::Gauge:
        if (parts < 2 || !repeated)
            return planUsage(Words::say("A gauge study needs two parts or more, each measured twice or more "
                                        "often. Ten parts, three operators and three trials are usual."));
        break;
    case StudyKind::TypeOne:
        if (parts != 1 || operators != 1 || design.trials < 2)
            return planUsage(
                Words::say("A type-1 study is one part, squeezed by one person again and again: 50 "
                           "times is usual, 25 the least that is."));
        break;
    case StudyKind::Linearity:
        if (parts < 2)
            return planUsage(Words::say("Linearity needs two references or more. Five parts over the range, "
                                        "twelve trials each, are usual."));
        break;
    case StudyKind::Attributes:
        if (parts < 2 || !repeated)
            return planUsage(Words::say("Attribute agreement needs two parts or more, and two raters or two "
                                        "trials. 50 parts, three raters and three trials are usual."));
        break;
    case StudyKind::Transfer:
        if (design.trials < 2)
            return planUsage(
                Words::say("Types on another gripper need each two squeezes or more there. Five of "
                           "each are usual."));
        break;
    }
    return std::nullopt;
}

/// Each place once, in an order that `stream` of the seed alone decides.
std::vector<int> shuffledPlaces(int count, std::uint64_t seed, std::uint64_t stream)
{
    constexpr std::uint64_t purposeOfOrder = 0x706C616E; // "plan"
    RandomStream random(seed, stream, purposeOfOrder);
    std::vector<int> places(std::size_t(count), 0);
    std::iota(places.begin(), places.end(), 0);
    for (std::size_t left = places.size(); left > 1; --left)
        std::swap(places[left - 1], places[std::size_t(random.uniform() * double(left))]);
    return places;
}

/// Fills a plan block by block.
class PlanWriter {
public:
    explicit PlanWriter(const PlanDesign& design)
        : m_design(design), m_parts(int(design.parts.size())), m_operators(oneAtLeast(design.operators))
    {
    }

    std::vector<PlanRow> rows()
    {
        for (int station = 0; station < oneAtLeast(m_design.stations); ++station)
            writeStation(station);
        return std::move(m_rows);
    }

private:
    void writeStation(int station)
    {
        if (m_design.order == PlanOrder::OperatorAfterOperator) {
            for (int who = 0; who < m_operators; ++who)
                for (int trial = 0; trial < m_design.trials; ++trial)
                    writeBlock(station, who, trial);
            return;
        }
        for (int trial = 0; trial < m_design.trials; ++trial) {
            if (m_design.order == PlanOrder::Mixed)
                writeMixed(station, trial);
            else
                for (const int who : shuffledPlaces(m_operators, m_design.seed, nextStream()))
                    writeBlock(station, who, trial);
        }
    }
    void writeBlock(int station, int who, int trial)
    {
        for (const int part : shuffledPlaces(m_parts, m_design.seed, nextStream()))
            m_rows.push_back({part, who, station, trial});
    }
    void writeMixed(int station, int trial)
    {
        for (const int place : shuffledPlaces(m_parts * m_operators, m_design.seed, nextStream()))
            m_rows.push_back({place % m_parts, place / m_parts, station, trial});
    }
    std::uint64_t nextStream() { return m_stream++; }

    const PlanDesign& m_design;
    int m_parts, m_operators;
    std::uint64_t m_stream = 0;
    std::vector<PlanRow> m_rows;
};

} // namespace

QString toString(StudyKind kind)
{
    return planNameOf(kind, kindNames);
}

std::optional<StudyKind> studyKindFromString(const QString& text)
{
    return planValueOf(text, kindNames);
}

QString toString(PlanOrder order)
{
    return planNameOf(order, orderNames);
}

std::optional<PlanOrder> planOrderFromString(const QString& text)
{
    return planValueOf(text, orderNames);
}

QString toString(StudyQuantity quantity)
{
    return planNameOf(quantity, quantityNames);
}

std::optional<StudyQuantity> studyQuantityFromString(const QString& text)
{
    return planValueOf(text, quantityNames);
}

QString StudyPlan::part(std::size_t row) const
{
    return design.parts.value(rows[row].part);
}

QString StudyPlan::operatorName(std::size_t row) const
{
    return design.operators.value(rows[row].operators);
}

QString StudyPlan::station(std::size_t row) const
{
    return design.stations.value(rows[row].station);
}

QString StudyPlan::reference(std::size_t row) const
{
    return design.references.value(rows[row].part);
}

QStringList numberedParts(int count)
{
    QStringList labels;
    for (int i = 1; i <= count; ++i)
        labels << QString::number(i);
    return labels;
}

std::optional<Error> designProblem(const PlanDesign& design)
{
    for (const QStringList* labels : {&design.parts, &design.operators, &design.stations})
        if (const auto problem = labelProblem(*labels))
            return problem;
    if (const auto problem = sizeProblem(design))
        return problem;
    return referenceProblem(design);
}

Expected<StudyPlan> makePlan(const PlanDesign& design)
{
    if (const auto problem = designProblem(design))
        return tl::unexpected<Error>(*problem);
    return StudyPlan{design, PlanWriter(design).rows()};
}

} // namespace gripscope
