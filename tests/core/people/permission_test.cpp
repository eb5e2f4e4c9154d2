// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/people/permission.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;
using namespace Qt::StringLiterals;

class PermissionTest : public QObject {
    Q_OBJECT
private slots:
    void isReadAsItIsWritten()
    {
        for (int i = 0; i <= static_cast<int>(Permission::Arm); ++i) {
            const auto permission = static_cast<Permission>(i);
            QVERIFY(!toString(permission).isEmpty());
            QVERIFY(permissionFromString(toString(permission)) == permission);
        }
        QVERIFY(!permissionFromString({}));
        QVERIFY(!permissionFromString(u"fly"_s));
        for (const ArmingPolicy policy : {ArmingPolicy::SignedIn, ArmingPolicy::Supervisors})
            QVERIFY(armingPolicyFromString(toString(policy)) == policy);
        QVERIFY(!armingPolicyFromString(u"anybody"_s));
    }

    void onlyArmingIsAnOperatorsAndOnlyByThePolicy()
    {
        for (int i = 0; i <= static_cast<int>(Permission::Arm); ++i) {
            const auto permission = static_cast<Permission>(i);
            for (const ArmingPolicy policy : {ArmingPolicy::SignedIn, ArmingPolicy::Supervisors}) {
                const bool arms = permission == Permission::Arm && policy == ArmingPolicy::SignedIn;
                QCOMPARE(mayDo(Role::Operator, permission, policy), arms);
                QVERIFY(mayDo(Role::Supervisor, permission, policy));
            }
        }
    }
};

GRIPSCOPE_TEST(PermissionTest)
#include "permission_test.moc"
