// Shows that the strain of a flow is the symmetric part of its gradient without the trace.

#include "lubcontact_strain.h"
#include "tools.h"

using namespace LAMMPS_NS::Lubcontact_NS;
using namespace testing_tools;

TEST(Strain, IsTheSymmetricPartOfTheGradientWithoutItsTrace)
{
  Random rnd(1);
  for (int trial = 0; trial < 20; trial++) {
    const Vec3 rows[] = {{rnd.uniform(-1, 1), rnd.uniform(-1, 1), rnd.uniform(-1, 1)},
                         {0.0, rnd.uniform(-1, 1), rnd.uniform(-1, 1)},
                         {0.0, 0.0, rnd.uniform(-1, 1)}};
    const Strain e =
        strain_of_gradient(rows[0].x, rows[1].y, rows[2].z, rows[0].y, rows[0].z, rows[1].z);
    EXPECT_NEAR(e.xx + e.yy + e.zz, 0.0, 1e-15);
    // stretching of a line n: n.L.n and a third of the divergence
    const Vec3 n = rnd.unit();
    const Vec3 moved{dot(rows[0], n), dot(rows[1], n), dot(rows[2], n)};
    const double dilation = rows[0].x + rows[1].y + rows[2].z;
    const PairStrain s = pair_strain(e, n);
    EXPECT_NEAR(s.along, dot(n, moved) - dilation / 3.0, 1e-15);
    EXPECT_NEAR(dot(s.across, n), 0.0, 1e-15);
    // across: n turns by it and by the spin of the flow, (1/2) curl
    const Vec3 spin = 0.5 * Vec3{-rows[1].z, rows[0].z, -rows[0].y};
    expect_near(s.across + cross(spin, n), moved - dot(n, moved) * n, 1e-15);
  }
}
