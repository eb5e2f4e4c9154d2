// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/quality/agreement/attribute_agreement.h"

#include <QHash>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

tl::unexpected<Error> unusableRatings(const Finding& found, const Finding& expected)
{
    return failure(ErrorCode::BadInput, {Words::say("verdicts"), found, expected});
}

/// Classes of several columns as one list.
class ClassList {
public:
    /// For each of the column's own names its place in the list; only for those that occur.
    [[nodiscard]] std::vector<int> places(const StudyLabels& labels)
    {
        std::vector<int> places;
        for (const QString& name : labels.names) {
            const auto known = m_places.constFind(name);
            places.push_back(known == m_places.cend() ? int(m_names.size()) : *known);
            if (known == m_places.cend()) {
                m_places.insert(name, int(m_names.size()));
                m_names.append(name);
            }
        }
        return places;
    }
    [[nodiscard]] const QStringList& names() const { return m_names; }

private:
    QStringList m_names;
    QHash<QString, int> m_places;
};

Expected<StudyLabels> partsOf(const StudyTable& table, const RatingColumns& columns)
{
    if (!columns.part.isEmpty())
        return table.labels(columns.part);
    StudyLabels parts;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        parts.index.push_back(int(row));
        parts.names.append(QString::number(row + 1));
    }
    return parts;
}

std::optional<Error> addLong(const StudyTable& table, const RatingColumns& columns, const StudyLabels& parts,
                             ClassList& classes, AttributeRatings& ratings)
{
    const auto raters = table.labels(columns.rater);
    if (!raters)
        return raters.error();
    const auto verdicts = table.labels(columns.verdict);
    if (!verdicts)
        return verdicts.error();
    const std::vector<int> places = classes.places(*verdicts);
    ratings.raters = raters->names;
    for (std::size_t row = 0; row < table.rows(); ++row)
        ratings.ratings.push_back({parts.index[row], raters->index[row], places[verdicts->index[row]]});
    return {};
}

std::optional<Error> addWide(const StudyTable& table, const RatingColumns& columns, const StudyLabels& parts,
                             ClassList& classes, AttributeRatings& ratings)
{
    ratings.raters = columns.raters;
    for (qsizetype rater = 0; rater < columns.raters.size(); ++rater) {
        const auto verdicts = table.labels(columns.raters[rater], StudyTable::EmptyCells::Missing);
        if (!verdicts)
            return verdicts.error();
        const std::vector<int> places = classes.places(*verdicts);
        for (std::size_t row = 0; row < table.rows(); ++row)
            if (verdicts->index[row] >= 0)
                ratings.ratings.push_back({parts.index[row], int(rater), places[verdicts->index[row]]});
    }
    return {};
}

std::optional<Error> addReference(const StudyTable& table, const RatingColumns& columns,
                                  const StudyLabels& parts, ClassList& classes, AttributeRatings& ratings)
{
    const auto references = table.labels(columns.reference);
    if (!references)
        return references.error();
    const std::vector<int> places = classes.places(*references);
    ratings.reference.assign(std::size_t(parts.names.size()), -1);
    for (std::size_t row = 0; row < table.rows(); ++row) {
        int& reference = ratings.reference[parts.index[row]];
        const int stated = places[references->index[row]];
        if (reference >= 0 && reference != stated)
            return unusableRatings(Words::say("found the references %1 and %2 for part %3")
                                       .arg(classes.names()[reference], classes.names()[stated],
                                            parts.names[parts.index[row]]),
                                   Words::say("expected one for each part"))
                .value();
        reference = stated;
    }
    return {};
}

std::optional<Error> senselessColumns(const RatingColumns& columns)
{
    const bool wide = !columns.raters.isEmpty();
    if (wide ? !columns.rater.isEmpty() || !columns.verdict.isEmpty()
             : columns.rater.isEmpty() || columns.verdict.isEmpty() || columns.part.isEmpty())
        return Error{
            ErrorCode::Usage,
            {Words::say("Name the columns of part, rater and verdict, or those of the raters: either a "
                        "verdict a row, or a column a rater.")}};
    if (QStringList names = columns.raters; names.removeDuplicates() > 0)
        return Error{ErrorCode::Usage, {Words::say("A rater's column is named twice.")}};
    return {};
}

} // namespace

Expected<AttributeRatings> readRatings(const StudyTable& table, const RatingColumns& columns)
{
    RETURN_IF_ERROR(senselessColumns(columns));
    AttributeRatings ratings;
    ClassList classes;
    ASSIGN_OR_RETURN(const StudyLabels parts, partsOf(table, columns));
    ratings.parts = parts.names;
    RETURN_IF_ERROR(columns.raters.isEmpty() ? addLong(table, columns, parts, classes, ratings)
                                             : addWide(table, columns, parts, classes, ratings));
    if (!columns.reference.isEmpty())
        RETURN_IF_ERROR(addReference(table, columns, parts, classes, ratings));
    ratings.classes = classes.names();
    if (ratings.ratings.empty())
        return unusableRatings(Words::say("found no verdict"), Words::say("expected at least one"));
    if (ratings.raters.size() > mostRaters)
        return unusableRatings(Words::say("found %1 raters").arg(ratings.raters.size()),
                               Words::say("expected at most %1: is it the right column?").arg(mostRaters));
    if (ratings.classes.size() > mostClasses)
        return unusableRatings(Words::say("found %1 kinds of verdicts").arg(ratings.classes.size()),
                               Words::say("expected at most %1: is it the right column?").arg(mostClasses));
    return ratings;
}

} // namespace gripscope
