// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/enroll/enroll_review_panel.h"

#include "core/base/words.h"
#include "core/math/distributions.h"
#include "core/recognition/types/gates.h"
#include "core/recognition/types/predictive.h"
#include "core/recognition/types/squeeze_values.h"
#include "core/recognition/verdict/identified_squeeze.h"
#include "core/session/squeeze/comparable_units.h"
#include "ui/charts/type_map.h"
#include "ui/context/sign_in.h"
#include "ui/context/workbench.h"
#include "ui/format/number_format.h"
#include "ui/format/recipe_words.h"
#include "ui/format/shown_unit.h"
#include "ui/pages/fit/fit_page_export.h"
#include "ui/pages/part_picture.h"
#include "ui/people/authorize.h"
#include "ui/widgets/controls.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QSet>
#include <QTabBar>
#include <QTabWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <iterator>

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {

/// Squared, as verdicts have it; the tolerance gate where a confidence is asked for.
std::optional<double> reviewedGate(const TypeModels& models, const TypeModel& own,
                                   const VerdictOptions& rates)
{
    const double degrees = predictType(models, own, own.meanLog, {}, {rates.robust}).degreesOfFreedom;
    const int dimensions = models.space.dimensions();
    return rates.confidence
               ? toleranceGate(own.squeezes, degrees, rates.falseReject, *rates.confidence, dimensions)
               : falseRejectGate(own.squeezes, degrees, rates.falseReject, dimensions);
}

/// Mean and deviation of what most of these determine, over those that do.
std::vector<ReviewedQuantity> quantitiesOf(const std::vector<TypeSqueeze>& own)
{
    std::vector<ReviewedQuantity> quantities;
    for (const TypeQuantity quantity : spaceOf(own).quantities) {
        Eigen::VectorXd values(static_cast<Eigen::Index>(own.size()));
        Eigen::Index next = 0;
        for (const TypeSqueeze& squeeze : own)
            if (const auto log = coordinatesOf(squeeze, QuantitySpace{{quantity}}))
                values[next++] = std::exp((*log)[0]);
        if (next == 0)
            continue;
        ReviewedQuantity one{quantity, values.head(next).mean(), {}, static_cast<int>(next)};
        if (next > 1)
            one.deviation = std::sqrt((values.head(next).array() - one.mean).square().sum() /
                                      static_cast<double>(next - 1));
        quantities.push_back(one);
    }
    return quantities;
}

/// What a row of the review is called.
QString rowName(TypeQuantity quantity)
{
    switch (quantity) {
    case TypeQuantity::Mass:
        return EnrollReviewPanel::tr("moving mass m");
    case TypeQuantity::Damping:
        return EnrollReviewPanel::tr("damping b");
    case TypeQuantity::Stiffness:
        return EnrollReviewPanel::tr("stiffness k");
    case TypeQuantity::RelaxingShare:
        return EnrollReviewPanel::tr("yielding share k1/k");
    case TypeQuantity::RelaxationTime:
        return EnrollReviewPanel::tr("yields within τ");
    case TypeQuantity::Friction:
        return EnrollReviewPanel::tr("friction Fc");
    }
    return {};
}

void showRow(const QuantityRow& row, bool visible)
{
    for (QLabel* label : {row.name, row.mean, row.spread})
        label->setVisible(visible);
}

QString meanText(const ReviewedQuantity& one, const TypeReview& review)
{
    // The mean's own interval says how well it is known: Student's t, since the squeezes are few.
    std::optional<double> halfWidth;
    if (one.deviation)
        halfWidth = studentQuantile(0.975, one.squeezes - 1) * *one.deviation / std::sqrt(one.squeezes);
    if (one.quantity == TypeQuantity::RelaxingShare)
        return formatNumber(100 * one.mean, halfWidth ? std::optional(100 * *halfWidth) : std::nullopt,
                            u"%"_s)
            .text();
    const QString unit =
        comparableUnit(parameterOf(one.quantity), review.forceUnit, review.positionUnit).unit;
    return formatNumber(one.mean, halfWidth, unit).text();
}

} // namespace

TypeReview reviewType(const std::vector<TypeSqueeze>& squeezes, const ModelsBySpace& types,
                      const QString& name, const VerdictOptions& rates)
{
    const TypeModels& models = *types.whole();
    TypeReview review;
    review.falseReject = rates.falseReject;
    review.models = models;
    std::copy_if(squeezes.begin(), squeezes.end(), std::back_inserter(review.squeezesOfAll),
                 [&models](const TypeSqueeze& squeeze) { return models.find(squeeze.type) != nullptr; });
    std::vector<TypeSqueeze> ofType;
    std::copy_if(squeezes.begin(), squeezes.end(), std::back_inserter(ofType),
                 [&name](const TypeSqueeze& squeeze) { return squeeze.type == name; });
    review.squeezes = static_cast<int>(ofType.size());
    if (ofType.empty())
        return review;
    review.quantities = quantitiesOf(ofType);
    const TypeModel* own = models.find(name);
    if (!own || models.degreesOfFreedom < 1)
        return review;
    for (const TypeModel& other : models.types) {
        const std::optional<double> distance =
            other.name != name ? types.distance(name, other.name) : std::nullopt;
        if (distance && (!review.nearestSd || *distance < *review.nearestSd)) {
            review.nearestSd = distance;
            review.nearest = other.name;
        }
    }
    // By all that it determines, or what all do where its squeezes are too few for that.
    for (const ModelsBySpace::Models& among : {types.modelsAmong({name}), types.whole()})
        if (const TypeModel* there = among->find(name); there && !review.gateSd)
            if (const std::optional<double> gate = reviewedGate(*among, *there, rates))
                review.gateSd = std::sqrt(*gate);
    return review;
}

namespace {

Expected<TypeReview> loadReview(Library& library, const QString& name, const VerdictOptions& rates)
{
    ASSIGN_OR_RETURN(const std::vector<TypeRecord> types, library.types());
    ASSIGN_OR_RETURN(const std::vector<TypeSqueeze> squeezes, library.enrolledSqueezes());
    for (const TypeRecord& type : types) {
        if (type.name != name)
            continue;
        ASSIGN_OR_RETURN(const ComparableTypes::Choice choice,
                         ComparableTypes(types, squeezes).modelsFor(type.forceUnit, type.positionUnit));
        TypeReview review = reviewType(squeezes, *choice.types, name, rates);
        review.models = *choice.types->linear();
        review.forceUnit = type.forceUnit;
        review.positionUnit = type.positionUnit;
        return review;
    }
    return failure(ErrorCode::NotFound, {name});
}

} // namespace

QStringList summaryLines(const EnrollSession& session)
{
    int rejected = 0;
    QSet<QString> parts;
    for (const EnrollSqueeze& squeeze : session.squeezes()) {
        if (squeeze.decision != EnrollSqueeze::Decision::Accepted)
            ++rejected;
        else if (!squeeze.part.isEmpty())
            parts.insert(squeeze.part);
    }
    QString squeezes = rejected == 0
                           ? EnrollReviewPanel::tr("Squeezes: %1 accepted").arg(session.acceptedCount())
                           : EnrollReviewPanel::tr("Squeezes: %1 accepted, %2 not")
                                 .arg(session.acceptedCount())
                                 .arg(rejected);
    if (!parts.isEmpty())
        squeezes += u'\n' + EnrollReviewPanel::tr("Of %n part(s) with a mark", nullptr,
                                                  static_cast<int>(parts.size()));
    const Recipe& recipe = session.recipe();
    return {squeezes,
            EnrollReviewPanel::tr("Force: %1 to %2 for %3 s")
                    .arg(forceText(recipe.bias_N - recipe.peak_N), forceText(recipe.bias_N + recipe.peak_N),
                         Words::number(recipe.seconds)) +
                u'\n' + RecipeWords::name(recipe.kind),
            EnrollReviewPanel::tr("Crush limit: %1, %2")
                .arg(forceText(recipe.maxForce_N), lengthText(recipe.maxTravel_m))};
}

namespace {
constexpr int leastFacts = 368;
}

QWidget* EnrollReviewPanel::makeFacts(QWidget* parent)
{
    auto* card = new QWidget(parent);
    auto* facts = new QVBoxLayout(card);
    setSpacing(facts, 0, 8);
    m_picture = new PartPictureView(*m_workbench, 64, PartPictureView::Empty::Hidden, card);
    m_summary = makeLabel({}, "second", card);
    m_summary->setObjectName("reviewSummary");
    m_summary->setWordWrap(true);
    auto* what = new QHBoxLayout;
    what->setSpacing(12);
    what->addWidget(m_picture, 0, Qt::AlignTop);
    what->addWidget(m_summary, 1);
    facts->addLayout(what);
    facts->addSpacing(8);
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(16);
    grid->setVerticalSpacing(8);
    grid->addWidget(makeLabel(tr("Mean (95 %)"), "caption", card), 0, 1, Qt::AlignRight);
    grid->addWidget(makeLabel(tr("Spread (1 sd)"), "caption", card), 0, 2, Qt::AlignRight);
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        // Stiffness first, as everywhere; then damping and mass, then what there is besides.
        const int row = i < 3 ? 3 - static_cast<int>(i) : 1 + static_cast<int>(i);
        QuantityRow& labels = m_rows[i];
        labels = {makeLabel(rowName(allQuantities[i]), "", card), makeLabel({}, "strong", card),
                  makeLabel({}, "strong", card)};
        labels.name->setObjectName("quantityName");
        grid->addWidget(labels.name, row, 0);
        grid->addWidget(labels.mean, row, 1, Qt::AlignRight);
        grid->addWidget(labels.spread, row, 2, Qt::AlignRight);
        if (i >= 3) // not before it is known that there is any
            showRow(labels, false);
    }
    facts->addLayout(grid);
    facts->addSpacing(8);
    m_distance = makeLabel({}, "", card);
    m_distance->setObjectName("distanceLabel");
    m_sentences = makeLabel({}, "", card);
    m_sentences->setObjectName("reviewSentences");
    m_gate = makeLabel({}, "second", card);
    for (QLabel* label : {m_distance, m_sentences, m_gate}) {
        label->setWordWrap(true);
        facts->addWidget(label);
    }
    facts->addStretch(1);
    // Long names and many sentences: it scrolls rather than grow beyond the least window.
    m_facts = makeScroll(card, parent);
    m_facts->setFixedWidth(leastFacts);
    m_facts->setObjectName("reviewFacts");
    return m_facts;
}

EnrollReviewPanel::EnrollReviewPanel(Workbench& workbench, QWidget* parent)
    : QWidget(parent), m_workbench(&workbench)
{
    QFrame* card = makeCard(this);
    auto* column = new QVBoxLayout(card);
    setSpacing(column, 24, 12);
    m_title = makeLabel({}, "heading", card);
    column->addWidget(m_title);
    auto* body = new QHBoxLayout;
    body->setSpacing(24);
    m_map = new TypeMap(card);
    m_map->setFocusPolicy(Qt::TabFocus);
    (new FitExporter(*m_workbench, this))->addFigure(m_map); // its context menu
    m_check = new EnrollCheck(card);
    auto* views = new QTabWidget(card);
    views->setStyleSheet(u"QTabWidget > QStackedWidget { background: transparent; }"_s); // the card's
    views->addTab(m_check, tr("Held-out check"));
    views->addTab(m_map, tr("Map"));
    body->addWidget(makeFacts(card));
    body->addWidget(views, 1);
    column->addLayout(body, 1);
    auto* row = new QHBoxLayout;
    QPushButton* back = makeButton(tr("Back to the squeezes"), {}, "", card);
    back->setObjectName("reviewBack");
    m_approve = makeButton(tr("Approve"), u"dialog-ok-apply"_s, "primary", card);
    m_approve->setObjectName("approveButton");
    QPushButton* trial = makeButton(tr("Try a squeeze…"), {}, "", card);
    trial->setObjectName("trialOfType");
    row->addWidget(back);
    row->addStretch(1);
    row->addWidget(trial);
    row->addWidget(m_approve);
    column->addLayout(row);
    auto* outer = new QVBoxLayout(this);
    setSpacing(outer, 0, 0);
    outer->addWidget(card);
    setFocusProxy(m_approve);
    connect(m_workbench, &Workbench::ratesChanged, this, [this] {
        if (m_workbench->enrollment().step() == EnrollSession::Step::Review)
            load();
    });
    const auto tell = [this](const Expected<void>& done) {
        if (!done)
            m_workbench->messages().report(done.error().describe());
        emit changed();
    };
    connect(back, &QPushButton::clicked, this, [this, tell] { tell(m_workbench->enrollment().back()); });
    connect(trial, &QPushButton::clicked, this, [this] {
        const EnrollSession& session = m_workbench->enrollment();
        (new TrialDialog(*m_workbench, session.typeName(), session.recipe(), this))->open();
    });
    connect(m_approve, &QPushButton::clicked, this, [this, tell] {
        const auto approve = [this, tell](const QString& reason) {
            authorize(*m_workbench, this, Permission::ApproveTypes,
                      [this, tell, reason] { tell(m_workbench->enrollment().approve(reason)); });
        };
        // Where nobody signs, what was just looked through is reason enough.
        if (m_workbench->signIn().inForce())
            askWhy(this, m_approve->text(), approve);
        else
            approve({});
    });
}

void EnrollReviewPanel::load()
{
    const QString name = m_workbench->enrollment().typeName();
    m_title->setText(tr("Review of %1").arg(name));
    m_picture->setPicture(m_workbench->enrollment().picture());
    m_summary->setText(summaryLines(m_workbench->enrollment()).join(u'\n'));
    m_workbench->background().ask<TypeReview>(
        this,
        [name, rates = m_workbench->rates().rates](Library& library) {
            return loadReview(library, name, rates);
        },
        [this](const Expected<TypeReview>& review) {
            if (review)
                show(*review);
            else
                m_workbench->messages().report(review.error().describe());
        });
    loadCheck();
}

void EnrollReviewPanel::loadCheck()
{
    using Squeezes = std::vector<TypeSqueeze>;
    const EnrollSession& session = m_workbench->enrollment();
    const AdviceRequest request =
        adviceRequest(session.typeName(), session.squeezes(), m_workbench->rates().rates);
    m_check->clear();
    m_sentences->clear();
    const auto finish = [this, request](const EnrollmentReview& review) {
        if (request.type != m_workbench->enrollment().typeName())
            return;
        m_check->show(review.confusion, request.type, request.rates);
        m_sentences->setText(reviewSentences(review).join(u"\n"_s));
    };
    m_workbench->background().ask<Squeezes>(
        this, [](Library& library) { return library.enrolledSqueezes(); },
        [this, request, finish](const Expected<Squeezes>& library) {
            if (!library)
                return m_workbench->messages().report(library.error().describe());
            m_workbench->background().compute<EnrollmentReview>(
                this, [request, squeezes = *library] { return reviewEnrollment(request, squeezes); }, finish);
        });
}

/// Numbers with long units are as wide as they are: the facts cannot be scrolled to the side.
void EnrollReviewPanel::fitFacts()
{
    for (QLabel* label : m_facts->findChildren<QLabel*>())
        label->ensurePolished();
    const int needed = m_facts->widget()->minimumSizeHint().width();
    m_facts->setFixedWidth(std::max(leastFacts, needed + m_facts->verticalScrollBar()->sizeHint().width()));
}

void EnrollReviewPanel::show(const TypeReview& review)
{
    m_title->setText(tr("Review of %1: %2 squeezes")
                         .arg(m_workbench->enrollment().typeName(), QString::number(review.squeezes)));
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        const auto found =
            std::ranges::find(review.quantities, allQuantities[i], &ReviewedQuantity::quantity);
        const bool isThere = found != review.quantities.end();
        showRow(m_rows[i], isThere);
        if (!isThere)
            continue;
        m_rows[i].mean->setText(meanText(*found, review));
        m_rows[i].spread->setText(found->deviation ? formatPercent(100 * *found->deviation / found->mean)
                                                   : u"–"_s);
    }
    fitFacts();
    if (!review.nearestSd)
        m_distance->setText(
            tr("It is the only type that it can be compared with; enroll others to see how far they are."));
    else if (review.gateSd && *review.nearestSd < *review.gateSd)
        m_distance->setText(tr("The nearest other type, %1, is only %2 sd away: within the gate. Squeezes of "
                               "the two will be mixed "
                               "up. Choose a recipe that tells them apart, or treat them as one type.")
                                .arg(review.nearest)
                                .arg(*review.nearestSd, 0, 'f', 1));
    else
        m_distance->setText(tr("The nearest other type is %1, %2 sd away.")
                                .arg(review.nearest)
                                .arg(*review.nearestSd, 0, 'f', 1));
    m_gate->setText(review.gateSd ? tr("A squeeze further than %1 sd from the type is called unknown (%2 of "
                                       "its own squeezes are).")
                                        .arg(*review.gateSd, 0, 'f', 1)
                                        .arg(formatPercent(100 * review.falseReject))
                                  : tr("Too few squeezes for a gate yet: every verdict on this type stays "
                                       "inconclusive. Add some."));
    m_map->setTypes(review.models, !review.squeezesOfAll.empty());
    m_map->setSqueezes(review.squeezesOfAll, m_workbench->enrollment().typeName());
}

} // namespace gripscope
