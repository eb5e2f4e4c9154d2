// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/types/paper_appendix.h"
#include "devices/address/virtual_object.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

struct Moments {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};
Moments moments(const std::vector<Eigen::Vector3d>& points)
{
    Moments out;
    for (const Eigen::Vector3d& x : points)
        out.mean += x / static_cast<double>(points.size());
    for (const Eigen::Vector3d& x : points)
        out.covariance +=
            (x - out.mean) * (x - out.mean).transpose() / static_cast<double>(points.size() - 1);
    return out;
}
Moments drawn(const VirtualObject& object, std::uint64_t squeezes)
{
    std::vector<Eigen::Vector3d> logs;
    for (std::uint64_t n = 0; n < squeezes; ++n)
        logs.push_back(object.draw(1, n).vector().array().log().matrix());
    return moments(logs);
}

Moments appendix(const QString& type)
{
    std::vector<Eigen::Vector3d> logs;
    for (const TypeSqueeze& squeeze : paperSqueezesInSi())
        if (squeeze.type == type)
            logs.push_back(squeeze.parameters.vector().array().log().matrix());
    return moments(logs);
}

} // namespace

class VirtualObjectTest : public QObject {
    Q_OBJECT
private slots:
    void cansScatterAsTheAppendixSays_data()
    {
        QTest::addColumn<QString>("type");
        for (const char* type : {"A", "B", "C", "D"})
            QTest::newRow(type) << QString::fromUtf8(type);
    }
    void cansScatterAsTheAppendixSays()
    {
        QFETCH(QString, type);
        Moments expected;
        for (const QString& each : {u"A"_qs, u"B"_qs, u"C"_qs, u"D"_qs}) {
            const Moments rows = appendix(each);
            expected.covariance += rows.covariance / 4;
            if (each == type)
                expected.mean = rows.mean;
        }
        constexpr int squeezes = 4000;
        const Moments found = drawn(*VirtualObject::fromText(type), squeezes);
        for (int i = 0; i < 3; ++i) {
            // Five standard errors of a mean and of a variance of normal draws.
            const double variance = expected.covariance(i, i);
            QVERIFY(std::abs(found.mean[i] - expected.mean[i]) < 5 * std::sqrt(variance / squeezes));
            QVERIFY(std::abs(found.covariance(i, i) / variance - 1) < 5 * std::sqrt(2.0 / squeezes));
            for (int j = 0; j < i; ++j) {
                const double scale = std::sqrt(variance * expected.covariance(j, j));
                QVERIFY(std::abs(found.covariance(i, j) - expected.covariance(i, j)) <
                        5 * scale * std::sqrt(2.0 / squeezes));
            }
        }
    }

    void aGivenObjectIsTheCentreOfItsDraws()
    {
        const VirtualObject object = *VirtualObject::fromText(u"0.5, 12,3000"_qs);
        QCOMPARE(object.centre().k, 3000.0);
        const Moments found = drawn(object, 4000);
        QVERIFY(std::abs(found.mean[0] - std::log(0.5)) < 0.005); // 4 % scatter / sqrt(4000) x 8
        QVERIFY(found.covariance(0, 0) > 1e-4);
    }

    void aDrawDependsOnSeedAndNumberAlone()
    {
        const VirtualObject object = *VirtualObject::fromText(u"B"_qs);
        QVERIFY(object.draw(3, 7) == object.draw(3, 7));
        QVERIFY(!(object.draw(3, 7) == object.draw(3, 8)));
        QVERIFY(!(object.draw(3, 7) == object.draw(4, 7)));
    }

    void otherTextsAreNoObjects_data()
    {
        QTest::addColumn<QString>("text");
        for (const char* text :
             {"", "E", "a", "1,2", "1,2,3,4", "0,1,1", "1,-1,1", "1,1,0", "nan,1,1", "1,inf,1", "x,1,1"})
            QTest::newRow(text) << QString::fromUtf8(text);
    }
    void otherTextsAreNoObjects()
    {
        QFETCH(QString, text);
        const auto object = VirtualObject::fromText(text);
        QVERIFY(!object);
        QVERIFY(object.error().code == ErrorCode::Usage);
    }
};

GRIPSCOPE_TEST(VirtualObjectTest)
#include "virtual_object_test.moc"
