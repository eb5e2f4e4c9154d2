// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/gauge/gauge_layout.h"

#include "core/base/words.h"

#include <algorithm>
#include <map>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr unsigned partFactor = 1, operatorFactor = 2, stationFactor = 4;

struct Levels {
    std::vector<int> index;
    int count = 0;
};

Levels levelsOf(const StudyLabels& labels)
{
    return {labels.index, int(labels.names.size())};
}

/// The combinations that occur, in the order of their first row.
Levels combinationsOf(const Levels& a, const Levels& b)
{
    Levels both;
    std::map<std::pair<int, int>, int> known;
    for (std::size_t i = 0; i < a.index.size(); ++i) {
        const auto [place, isNew] = known.try_emplace({a.index[i], b.index[i]}, both.count);
        both.count += isNew ? 1 : 0;
        both.index.push_back(place->second);
    }
    return both;
}

std::vector<int> rowsEach(const Levels& levels)
{
    std::vector<int> count(std::size_t(levels.count), 0);
    for (const int level : levels.index)
        ++count[std::size_t(level)];
    return count;
}

tl::unexpected<Error> layoutError(const Finding& found, const Finding& expected)
{
    return failure(ErrorCode::BadInput, {Words::say("Parts and operators of the table"), found, expected});
}

/// Whether each level of `inner` stands under one level of `outer`, by the number of combinations.
bool standsInside(const Levels& inner, int combinations)
{
    return inner.count == combinations;
}

struct Nesting {
    bool nested = false, operatorsInParts = false, byCount = false;
    bool byName = false; ///< since "operators" are runs
};

Nesting nestingOf(const Levels& part, const Levels& operators, GaugeDesign design, NestedInside inside,
                  OperatorsAre operatorsAre)
{
    const int combinations = combinationsOf(part, operators).count;
    const bool partsInside = standsInside(part, combinations);
    const bool operatorsInside = standsInside(operators, combinations);
    Nesting nesting;
    nesting.byName = design == GaugeDesign::Auto && operatorsAre == OperatorsAre::Runs &&
                     inside != NestedInside::Parts && !partsInside && !operatorsInside;
    nesting.nested = design == GaugeDesign::Nested || nesting.byName ||
                     (design == GaugeDesign::Auto && (partsInside || operatorsInside));
    if (nesting.byName || inside != NestedInside::ByLabels)
        nesting.operatorsInParts = nesting.byName || inside == NestedInside::Operators;
    else if (partsInside || operatorsInside)
        nesting.operatorsInParts = !partsInside;
    else {
        nesting.operatorsInParts = operatorsAre == OperatorsAre::Unknown ? operators.count < part.count
                                                                         : operatorsAre == OperatorsAre::Runs;
        nesting.byCount = true;
    }
    return nesting;
}

std::optional<tl::unexpected<Error>> confoundedError(const Levels& part, const Levels& operators,
                                                     const Nesting& nesting, GaugeDesign design)
{
    const int combinations = combinationsOf(part, operators).count;
    if (combinations == part.count && combinations == operators.count)
        return layoutError(
            Words::say("each operator measured one part only, which nobody else measured"),
            Words::say("operators who measure several parts each, or no operator column (then all counts as "
                       "one operator)"));
    if (design == GaugeDesign::Crossed && standsInside(part, combinations) && !nesting.nested)
        return layoutError(Words::say("no part was measured by two operators"),
                           Words::say("the same parts for all operators, or a nested design"));
    return std::nullopt;
}

Finding nestingMessage(const Nesting& nesting)
{
    if (nesting.byName)
        return Words::say("The labels of the runs repeat under the parts: taken as nested, runs counted anew "
                          "within each part. Where a label means the same under every part, choose the "
                          "crossed design (--design crossed).");
    if (!nesting.byCount)
        return nesting.operatorsInParts
                   ? Words::say("Taken as nested: the operators (runs) are numbered within each part.")
                   : Words::say("Taken as nested: each operator has parts of their own.");
    return nesting.operatorsInParts
               ? Words::say("Labels of operators repeat under the parts: taken as "
                            "operators (runs) numbered within each part. Where the operators have parts of "
                            "their own, say so (--inside part) or give each part a name of its own.")
               : Words::say("Labels of parts repeat under the operators: taken as parts of each operator's "
                            "own. Where operators (runs) are numbered within each part, say so (--inside "
                            "operator) or give each a name of its own.");
}

Finding crossedMessage()
{
    return Words::say("Taken as crossed: an operator's label means the same operator under every part. Where "
                      "operators (runs) are numbered anew within each part, or parts within each operator, "
                      "choose the nested design (--design nested).");
}

struct LayoutFactors {
    Levels part;
    std::optional<Levels> operators, station;
    bool nested = false, operatorsInParts = false;
    Findings messages;
};

void addTerm(GaugeLayout& layout, GaugeSource source, unsigned factors, const Levels& levels)
{
    layout.terms.push_back({source, factors, levels.index, levels.count});
}

void addTerms(GaugeLayout& layout, const LayoutFactors& given)
{
    const bool partsInside = given.nested && !given.operatorsInParts;
    const bool operatorsInside = given.nested && given.operatorsInParts;
    const unsigned part = partFactor | (partsInside ? operatorFactor : 0);
    addTerm(layout, GaugeSource::Part, part, given.part);
    if (given.operators)
        addTerm(layout, GaugeSource::Operator, operatorFactor | (operatorsInside ? partFactor : 0),
                *given.operators);
    if (given.station)
        addTerm(layout, GaugeSource::Station, stationFactor, *given.station);
    if (given.operators && !given.nested)
        addTerm(layout, GaugeSource::PartOperator, partFactor | operatorFactor,
                combinationsOf(given.part, *given.operators));
    if (given.station)
        addTerm(layout, GaugeSource::PartStation, part | stationFactor,
                combinationsOf(given.part, *given.station));
}

/// The factor inside holds as many levels under each of the other's.
bool fillsEvenly(const Levels& inner, const Levels& outer)
{
    std::map<int, std::vector<int>> under;
    for (std::size_t i = 0; i < inner.index.size(); ++i) {
        std::vector<int>& levels = under[outer.index[i]];
        if (std::ranges::find(levels, inner.index[i]) == levels.end())
            levels.push_back(inner.index[i]);
    }
    return std::ranges::all_of(
        under, [&](const auto& one) { return one.second.size() == under.begin()->second.size(); });
}

void fillCells(GaugeLayout& layout, const LayoutFactors& given)
{
    Levels all = given.part;
    double expected = given.part.count;
    bool even = true;
    if (given.operators && !given.nested) {
        all = combinationsOf(all, *given.operators);
        expected *= given.operators->count;
    } else if (given.operators) {
        const Levels& inner = given.operatorsInParts ? *given.operators : given.part;
        even = fillsEvenly(inner, given.operatorsInParts ? given.part : *given.operators);
        expected = inner.count;
        all = inner;
    }
    if (given.station) {
        all = combinationsOf(all, *given.station);
        expected *= given.station->count;
    }
    layout.cell = all.index;
    layout.count = rowsEach(all);
    const auto [least, most] = std::ranges::minmax(layout.count);
    const double missing = expected - all.count;
    layout.balanced = even && missing == 0 && least == most;
    layout.replicated = most > 1;
    if (missing > 0)
        layout.messages.push_back(
            Words::say("%1 of %2 combinations of part, operator and station were not measured: the "
                       "components are estimated by restricted maximum likelihood (REML).")
                .arg(std::int64_t(missing))
                .arg(std::int64_t(expected)));
    else if (!layout.balanced)
        layout.messages.push_back(Words::say("Not every combination was measured equally often: the "
                                             "components are estimated by restricted maximum likelihood "
                                             "(REML)."));
}

/// Levels that have one row each are what repeatability is too.
void leaveOutInseparable(GaugeLayout& layout)
{
    for (const GaugeSource source : {GaugeSource::PartOperator, GaugeSource::PartStation}) {
        const auto term = std::ranges::find(layout.terms, source, &GaugeTerm::source);
        if (term == layout.terms.end() || term->cells < layout.rows())
            continue;
        layout = layout.without(source);
        layout.messages.push_back(
            source == GaugeSource::PartOperator
                ? Words::say("No operator measured a part twice: the interaction of part and operator cannot "
                             "be told from repeatability and counts as part of it. Repeat each measurement "
                             "at least once to see it.")
                : Words::say("No part was measured twice at a station: the interaction of part and station "
                             "cannot be told from repeatability and counts as part of it. Repeat each "
                             "measurement at least once to see it."));
    }
    const auto inner = std::ranges::find(layout.terms, GaugeSource::Operator, &GaugeTerm::source);
    if (layout.operatorsInParts && inner != layout.terms.end() && inner->cells == layout.rows()) {
        layout = layout.without(GaugeSource::Operator);
        layout.messages.push_back(Words::say("No operator (run) measured a part twice: operators cannot be "
                                             "told from repeatability and count as part of it."));
    }
}

void leaveOutSingle(std::optional<Levels>& factor, Findings& messages, const Finding& message)
{
    if (!factor || factor->count > 1)
        return;
    factor.reset();
    messages.push_back(message);
}

} // namespace

QString toString(GaugeSource source)
{
    switch (source) {
    case GaugeSource::Part:
        return u"part"_s;
    case GaugeSource::Operator:
        return u"operator"_s;
    case GaugeSource::Station:
        return u"station"_s;
    case GaugeSource::PartOperator:
        return u"part_operator"_s;
    case GaugeSource::PartStation:
        return u"part_station"_s;
    case GaugeSource::Repeatability:
        break;
    }
    return u"repeatability"_s;
}

bool GaugeLayout::has(GaugeSource source) const
{
    return std::ranges::find(terms, source, &GaugeTerm::source) != terms.end();
}

GaugeLayout GaugeLayout::without(GaugeSource source) const
{
    GaugeLayout layout = *this;
    std::erase_if(layout.terms, [source](const GaugeTerm& term) { return term.source == source; });
    return layout;
}

Expected<GaugeLayout> gaugeLayout(const GaugeFactors& factors, GaugeDesign design, NestedInside inside)
{
    LayoutFactors given;
    given.part = levelsOf(factors.part);
    if (given.part.count < 2)
        return layoutError(Words::say("one part only"),
                           Words::say("at least two parts, better ten, that differ as production does"));
    if (factors.operators)
        given.operators = levelsOf(*factors.operators);
    if (factors.station)
        given.station = levelsOf(*factors.station);
    leaveOutSingle(given.operators, given.messages,
                   Words::say("There is one operator only: nothing is known about differences between "
                              "operators."));
    leaveOutSingle(
        given.station, given.messages,
        Words::say("There is one station only: nothing is known about differences between stations."));
    if (given.operators) {
        const Nesting nesting = nestingOf(given.part, *given.operators, design, inside, factors.operatorsAre);
        if (auto error = confoundedError(given.part, *given.operators, nesting, design))
            return *error;
        given.nested = nesting.nested;
        given.operatorsInParts = nesting.nested && nesting.operatorsInParts;
        if (nesting.nested) {
            given.messages.push_back(nestingMessage(nesting));
            (given.operatorsInParts ? *given.operators : given.part) =
                combinationsOf(given.part, *given.operators);
        } else if (design == GaugeDesign::Auto)
            given.messages.push_back(crossedMessage());
    }
    GaugeLayout layout;
    layout.design = given.nested ? GaugeDesign::Nested : GaugeDesign::Crossed;
    layout.operatorsInParts = given.operatorsInParts;
    layout.messages = given.messages;
    fillCells(layout, given);
    addTerms(layout, given);
    leaveOutInseparable(layout);
    if (layout.terms.front().cells == layout.rows())
        return layoutError(Words::say("each part was measured once"),
                           Words::say("repeated measurements of the same parts, without which nothing is "
                                      "known about the gripper"));
    return layout;
}

} // namespace gripscope
