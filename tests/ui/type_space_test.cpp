// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "ui/models/type_space.h"
#include "ui/pages/types/types_page_parts.h"
#include "ui/scene/type_scene.h"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>

using namespace gripscope;

namespace {

NewGrasp inNewtonsAndMetres(const QString& typeId)
{
    NewGrasp grasp;
    grasp.typeId = typeId;
    grasp.forceUnit = QStringLiteral("N");
    grasp.positionUnit = QStringLiteral("m");
    return grasp;
}

/// Of a gripper that tells no mass.
NewGrasp stiffnessAlone(const QString& typeId, double k, double e)
{
    NewGrasp grasp = inNewtonsAndMetres(typeId);
    Estimate estimate;
    estimate.estimator = Estimator::Static;
    estimate.status = EstimateStatus::Converged;
    grasp.estimates = {estimate};
    DeterminedQuantities determined;
    determined.space = {{TypeQuantity::Stiffness}};
    determined.log = LogVector::Constant(1, std::log(k * e));
    determined.covariance = LogMatrix::Constant(1, 1, 1e-6);
    grasp.determined = determined;
    return grasp;
}

NewGrasp yieldingGrasp(const QString& typeId, double tau_s, double e)
{
    NewGrasp grasp = inNewtonsAndMetres(typeId);
    Estimate estimate;
    estimate.status = EstimateStatus::Converged;
    estimate.parameters = MassDampingStiffness{0.04 * e, 40 / e, 1e4 * e};
    grasp.estimates = {estimate};
    using enum TypeQuantity;
    LogVector log(4);
    log << std::log(0.04 * e), std::log(40 / e), std::log(1e4 * e), std::log(tau_s / e);
    grasp.determined = DeterminedQuantities{{{Mass, Damping, Stiffness, RelaxationTime}}, log, {}};
    return grasp;
}

} // namespace

class TypeSpaceTest : public QObject {
    Q_OBJECT
private slots:
    void thePaperHasFourTypesOfTen()
    {
        const TypeSpace space = paperTypeSpace();
        QCOMPARE(space.types, (QStringList{QStringLiteral("A"), QStringLiteral("B"), QStringLiteral("C"),
                                           QStringLiteral("D")}));
        QCOMPARE(space.counts, (std::vector<int>{10, 10, 10, 10}));
        QCOMPARE(space.squeezes[13].id, QStringLiteral("B 4"));
        QCOMPARE(space.units.m, QStringLiteral("1"));
        QVERIFY(space.nearest && space.nearest->distance > 4);
        for (const auto& ellipsoid : space.ellipsoids)
            QVERIFY(ellipsoid);
    }
    void anExampleLibraryIsTheSameSpaceInSi()
    {
        QTemporaryDir folder;
        const auto library = Library::open(folder.filePath(QStringLiteral("library.db")));
        QVERIFY(library);
        QVERIFY((*library)->loadExampleTypes());
        const Expected<TypeSpace> space = libraryTypeSpace(**library);
        QVERIFY(space);
        QCOMPARE(space->types.size(), 4);
        QCOMPARE(space->squeezes.size(), std::size_t(40));
        QCOMPARE(space->units.k, QStringLiteral("N/m"));
        // A change of the unit of time scales m, b and k: distances in their logarithms stay.
        QVERIFY(std::abs(space->nearest->distance - paperTypeSpace().nearest->distance) < 1e-6);
    }
    void typesThatYieldUnlikeAreFarApart()
    {
        QTemporaryDir folder;
        const auto library = Library::open(folder.filePath(QStringLiteral("library.db")));
        QVERIFY(library);
        // Alike in m, b and k; a relaxation time of 20 and of 80 ms, each within 2 %.
        for (const double tau : {0.02, 0.08}) {
            const QString name = QString::number(tau);
            const auto type = (*library)->addType(name, {}, QStringLiteral("N"), QStringLiteral("m"));
            QVERIFY(type);
            for (const double e : {0.98, 1.0, 1.01, 1.02})
                QVERIFY((*library)->addGrasp(yieldingGrasp(type->id, tau, e)));
        }
        const Expected<TypeSpace> space = libraryTypeSpace(**library);
        QVERIFY(space && space->nearest);
        QCOMPARE(space->squeezes.size(), std::size_t(8));
        QVERIFY2(space->nearest->distance > 20, qPrintable(QString::number(space->nearest->distance)));
    }
    void typesWithoutAMassAreNamedAndHeldApart()
    {
        QTemporaryDir folder;
        const auto library = Library::open(folder.filePath(QStringLiteral("library.db")));
        QVERIFY(library);
        for (const auto& [name, k] : {std::pair("hard", 2e4), std::pair("soft", 1e4)}) {
            const auto type =
                (*library)->addType(QString::fromLatin1(name), {}, QStringLiteral("N"), QStringLiteral("m"));
            QVERIFY(type);
            for (const double e : {0.98, 1.0, 1.01, 1.02})
                QVERIFY((*library)->addGrasp(stiffnessAlone(type->id, k, e)));
        }
        const Expected<TypeSpace> space = libraryTypeSpace(**library);
        QVERIFY(space && space->types.isEmpty() && space->squeezes.empty());
        QCOMPARE(space->elsewhere.size(), std::size_t(2));
        QCOMPARE(elsewhereText(*space), QStringLiteral("hard (4), soft (4)"));
        // A factor of two, where squeezes scatter by 2 %.
        QVERIFY(space->nearest && space->nearest->distance > 20 &&
                space->nearest->one != space->nearest->other);
    }
    void aTypeThatComesChangesNoOthersSign()
    {
        QTemporaryDir folder;
        const auto library = Library::open(folder.filePath(QStringLiteral("library.db")));
        QVERIFY(library && (*library)->loadExampleTypes());
        const Expected<TypeSpace> before = libraryTypeSpace(**library);
        QVERIFY(before);
        QCOMPARE(before->signs, (std::vector<int>{0, 1, 2, 3}));
        const auto d = (*library)->findType(QStringLiteral("D"));
        QVERIFY(d && *d);
        QVERIFY((*library)->renameType((*d)->id, QStringLiteral("0"),
                                       {QStringLiteral("Ada"), QStringLiteral("its name")}));
        const Expected<TypeSpace> after = libraryTypeSpace(**library);
        QVERIFY(after);
        QCOMPARE(after->types.first(), QStringLiteral("0"));
        QCOMPARE(after->signs, (std::vector<int>{3, 0, 1, 2}));
        const SceneContent content = typeScene(*after, {true, true, true, true}, std::nullopt);
        QCOMPARE(content.points.front().color, 3);
        QCOMPARE(content.ellipsoids.front().color, 3);
        const SceneContent hidden = typeScene(*after, {false, true, true, true}, std::nullopt);
        QCOMPARE(hidden.ellipsoids.size(), std::size_t(3));
        QCOMPARE(hidden.ellipsoids.front().color, 0);
    }
    void hidingATypeMovesNothing()
    {
        const TypeSpace space = paperTypeSpace();
        const SceneContent all = typeScene(space, {true, true, true, true}, std::nullopt);
        const SceneContent some = typeScene(space, {true, false, true, true}, std::nullopt);
        QCOMPARE(all.points.size(), std::size_t(40));
        QCOMPARE(some.points.size(), std::size_t(30));
        QCOMPARE(some.ellipsoids.size(), std::size_t(3));
        for (std::size_t axis = 0; axis < 3; ++axis)
            QCOMPARE(some.axes[axis].low, all.axes[axis].low);
        QCOMPARE(all.axes[0].title(), QStringLiteral("Mass m (as printed)"));
    }
    void aSqueezeWithItsOwnErrorShowsIt()
    {
        TypeSpace space = paperTypeSpace();
        QVERIFY(!ownEllipsoid(space.squeezes[0]));
        QVERIFY(typeScene(space, {true, true, true, true}, std::nullopt).errors.empty());
        SpaceSqueeze& squeeze = space.squeezes[12]; // of B
        const Eigen::Vector3d deviation = squeeze.parameters.vector() * 0.01;
        squeeze.covariance = deviation.cwiseAbs2().asDiagonal();
        const std::optional<Ellipsoid> error = ownEllipsoid(squeeze);
        QVERIFY(error);
        // Along each axis the ellipsoid reaches as far as the quantile of chi with 3 degrees of freedom.
        const double reach = std::sqrt(7.814728);
        for (int axis = 0; axis < 3; ++axis)
            QVERIFY(std::abs(halfExtent(*error)[axis] / (reach * deviation[axis]) - 1) < 1e-4);
        QCOMPARE(typeScene(space, {true, true, true, true}, std::nullopt).errors.size(), std::size_t(1));
        QVERIFY(typeScene(space, {true, false, true, true}, std::nullopt).errors.empty());
        const QString text = parametersText(squeeze.parameters, space.units, squeeze.covariance);
        QVERIFY(text.contains(u'±'));
        QCOMPARE(space.find(squeeze.id)->number, squeeze.number);
        QVERIFY(!space.find(QStringLiteral("nobody")));
    }
};

GRIPSCOPE_TEST(TypeSpaceTest)
#include "type_space_test.moc"
