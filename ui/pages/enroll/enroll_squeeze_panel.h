// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/recursive/recursive_estimator.h"
#include "core/session/enroll/enroll_session.h"
#include "core/session/enroll/enrollment_advice.h"
#include "ui/format/number_format.h"
#include "ui/models/row_table_model.h"

#include <QCoreApplication>
#include <QObject>
#include <QString>
#include <QWidget>

#include <map>
#include <optional>

class QCheckBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableView;

namespace gripscope {

class PartPictureView;
class ProgressRing;
class Workbench;

/// What is known of a squeeze while it runs: k, b and m so far, a line each, and how well the stiffness is
/// known by now.
class LiveSqueezeWords {
    Q_DECLARE_TR_FUNCTIONS(LiveSqueezeWords)
public:
    QString numbers, quality;
};
[[nodiscard]] LiveSqueezeWords liveSqueezeWords(const std::optional<RecursiveState>& state,
                                                const QString& forceUnit, const QString& positionUnit);

/// The lines as every squeeze shows them.
[[nodiscard]] QString threeLines(const QString& k, const QString& b, const QString& m);

/// What a squeeze told, m, b and k each in a line, what there is besides in another; empty where it told
/// nothing.
[[nodiscard]] QString numbersOf(const EnrollSqueeze& squeeze);

/// Advice on the enrolment under way, worked out in the pool whenever its squeezes change.
class EnrollAdvisor : public QObject {
    Q_OBJECT
public:
    explicit EnrollAdvisor(Workbench& workbench, QObject* parent = nullptr);
    /// Looks whether the squeezes changed, and asks for advice if they did; cheap if not.
    void follow();
    /// On the squeezes as they are; nothing while it is being worked out.
    [[nodiscard]] const std::optional<EnrollmentAdvice>& advice() const { return m_advice; }

signals:
    void changed();

private:
    void ask();
    Workbench* m_workbench;
    AdviceRequest m_request; ///< what advice() is about, or will be
    bool m_asking = false;
    std::optional<EnrollmentAdvice> m_advice;
};

/// The squeezes of an enrolment as rows, ready to read.
class EnrollSqueezeModel : public RowTableModel {
    Q_OBJECT
public:
    enum class Column { Number, Part, Stiffness, Damping, Mass, Fit, Verdict, Count };
    using RowTableModel::RowTableModel;

    /// Takes over what the session holds; cheap when nothing changed, which it says by false.
    /// `outliers`: by row, why the squeeze does not go with the others.
    bool refresh(const std::vector<EnrollSqueeze>& squeezes, const std::map<int, QString>& outliers = {});
    [[nodiscard]] bool isAccepted(int row) const;
    [[nodiscard]] bool hasParts() const; ///< some squeeze says which part it was of

    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

private:
    [[nodiscard]] int length() const override { return static_cast<int>(m_rows.size()); }
    [[nodiscard]] int width() const override { return static_cast<int>(Column::Count); }
    [[nodiscard]] QVariant head(int column, int role) const override;

    struct Row {
        EnrollSqueeze::Decision decision = EnrollSqueeze::Decision::Pending;
        QString part, reason, fit, verdict, outlier;
        FormattedNumber stiffness, damping, mass;
        friend bool operator==(const Row&, const Row&) = default;
    };
    /// The unit that all numbers of a column share: it then stands in the header once. Empty: each has its
    /// own.
    [[nodiscard]] QString commonUnit(FormattedNumber Row::*column) const;
    [[nodiscard]] static Row makeRow(const EnrollSqueeze& squeeze);
    [[nodiscard]] QString text(const Row& row, int number, Column column) const;
    std::vector<Row> m_rows;
};

/// "valid", "suspect", "not valid"; a squeeze taken over from the library was judged when it was enrolled.
[[nodiscard]] QString validityWord(const EnrollSqueeze& squeeze);

/// The squeeze step of an enrolment: a ring that fills, the last squeeze with accept and reject, and all of
/// them; with words on whether they are enough, and which of them does not go with the others.
class EnrollSqueezePanel : public QWidget {
    Q_OBJECT
public:
    explicit EnrollSqueezePanel(Workbench& workbench, QWidget* parent = nullptr);
    void refresh();
    void focusNext(); ///< on what is to be done next
    /// What Space does here: squeeze when one is due, accept when one waits for it.
    void squeezeOrAccept();
    /// Valid squeezes that go with the others are accepted without asking; on at first.
    void setAcceptsByItself(bool on);
    /// The squeeze that waits, or will, is a person's to decide on.
    void leaveToPerson() { m_ownSqueeze = -1; }

signals:
    void changed();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QWidget* makeSide();
    QWidget* makeLast(QWidget* parent);
    QWidget* makePart(QWidget* parent);
    QWidget* makeTable();
    void squeeze();
    void accept();
    void reject();
    void askDrop();
    void review();
    void tell(const Expected<void>& done);
    void refreshLast();
    bool showLive();
    void acceptByItself();
    [[nodiscard]] bool decidesByItself() const;
    void refreshAdvice();
    [[nodiscard]] int rowToDrop() const; ///< the selected one, else an accepted outlier; -1: none
    [[nodiscard]] QString outlierReason(int row) const;
    Workbench* m_workbench;
    EnrollAdvisor m_advisor;
    EnrollSqueezeModel m_model;
    QLabel *m_title, *m_advice, *m_hint, *m_lastTitle, *m_lastNumbers, *m_lastWords;
    ProgressRing* m_ring;
    PartPictureView* m_picture;
    QLineEdit* m_part;
    QCheckBox* m_itself;
    QPushButton *m_squeeze, *m_arm, *m_accept, *m_reject, *m_drop, *m_review;
    QTableView* m_table;
    bool m_ready = false;
    int m_wanted = EnrollSession::suggestedSqueezes; ///< by the ring; as the advice says
    int m_ownSqueeze = -1; ///< row of the squeeze that may be accepted by itself; -1: none
    EnrollSession::Activity m_shown = EnrollSession::Activity::Waiting;
};

} // namespace gripscope
