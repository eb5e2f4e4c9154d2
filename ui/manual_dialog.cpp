// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/manual_dialog.h"

#include "ui/widgets/controls.h"

#include <QTextBrowser>
#include <QUrl>
#include <QVBoxLayout>

namespace gripscope {

using namespace Qt::StringLiterals;

QString manualPageFor(const QString& screen)
{
    if (screen == u"fit")
        return u"identification.md"_s;
    if (screen == u"live")
        return u"link.md"_s;
    if (screen == u"inspect")
        return u"inspect.md"_s;
    if (screen == u"history")
        return u"validity.md"_s;
    if (screen == u"enroll")
        return u"records.md"_s;
    return u"index.md"_s;
}

ManualDialog::ManualDialog(const QString& screen, QWidget* parent)
    : QDialog(parent), m_browser(new QTextBrowser)
{
    setWindowTitle(tr("Manual"));
    setAttribute(Qt::WA_DeleteOnClose);
    m_browser->setAccessibleName(tr("Manual"));
    m_browser->setFrameShape(QFrame::NoFrame);
    m_browser->document()->setDocumentMargin(16);
    m_browser->setSource(QUrl(u"qrc:/manual/"_s + manualPageFor(screen)), QTextDocument::MarkdownResource);
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 12, 12);
    column->addWidget(m_browser, 1);
    auto* line = new QHBoxLayout;
    auto* contents = makeButton(tr("Contents"));
    auto* back = makeButton(tr("Back"));
    back->setEnabled(false);
    auto* close = makeButton(tr("Close"), {}, "primary");
    for (QPushButton* button : {contents, back, close})
        button->setAutoDefault(false);
    line->addWidget(contents);
    line->addWidget(back);
    line->addStretch(1);
    line->addWidget(close);
    column->addLayout(line);
    connect(contents, &QPushButton::clicked, m_browser, [this] {
        m_browser->setSource(QUrl(u"qrc:/manual/index.md"_s), QTextDocument::MarkdownResource);
    });
    connect(back, &QPushButton::clicked, m_browser, &QTextBrowser::backward);
    connect(m_browser, &QTextBrowser::backwardAvailable, back, &QPushButton::setEnabled);
    connect(close, &QPushButton::clicked, this, &QDialog::accept);
    resize(760, 620);
}

} // namespace gripscope
