// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/csv.h"
#include "core/base/display_units.h"
#include "ui/context/workbench.h"
#include "ui/format/number_format.h"
#include "ui/format/reference_words.h"
#include "ui/pages/quality/study_views.h"
#include "ui/pages/quality/study_words.h"
#include "ui/settings/values/settings.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/form_rows.h"
#include "ui/widgets/quantity_box.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QRandomGenerator>
#include <QScrollArea>
#include <QSpinBox>
#include <QVBoxLayout>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr std::array<MechanicalQuantity, 3> parametersInOrder{
    MechanicalQuantity::Mass, MechanicalQuantity::Damping, MechanicalQuantity::Stiffness};
// SI; widths of a tolerance that are of no part between fingers
constexpr std::array<double, 3> widestTolerance{10, 10'000, 10'000'000};
constexpr std::array<double, 3> finestTolerance{1e-6, 1e-3, 1e-2};

/// "a, b, c": names are parted by commas or semicolons.
QStringList namesIn(const QString& text)
{
    QStringList names;
    QString comma = text;
    for (const QString& name : comma.replace(u';', u',').split(u',', Qt::SkipEmptyParts))
        if (const QString trimmed = name.trimmed(); !trimmed.isEmpty())
            names << trimmed;
    return names;
}

/// A number as it is typed in `unit`; what is none stays as it is, and is told.
QString inSi(QString typed, const ShownUnit& unit)
{
    bool isNumber = false;
    const double number = typed.replace(u',', u'.').toDouble(&isNumber);
    return isNumber ? exactText(number / unit.factor) : typed;
}

QLineEdit* makeLine(const char* name, const QString& placeholder, QWidget* parent)
{
    auto* line = new QLineEdit(parent);
    line->setObjectName(QLatin1StringView(name));
    line->setPlaceholderText(placeholder);
    line->setMaxLength(2000);
    return line;
}

QSpinBox* makeCount(const char* name, std::pair<int, int> range, QWidget* parent)
{
    auto* count = new QSpinBox(parent);
    count->setObjectName(QLatin1StringView(name));
    count->setRange(range.first, range.second);
    count->setMaximumWidth(120);
    return count;
}

} // namespace

StudyForm::StudyForm(Workbench& workbench, QWidget* parent) : QWidget(parent), m_workbench(&workbench)
{
    build();
    for (QLineEdit* line : {m_name, m_labels, m_operators, m_references}) {
        connect(line, &QLineEdit::textChanged, this, &StudyForm::refresh);
        connect(line, &QLineEdit::returnPressed, this, &StudyForm::submit);
    }
    connect(m_quantity, &QComboBox::currentIndexChanged, this, [this] {
        askForReferences();
        refresh();
    });
    for (QSpinBox* count : {m_parts, m_trials})
        connect(count, &QSpinBox::valueChanged, this, &StudyForm::refresh);
    connect(m_begin, &QPushButton::clicked, this, &StudyForm::submit);
    connect(m_back, &QPushButton::clicked, this, &StudyForm::cancelled);
    connect(&workbench, &Workbench::inspectionChanged, this, [this] {
        if (!isVisible())
            fillRecipes();
    });
    begin(StudyKind::Gauge, {});
}

void StudyForm::build()
{
    auto* content = new QWidget(this);
    QFrame* card = makeCard(content);
    card->setMaximumWidth(760);
    auto* column = new QVBoxLayout(card);
    setSpacing(column, 24, 12);
    m_title = makeLabel({}, "heading", card);
    m_answer = makeLabel({}, "second", card);
    m_answer->setWordWrap(true);
    column->addWidget(m_title);
    column->addWidget(m_answer);
    m_form = makeForm();
    column->addLayout(m_form);
    addFields(m_form);
    auto* row = new QHBoxLayout;
    row->addStretch(1);
    row->addWidget(card, 8);
    row->addStretch(1);
    auto* inside = new QVBoxLayout(content);
    setSpacing(inside, 0, 0);
    inside->addLayout(row);
    inside->addStretch(1);
    auto* outer = new QVBoxLayout(this);
    setSpacing(outer, 0, 12);
    outer->addWidget(makeScroll(content, this), 1);
    outer->addWidget(makeButtons()); // in view however low the window is
}

void StudyForm::addFields(QFormLayout* form)
{
    m_name = makeLine("studyNameField", tr("Name of the study"), this);
    m_name->setMaxLength(60);
    m_parts = makeCount("studyParts", {2, 500}, this);
    m_labels = makeLine("studyLabels", tr("1, 2, 3 … unless parts have labels of their own"), this);
    m_operators = makeLine("studyOperators", tr("Names, with commas between them"), this);
    m_trials = makeCount("studyTrials", {1, 1000}, this);
    m_quantity = new QComboBox(this);
    m_quantity->setObjectName("studyQuantity");
    for (std::size_t i = 0; i < parametersInOrder.size(); ++i)
        m_quantity->addItem(ReferenceWords::quantity(i));
    m_references = makeLine("studyReferences", {}, this);
    m_tolerances = makeTolerances();
    m_order = new QComboBox(this);
    m_order->setObjectName("studyOrder");
    m_order->addItems({tr("One operator after the other"), tr("Trial after trial"), tr("All mixed")});
    m_recipe = new QComboBox(this);
    m_recipe->setObjectName("studyRecipe");
    const auto row = [this, form](const QString& caption, QWidget* field) {
        addFormRow(form, makeLabel(caption, "", this), field);
    };
    row(tr("Name"), m_name);
    row(tr("Parts"), m_parts);
    row(tr("Labels"), m_labels);
    row(tr("Operators"), m_operators);
    row(tr("Trials"), m_trials);
    row(tr("Quantity"), m_quantity);
    row(tr("References"), m_references);
    row(tr("Tolerance"), m_tolerances);
    row(tr("Order"), m_order);
    row(tr("Squeezed as"), m_recipe);
}

QWidget* StudyForm::makeTolerances()
{
    auto* box = new QWidget(this);
    auto* row = new QHBoxLayout(box);
    setSpacing(row, 0, 8);
    const char* const names[] = {"toleranceM", "toleranceB", "toleranceK"};
    const QString symbols[] = {u"m"_s, u"b"_s, u"k"_s};
    for (const std::size_t i : {std::size_t(2), std::size_t(1), std::size_t(0)}) {
        m_tolerance[i] = new QuantityBox(fieldUnit(parametersInOrder[i]), {0, widestTolerance[i]},
                                         finestTolerance[i], box);
        m_tolerance[i]->setObjectName(QLatin1StringView(names[i]));
        m_tolerance[i]->setSpecialValueText(tr("not stated"));
        m_tolerance[i]->setAccessibleName(tr("Tolerance of %1").arg(symbols[i]));
        m_tolerance[i]->setToolTip(tr("From the lower to the upper limit of the product; may stay unstated"));
        connect(m_tolerance[i], &QuantityBox::valueChanged, this, &StudyForm::refresh);
        row->addWidget(makeLabel(symbols[i], "second", box));
        row->addWidget(m_tolerance[i], 1);
    }
    return box;
}

QWidget* StudyForm::makeButtons()
{
    auto* box = new QWidget(this);
    auto* row = new QHBoxLayout(box);
    setSpacing(row, 0, 8);
    m_back = makeButton(tr("Back"), {}, "", box);
    m_back->setObjectName("studyFormBack");
    m_begin = makeButton(tr("Begin the study (Enter)"), {}, "primary", box);
    m_begin->setObjectName("studyFormBegin");
    m_hint = makeLabel({}, "second", box);
    m_hint->setObjectName("studyHint");
    m_hint->setWordWrap(true);
    m_hint->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    row->addWidget(m_back);
    row->addWidget(m_hint, 1);
    row->addWidget(m_begin);
    return box;
}

void StudyForm::showRow(QWidget* field, bool on)
{
    m_form->setRowVisible(field, on);
}

void StudyForm::begin(StudyKind kind, const QString& name)
{
    m_kind = kind;
    m_seed = QRandomGenerator::global()->generate(); // 32 bits: exact as a number of JSON
    const bool one = kind == StudyKind::TypeOne, rated = kind == StudyKind::Attributes;
    const bool referenced = one || kind == StudyKind::Linearity;
    m_title->setText(StudyWords::name(kind));
    m_answer->setText(StudyWords::answer(kind));
    m_name->setText(name);
    m_labels->clear();
    m_references->clear();
    const QString here = m_workbench->operatorName();
    const QString first = here.isEmpty() ? u"A"_s : here;
    m_operators->setText(kind == StudyKind::Gauge || rated ? QStringList{first, u"B"_s, u"C"_s}.join(u", "_s)
                                                           : first);
    m_parts->setValue(rated ? 20 : kind == StudyKind::Linearity ? 5 : 10);
    m_trials->setValue(one ? 50 : kind == StudyKind::Linearity ? 12 : 3);
    m_quantity->setCurrentIndex(2);
    for (QuantityBox* box : m_tolerance)
        box->setSi(0);
    askForReferences();
    showRow(m_parts, !one);
    showRow(m_quantity, referenced);
    showRow(m_references, kind != StudyKind::Gauge);
    showRow(m_tolerances, !rated && kind != StudyKind::Linearity);
    showRow(m_order, kind == StudyKind::Gauge || rated);
    showRow(m_recipe, !rated);
    fillRecipes();
    refresh();
}

ShownUnit StudyForm::referenceUnit() const
{
    return fieldUnit(parametersInOrder[std::size_t(std::max(0, m_quantity->currentIndex()))]);
}

void StudyForm::askForReferences()
{
    const QString unit = referenceUnit().unit;
    m_references->setPlaceholderText(
        m_kind == StudyKind::Attributes
            ? tr("The right word for each part, with semicolons between; may stay empty")
        : m_kind == StudyKind::TypeOne ? tr("What the part is, in %1").arg(unit)
                                       : tr("What each part is, in %1, with semicolons between").arg(unit));
}

void StudyForm::fillRecipes()
{
    const int chosen = m_recipe->currentIndex();
    m_recipe->clear();
    m_recipes = {recipeOfNewTypes()};
    m_recipe->addItem(tr("A new type: %1").arg(m_recipes.front().name));
    for (const TypeRecord& type : m_workbench->inspection().types()) {
        m_recipe->addItem(tr("Parts of %1: %2").arg(type.name, type.recipe.name));
        m_recipes.push_back(type.recipe);
    }
    m_recipe->setCurrentIndex(chosen >= 0 && chosen < m_recipe->count() ? chosen : 0);
}

PlanDesign StudyForm::design() const
{
    PlanDesign design;
    design.kind = m_kind;
    const QStringList labels = namesIn(m_labels->text());
    design.parts = !labels.isEmpty()              ? labels
                   : m_kind == StudyKind::TypeOne ? QStringList{u"1"_s}
                                                  : numberedParts(m_parts->value());
    design.operators = namesIn(m_operators->text());
    for (const QString& reference : m_references->text().split(u';', Qt::SkipEmptyParts))
        design.references << (m_kind == StudyKind::Attributes ? reference.trimmed()
                                                              : inSi(reference.trimmed(), referenceUnit()));
    design.quantity = static_cast<StudyQuantity>(m_quantity->currentIndex());
    design.trials = m_trials->value();
    design.order = static_cast<PlanOrder>(m_order->currentIndex());
    design.seed = m_seed;
    return design;
}

StudyRequest StudyForm::request() const
{
    StudyRequest request;
    request.name = m_name->text().trimmed();
    request.design = design();
    request.recipe = m_recipes[std::size_t(std::max(0, m_recipe->currentIndex()))];
    for (std::size_t i = 0; i < m_tolerance.size(); ++i)
        if (m_tolerance[i]->si() > 0)
            request.options.tolerances[i] = m_tolerance[i]->si();
    request.options.repeatAfterMonths = int(m_workbench->settings().get(StudyWords::repeatMonths(m_kind)));
    return request;
}

QString StudyForm::problem() const
{
    if (m_name->text().trimmed().isEmpty())
        return tr("Give the study a name.");
    const PlanDesign wanted = design();
    if (m_kind == StudyKind::TypeOne && m_tolerance[std::size_t(m_quantity->currentIndex())]->si() <= 0)
        return tr("State the tolerance that the part's quantity has: the gripper is measured against it.");
    const std::optional<Error> wrong = designProblem(wanted);
    return wrong ? wrong->describe() : QString();
}

void StudyForm::refresh()
{
    if (m_begin == nullptr)
        return;
    m_parts->setEnabled(namesIn(m_labels->text()).isEmpty());
    const QString wrong = problem();
    const PlanDesign wanted = design();
    const qsizetype squeezes =
        wanted.parts.size() * std::max<qsizetype>(1, wanted.operators.size()) * wanted.trials;
    m_hint->setText(
        !wrong.isEmpty() ? wrong
        : m_kind == StudyKind::Attributes
            ? tr("%1 verdicts in random order. Nobody sees what was said before.").arg(formatCount(squeezes))
            : tr("%1 squeezes in random order. Nobody sees a result before the end.")
                  .arg(formatCount(squeezes)));
    m_begin->setEnabled(wrong.isEmpty());
}

void StudyForm::focusField()
{
    m_name->setFocus();
    m_name->selectAll();
}

void StudyForm::submit()
{
    if (m_begin->isEnabled())
        emit submitted(request());
}

} // namespace gripscope
