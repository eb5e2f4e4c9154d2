// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/windows/question.h"

#include "ui/widgets/controls.h"
#include "ui/widgets/plain_text.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {

const RegisteredDialog<Question> questionRow("question", [](Workbench&, QWidget* over) {
    return new Question(u"Go on?"_s, u"What follows from it."_s, u"Go on"_s, u"Cancel"_s, over);
});
const RegisteredDialog<TextQuestion> textRow("text", [](Workbench&, QWidget* over) {
    return new TextQuestion(u"Why?"_s, u"The reason is kept."_s, {}, u"Keep"_s, over);
});

constexpr int width_px = 480;

QVBoxLayout* beginColumn(Dialog* dialog, const QString& title)
{
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(title);
    auto* column = new QVBoxLayout(dialog);
    setSpacing(column, 24, 16);
    column->addWidget(makeLabel(title, "heading", dialog));
    return column;
}

QLabel* makeWords(const QString& words, QWidget* parent)
{
    QLabel* label = makeLabel(words, "", parent);
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    return label;
}

} // namespace

Question::Question(const QString& title, const QString& words, const QString& yes, const QString& no,
                   QWidget* parent)
    : Dialog(parent), m_yes(makeButton(yes, {}, "", this)), m_no(makeButton(no, {}, "primary", this))
{
    QVBoxLayout* column = beginColumn(this, title);
    column->addWidget(makeWords(words, this));
    column->addStretch(1);
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    row->addStretch(1);
    row->addWidget(m_yes);
    row->addWidget(m_no);
    column->addLayout(row);
    m_yes->setObjectName("questionYes");
    m_yes->setAutoDefault(false);
    m_no->setObjectName("questionNo");
    m_no->setDefault(true);
    m_no->setFocus();
    connect(m_yes, &QPushButton::clicked, this, &QDialog::accept);
    connect(m_no, &QPushButton::clicked, this, &QDialog::reject);
    resize(width_px, heightForWidth(width_px));
}

TextQuestion::TextQuestion(const QString& title, const QString& words, const QString& initial,
                           const QString& accept, QWidget* parent)
    : Dialog(parent), m_field(new QLineEdit(initial, this)), m_accept(makeButton(accept, {}, "primary", this))
{
    QVBoxLayout* column = beginColumn(this, title);
    QLabel* label = makeWords(withoutKeys(words), this); // of a field: it would look for a key after "&"
    label->setBuddy(m_field);
    column->addWidget(label);
    column->addWidget(m_field);
    column->addStretch(1);
    m_field->setObjectName("answerField");
    m_field->setAccessibleName(title);
    m_field->setAccessibleDescription(words);
    m_field->selectAll();
    m_field->setFocus();
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    QPushButton* cancel = makeButton(tr("Cancel"), {}, "", this);
    cancel->setAutoDefault(false);
    m_accept->setObjectName("answerAccept");
    m_accept->setDefault(true);
    row->addStretch(1);
    row->addWidget(cancel);
    row->addWidget(m_accept);
    column->addLayout(row);
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_accept, &QPushButton::clicked, this, &QDialog::accept);
    connect(this, &QDialog::accepted, this, [this] { emit answered(text()); });
    resize(width_px, heightForWidth(width_px));
}

void TextQuestion::requireText()
{
    const auto refresh = [this] { m_accept->setEnabled(!text().trimmed().isEmpty()); };
    connect(m_field, &QLineEdit::textChanged, this, refresh);
    refresh();
}

QString TextQuestion::text() const
{
    return m_field->text();
}

} // namespace gripscope
