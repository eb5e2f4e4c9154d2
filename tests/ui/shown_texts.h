// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractItemView>
#include <QBuffer>
#include <QHeaderView>
#include <QRegularExpression>
#include <QStringList>
#include <QSvgGenerator>
#include <QWidget>
#include <QXmlStreamReader>

namespace gripscope::test {

/// Every text that `top` paints, delegates' and charts' included, in the order of painting.
[[nodiscard]] inline QStringList paintedTexts(QWidget& top)
{
    QBuffer buffer;
    QSvgGenerator svg; // each text that reaches a painter is an element of its own there
    svg.setOutputDevice(&buffer);
    svg.setSize(top.size());
    top.render(&svg);
    QStringList texts;
    QXmlStreamReader xml(buffer.data());
    while (!xml.atEnd())
        if (xml.readNext() == QXmlStreamReader::StartElement && xml.name() == u"text")
            texts << xml.readElementText(QXmlStreamReader::IncludeChildElements).trimmed();
    return texts;
}

/// What `top` paints, and what lies beyond it: every row of its tables, and all tips.
[[nodiscard]] inline QStringList shownTexts(QWidget& top)
{
    QStringList texts = paintedTexts(top);
    for (const QWidget* widget : top.findChildren<QWidget*>()) {
        texts << widget->toolTip();
        const auto* view = qobject_cast<const QAbstractItemView*>(widget);
        if (!view || !view->model() || qobject_cast<const QHeaderView*>(widget))
            continue;
        const QAbstractItemModel& model = *view->model();
        for (int column = 0; column < model.columnCount(view->rootIndex()); ++column) {
            texts << model.headerData(column, Qt::Horizontal).toString();
            for (int row = 0; row < std::min(model.rowCount(view->rootIndex()), 200); ++row) {
                const QModelIndex cell = model.index(row, column, view->rootIndex());
                texts << cell.data().toString() << cell.data(Qt::ToolTipRole).toString();
            }
        }
    }
    texts.removeAll(QString());
    texts.removeDuplicates();
    return texts;
}

/// Those of `texts` that say a metric unit of force, length or what follows from them: behind a number, in
/// brackets, or as all there is of a line.
[[nodiscard]] inline QStringList metricTexts(const QStringList& texts)
{
    static const QRegularExpression unit(QStringLiteral(
        R"re((?:^|\n|\(|[0-9)–][\s\x{00A0}\x{202F}])(?:[kMmµun]?N(?:[\s\x{00A0}]s)?/(?:mm|m)[²³]?|[kmµn]?N|[mµn]m|k?g|mg|[MG]?N/m)(?=$|[\s\x{00A0}),.;:]))re"));
    static const QRegularExpression metre(QStringLiteral(R"re([0-9][\s\x{00A0}]m(?=$|[\s),.;:]))re"));
    QStringList found;
    for (const QString& text : texts)
        if (unit.match(text).hasMatch() || metre.match(text).hasMatch())
            found << text;
    return found;
}

} // namespace gripscope::test
