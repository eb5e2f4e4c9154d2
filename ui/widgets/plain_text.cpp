// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/plain_text.h"

#include "core/base/printable.h"
#include "ui/widgets/controls.h"

#include <QApplication>
#include <QEvent>
#include <QLabel>

namespace gripscope {

namespace {

/// Every widget is polished before its size is asked for and before it is painted, a tooltip before it has
/// its text.
class PlainTextKeeper : public QObject {
public:
    using QObject::QObject;
    bool eventFilter(QObject* watched, QEvent* event) override
    {
        if (event->type() == QEvent::Polish)
            if (auto* label = qobject_cast<QLabel*>(watched); label && label->textFormat() == Qt::AutoText)
                label->setTextFormat(Qt::PlainText);
        return false;
    }
};

} // namespace

void keepTextPlain()
{
    static const QString name = QStringLiteral("plainTextKeeper");
    if (!qApp || qApp->findChild<QObject*>(name, Qt::FindDirectChildrenOnly))
        return;
    auto* keeper = new PlainTextKeeper(qApp);
    keeper->setObjectName(name);
    qApp->installEventFilter(keeper);
}

QLabel* makeMarkedLabel(const QString& html, const char* role, QWidget* parent)
{
    QLabel* label = makeLabel({}, role, parent);
    label->setTextFormat(Qt::RichText);
    label->setText(html);
    return label;
}

QString withoutKeys(const QString& text)
{
    return QString(text).replace(u'&', QStringLiteral("&&"));
}

QString titleText(const QString& text)
{
    return printable(text, longestQuote).replace(QStringLiteral("[*]"), QStringLiteral("[*][*]"));
}

} // namespace gripscope
