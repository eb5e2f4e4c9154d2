// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/library.h"
#include "core/session/inspect/inspect_session.h"

#include <QAbstractListModel>
#include <QComboBox>
#include <QListView>
#include <QWidget>

#include <deque>
#include <vector>

namespace gripscope {

/// What one line of the list says.
struct InspectionLine {
    qint64 number = 0;
    QString graspId;
    InspectionOutcome outcome = InspectionOutcome::NotValid;
    QString type; ///< the type named, else empty
    double seconds = 0;
    bool suspect = false; ///< so was its measurement
    bool expected = true; ///< a type was
    bool voided = false;  ///< it does not count
};
/// "known type" where none was expected, "voided: as expected" where it does not count.
[[nodiscard]] QString outcomeWords(const InspectionLine& line);
[[nodiscard]] InspectionLine inspectionLine(const InspectionRecord& record);
[[nodiscard]] QString inWords(const InspectionLine& line); ///< "Inspection 12: A as expected"

class InspectionListModel : public QAbstractListModel {
    Q_OBJECT
public:
    enum Role {
        NumberRole = Qt::UserRole,
        OutcomeRole,
        TypeRole,
        SecondsRole,
        GraspRole,
        SuspectRole,
        WordsRole,
        VoidedRole
    };
    using QAbstractListModel::QAbstractListModel;
    void setLines(std::vector<InspectionLine> lines); ///< newest first
    [[nodiscard]] const std::vector<InspectionLine>& lines() const { return m_lines; }
    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

private:
    std::vector<InspectionLine> m_lines;
};

/// The last inspections, numbered, each with the sign, word and colour of its outcome.
class InspectionList : public QListView {
    Q_OBJECT
public:
    explicit InspectionList(QWidget* parent = nullptr);
    void setLines(std::vector<InspectionLine> lines) { m_model.setLines(std::move(lines)); }
    [[nodiscard]] const InspectionListModel& lineModel() const { return m_model; }

signals:
    void opened(const QString& graspId, qint64 number); ///< by a click or Enter

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    void open(const QModelIndex& index);
    InspectionListModel m_model;
};

/// The last twenty inspections as a sign each, in two rows like text: the newest is the last. Shape tells
/// them apart as well as colour; a click on one opens its squeeze.
class YieldStrip : public QWidget {
    Q_OBJECT
public:
    static constexpr std::size_t length = 20;
    explicit YieldStrip(QWidget* parent = nullptr);
    void setLines(std::deque<InspectionLine> lines); ///< oldest first; the last twenty are shown
    [[nodiscard]] QRect cell(int place) const;       ///< 0 to 19
    [[nodiscard]] QSize sizeHint() const override { return {272, 64}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {200, 64}; }

signals:
    void opened(const QString& graspId, qint64 number);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    bool event(QEvent* event) override;

private:
    [[nodiscard]] const InspectionLine* at(const QPoint& point) const;
    std::deque<InspectionLine> m_lines;
};

/// The type that is expected: chosen from the list, typed (the list narrows to what contains it), or scanned.
/// The item's data is the type's name, empty for "nothing expected".
class TypeChooser : public QComboBox {
    Q_OBJECT
public:
    explicit TypeChooser(QWidget* parent = nullptr);
    void setTypes(const std::vector<TypeRecord>& types); ///< what is chosen stays, if it is among them
    void setExpected(const QString& name); ///< without chosen(); nothing where there is no such type
    [[nodiscard]] QString expected() const { return currentData().toString(); }
    /// Chooses the type with this code or name; otherwise notFound(), and nothing is changed.
    void choose(const QString& codeOrName);
    [[nodiscard]] bool knows(const QString& codeOrName) const { return find(codeOrName.trimmed()) >= 0; }

signals:
    void chosen(const QString& name);
    void notFound(const QString& text);

protected:
    void wheelEvent(QWheelEvent* event) override; ///< nothing is chosen by turning a wheel in passing
    void focusOutEvent(QFocusEvent* event) override;

private:
    [[nodiscard]] int find(const QString& codeOrName) const; ///< below 0: none
    [[nodiscard]] int findTyped(const QString& text) const;  ///< the only one that contains it, too
    void takeTyped();
    void take(int index, const QString& text);
    void showExpected();
    QStringList m_codes; ///< of each item
};

} // namespace gripscope
