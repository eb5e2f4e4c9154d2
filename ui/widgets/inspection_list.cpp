// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/format/number_format.h"
#include "ui/format/outcome_words.h"
#include "ui/theme/elided_text.h"
#include "ui/theme/theme.h"
#include "ui/widgets/inspection_widgets.h"
#include "ui/widgets/outcome_view.h"

#include <QCoreApplication>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QToolTip>

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

InspectionLine inspectionLine(const InspectionRecord& record)
{
    return {record.number,
            record.graspId,
            inspectionOutcome(record.judged(), record.type, record.expectedType),
            record.type,
            record.seconds,
            record.suspect && record.verdict != VerdictKind::Invalid,
            !record.expectedType.isEmpty(),
            !record.voided.isEmpty()};
}

QString outcomeWords(const InspectionLine& line)
{
    QString words = outcomeWord(line.outcome, line.suspect, line.expected);
    return line.voided ? QCoreApplication::translate("InspectionLine", "voided: %1").arg(words) : words;
}

QString inWords(const InspectionLine& line)
{
    return QCoreApplication::translate("InspectionLine", "Inspection %1: %2 %3")
        .arg(line.number)
        .arg(line.type, outcomeWords(line))
        .simplified();
}

void InspectionListModel::setLines(std::vector<InspectionLine> lines)
{
    beginResetModel();
    m_lines = std::move(lines);
    endResetModel();
}

int InspectionListModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_lines.size());
}

QVariant InspectionListModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid))
        return {};
    const InspectionLine& line = m_lines[static_cast<std::size_t>(index.row())];
    switch (role) {
    case Qt::DisplayRole:
    case Qt::AccessibleTextRole:
        return inWords(line);
    case Qt::ToolTipRole: // a long name ends in dots
        return line.type.isEmpty() ? outcomeWords(line) : u"%1 · %2"_s.arg(line.type, outcomeWords(line));
    case NumberRole:
        return line.number;
    case OutcomeRole:
        return static_cast<int>(line.outcome);
    case TypeRole:
        return line.type;
    case SecondsRole:
        return line.seconds;
    case GraspRole:
        return line.graspId;
    case SuspectRole:
        return line.suspect;
    case WordsRole:
        return outcomeWords(line);
    case VoidedRole:
        return line.voided;
    default:
        return {};
    }
}

namespace {

class LineDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override
    {
        return {200, 36};
    }

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        const ThemeTokens& t = Theme::instance().tokens();
        const auto outcome =
            static_cast<InspectionOutcome>(index.data(InspectionListModel::OutcomeRole).toInt());
        const bool suspect = index.data(InspectionListModel::SuspectRole).toBool();
        const QColor color = Theme::instance().outcomeColor(outcome, suspect);
        const QRectF box(option.rect);
        painter->save();
        const bool selected = option.state & QStyle::State_Selected;
        Theme::paintRow(*painter, option.rect, selected);
        if (!selected && option.state & QStyle::State_MouseOver)
            painter->fillRect(box.adjusted(0, 0, 0, -1), Theme::mix(t.surface, t.accent, 0.06));
        const QFontMetricsF small(Theme::font(metrics::fontSmall));
        painter->setPen(t.secondText);
        painter->setFont(Theme::font(metrics::fontSmall));
        const QString number = u"#%1"_s.arg(index.data(InspectionListModel::NumberRole).toLongLong());
        const double numberWide = std::max(36.0, small.horizontalAdvance(number));
        painter->drawText(box.adjusted(16, 0, 0, 0), Qt::AlignVCenter | Qt::AlignLeft, number);
        const QString seconds = formatLength(index.data(InspectionListModel::SecondsRole).toDouble());
        painter->drawText(box.adjusted(0, 0, -16, 0), Qt::AlignVCenter | Qt::AlignRight, seconds);
        const double left = box.left() + 16 + numberWide + 4;
        paintJudgedSign(*painter, QRectF(left, box.center().y() - 9, 18, 18), outcome, suspect);
        const double from = left + 26;
        const double room = box.right() - 24 - small.horizontalAdvance(seconds) - from;
        const bool voided = index.data(InspectionListModel::VoidedRole).toBool();
        const bool plain = voided || (outcome == InspectionOutcome::AsExpected && !suspect);
        QFont font = Theme::font(metrics::fontBase, !plain);
        font.setStrikeOut(voided);
        painter->setFont(font);
        painter->setPen(plain ? t.text : color);
        const QString type = index.data(InspectionListModel::TypeRole).toString();
        const QString outcomeText = index.data(InspectionListModel::WordsRole).toString();
        const QString words = type.isEmpty() ? outcomeText : u"%1 · %2"_s.arg(type, outcomeText);
        painter->drawText(QRectF(from, box.top(), room, box.height()), Qt::AlignVCenter | Qt::AlignLeft,
                          elided(QFontMetricsF(font), words, room));
        painter->restore();
    }
};

} // namespace

InspectionList::InspectionList(QWidget* parent) : QListView(parent)
{
    setModel(&m_model);
    setItemDelegate(new LineDelegate(this));
    setUniformItemSizes(true);
    setMouseTracking(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    setAccessibleName(tr("Last inspections"));
    setToolTip(tr("Click a line to see its squeeze on the Fit page"));
    setFocusPolicy(Qt::TabFocus); // a click must not take Space from the squeeze
    connect(this, &QListView::clicked, this, &InspectionList::open);
}

void InspectionList::open(const QModelIndex& index)
{
    emit opened(index.data(InspectionListModel::GraspRole).toString(),
                index.data(InspectionListModel::NumberRole).toLongLong());
}

void InspectionList::keyPressEvent(QKeyEvent* event)
{
    if ((event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) && currentIndex().isValid())
        open(currentIndex());
    else
        QListView::keyPressEvent(event);
}

namespace {
constexpr int columns = 10;
constexpr int rows = static_cast<int>(YieldStrip::length) / columns;
} // namespace

YieldStrip::YieldStrip(QWidget* parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
    setLines({});
}

void YieldStrip::setLines(std::deque<InspectionLine> lines)
{
    while (lines.size() > length)
        lines.pop_front();
    m_lines = std::move(lines);
    const auto good = [this](bool expected) {
        return std::count_if(m_lines.begin(), m_lines.end(), [expected](const InspectionLine& line) {
            return line.outcome == InspectionOutcome::AsExpected && !line.voided && line.expected == expected;
        });
    };
    QStringList told;
    if (std::any_of(m_lines.begin(), m_lines.end(), [](const InspectionLine& line) { return line.expected; }))
        told << tr("%1 as expected").arg(good(true));
    if (good(false) > 0)
        told << tr("%1 of a known type").arg(good(false));
    const QString count = tr("Last %1 inspections").arg(m_lines.size());
    setAccessibleName(told.isEmpty() ? count : u"%1: %2"_s.arg(count, told.join(u", "_s)));
    update();
}

QRect YieldStrip::cell(int place) const
{
    const int row = place / columns;
    const int column = place % columns;
    const int left = column * width() / columns;
    const int top = row * height() / rows;
    return {QPoint(left, top), QPoint((column + 1) * width() / columns - 1, (row + 1) * height() / rows - 1)};
}

const InspectionLine* YieldStrip::at(const QPoint& point) const
{
    for (std::size_t place = 0; place < m_lines.size(); ++place)
        if (cell(static_cast<int>(place)).contains(point))
            return &m_lines[place];
    return nullptr;
}

void YieldStrip::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    const ThemeTokens& t = Theme::instance().tokens();
    for (int place = 0; place < static_cast<int>(length); ++place) {
        const QRectF box = QRectF(cell(place)).adjusted(2, 2, -2, -2);
        if (static_cast<std::size_t>(place) >= m_lines.size()) {
            painter.fillRect(QRectF(box.left() + 8, box.center().y() - 1, box.width() - 16, 2), t.line);
            continue;
        }
        const InspectionLine& line = m_lines[static_cast<std::size_t>(place)];
        const QColor color = Theme::instance().outcomeColor(line.outcome, line.suspect);
        if (static_cast<std::size_t>(place) + 1 == m_lines.size()) { // the newest is framed
            painter.setPen(QPen(color, t.lineWidth));
            painter.setBrush(Qt::NoBrush);
            painter.drawRect(box.adjusted(0.5, 0.5, -0.5, -0.5));
        }
        paintJudgedSign(painter, QRectF(box.center() - QPointF(8.5, 8.5), QSizeF(17, 17)), line.outcome,
                        line.suspect);
    }
}

void YieldStrip::mouseReleaseEvent(QMouseEvent* event)
{
    const InspectionLine* line = at(event->position().toPoint());
    if (line && event->button() == Qt::LeftButton)
        emit opened(line->graspId, line->number);
}

bool YieldStrip::event(QEvent* event)
{
    if (event->type() != QEvent::ToolTip)
        return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    const InspectionLine* line = at(help->pos());
    QToolTip::showText(help->globalPos(), line ? inWords(*line) : QString(), this);
    return true;
}

} // namespace gripscope
