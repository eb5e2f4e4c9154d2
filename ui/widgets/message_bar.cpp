// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/message_bar.h"

#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/outcome_view.h"

#include <QHBoxLayout>
#include <QPainter>

namespace gripscope {

namespace {

constexpr qsizetype mostMessages = 20;

class MessageSign : public QWidget {
public:
    explicit MessageSign(const MessageBar& bar) : QWidget(nullptr), m_bar(&bar) { setFixedSize(28, 28); }

protected:
    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        const InspectionOutcome like =
            m_bar->isGood(m_bar->message()) ? InspectionOutcome::AsExpected : InspectionOutcome::NotValid;
        paintOutcomeSign(painter, rect(), like, Theme::instance().outcomeColor(like));
    }

private:
    const MessageBar* m_bar;
};

} // namespace

MessageBar::MessageBar(QWidget* parent) : QFrame(parent)
{
    setRole(this, "message");
    setAccessibleName(tr("Message"));
    m_text = makeLabel({}, "", this);
    m_text->setWordWrap(true);
    m_text->setTextFormat(Qt::PlainText);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_more = makeLabel({}, "caption", this);
    m_dismiss = makeButton(tr("Dismiss"), {}, "", this);
    m_dismiss->setObjectName("dismissButton");
    connect(m_dismiss, &QPushButton::clicked, this, &MessageBar::dismiss);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 2, 16, 2);
    row->setSpacing(12);
    m_sign = new MessageSign(*this);
    row->addWidget(m_sign);
    row->addWidget(m_text, 1);
    row->addWidget(m_more);
    row->addWidget(m_dismiss);
    hide();
}

void MessageBar::show(const QString& message)
{
    m_good.removeAll(message);
    put(message);
}

void MessageBar::tell(const QString& message)
{
    if (!m_good.contains(message))
        m_good.append(message);
    put(message);
}

void MessageBar::put(const QString& message)
{
    m_messages.removeAll(message);
    m_messages.prepend(message);
    while (m_messages.size() > mostMessages)
        m_messages.removeLast();
    refresh();
}

void MessageBar::dismiss()
{
    if (!m_messages.isEmpty())
        m_messages.removeFirst();
    refresh();
}

void MessageBar::withdraw(const QString& message)
{
    m_messages.removeAll(message);
    refresh();
}

QString MessageBar::message() const
{
    return m_messages.value(0);
}

void MessageBar::refresh()
{
    m_good.removeIf([this](const QString& one) { return !m_messages.contains(one); });
    m_sign->update();
    m_text->setText(message());
    m_more->setVisible(m_messages.size() > 1);
    m_more->setText(tr("%n more", nullptr, static_cast<int>(m_messages.size()) - 1));
    setVisible(!m_messages.isEmpty());
    setAccessibleDescription(message());
    emit changed();
}

} // namespace gripscope
