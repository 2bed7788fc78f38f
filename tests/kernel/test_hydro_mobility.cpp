// The far field as a whole: mobility of spheres in a periodic cell, and what follows from it.

#include "hydro_case.h"

#ifdef SUSPENSION_FFTW

using namespace hydro_case;

namespace {

#include "reference/hydro_reference.h"

struct Reference {
  Spheres spheres;
  Numbers load, motion;
};

Reference reference(int set)
{
  Reference r;
  const auto add = [](const double *a, const double *b, const double *s, Numbers &to) {
    double five[5];
    put_strain({{s[0], s[1], s[2]}, {s[1], s[3], s[4]}, {s[2], s[4], -s[0] - s[3]}}, five);
    to.insert(to.end(), a, a + 3);
    to.insert(to.end(), b, b + 3);
    to.insert(to.end(), five, five + 5);
  };
  for (const MobilityRow &row : MOBILITY) {
    if (row.set != set) continue;
    const double *c = row.cell;
    r.spheres.cell = {{}, c[0], c[1], c[2], c[3], c[4], c[5]};
    r.spheres.radius.push_back(row.radius);
    r.spheres.x.push_back({row.x[0], row.x[1], row.x[2]});
    add(row.force, row.torque, row.stresslet, r.load);
    add(row.velocity, row.spin, row.strain, r.motion);
  }
  return r;
}

TEST(HydroMobility, SumOverWavesIsThatOfTheReference)
{
  for (const int set : {1, 2}) {
    const Reference r = reference(set);
    EXPECT_LT(relative_error(r.motion, spectral_motion(r.spheres, r.load)), 1e-6);
  }
}

// 8e-4 at most for the default; exact in the end
TEST(HydroMobility, GridConvergesToTheReference)
{
  for (const int set : {1, 2}) {
    const Reference r = reference(set);
    const auto error = [&](const Settings &s) {
      return relative_error(r.motion, GridMobility(r.spheres, s)(r.load));
    };
    EXPECT_LT(error({}), 8e-4);
    EXPECT_LT(error({1.0, 0.82, 6.0, 6}), 2.5e-4);
    EXPECT_LT(error({1.0, 0.82, 6.0, 8}), 1.5e-4);
    EXPECT_LT(error({0.8, 0.82, 5.0, 6}), 8e-4);
    EXPECT_LT(error({0.8, 0.82, 5.0, 4}), 4e-3);
    EXPECT_LT(error({1.0, 0.50, 9.0, 10}), 1e-6);
    EXPECT_LT(error({0.8, 0.50, 9.0, 10}), 1e-6);    // the width is that of the method alone
    EXPECT_LT(relative_error(spectral_motion(r.spheres, r.load, 1e-12),
                             GridMobility(r.spheres, {1.0, 0.4, 13.0, 12})(r.load)),
              1e-9);
  }
}

TEST(HydroMobility, RanksAgree)
{
  const Reference r = reference(1);
  Settings s;
  const Numbers one = GridMobility(r.spheres, s)(r.load);
  for (const int ranks : {2, 5, 20}) {
    s.ranks = ranks;
    EXPECT_LT(relative_error(one, GridMobility(r.spheres, s)(r.load)), 1e-14);
  }
}

double product(const Numbers &a, const Numbers &b)
{
  double sum = 0.0;
  for (std::size_t n = 0; n < a.size(); n++) sum += a[n] * b[n];
  return sum;
}

TEST(HydroMobility, SymmetricAndPositive)
{
  Random rnd(61);
  for (const int set : {1, 2}) {
    const Spheres s = reference(set).spheres;
    const GridMobility m(s, Settings());
    for (int trial = 0; trial < 5; trial++) {
      const Numbers a = random_loads(rnd, s), b = random_loads(rnd, s);
      const double ab = product(a, m(b)), ba = product(b, m(a));
      EXPECT_NEAR(ab, ba, 1e-12 * std::fabs(product(a, m(a))));
      EXPECT_GT(product(a, m(a)), 0.0);
    }
  }
}

// the smallest eigenvalue by inverse iteration, of spheres that overlap, too
TEST(HydroMobility, PositiveForSpheresThatOverlap)
{
  Random rnd(62);
  Spheres s{cubic(6.0), {}, {}};
  for (int n = 0; n < 12; n++) {
    s.x.push_back(rnd.vector(3.0));
    s.radius.push_back(rnd.uniform(0.7, 1.4));
  }
  const GridMobility m(s, {1.0, 0.7, 7.0, 8});
  const auto apply = [&](const Numbers &a, Numbers &b) {
    b = m(a);
  };
  const auto same = [](const Numbers &a, Numbers &b) {
    b = a;
  };
  const auto agree = [](double value) {
    return value;
  };
  Numbers a = random_loads(rnd, s), b(a.size());
  double smallest = 0.0;
  for (int round = 0; round < 3; round++) {
    LAMMPS_NS::Pore_NS::conjugate_gradients(apply, same, agree, a, 1e-4, 300, b);
    smallest = product(b, m(b)) / product(b, b);
    EXPECT_GT(smallest, 0.0);
    const double size = std::sqrt(product(b, b));
    for (std::size_t n = 0; n < a.size(); n++) a[n] = b[n] / size;
  }
}

TEST(HydroMobility, OrderAndOriginDoNotMatter)
{
  const Reference r = reference(2);
  const std::size_t n = r.spheres.size();
  const Numbers before = GridMobility(r.spheres, Settings())(r.load);
  Spheres s = r.spheres;
  Numbers load, expected;
  for (std::size_t i = 0; i < n; i++) {
    const std::size_t from = n - 1 - i;
    s.x[i] = r.spheres.x[from];
    s.radius[i] = r.spheres.radius[from];
    load.insert(load.end(), &r.load[11 * from], &r.load[11 * from] + 11);
    expected.insert(expected.end(), &before[11 * from], &before[11 * from] + 11);
  }
  EXPECT_LT(relative_error(expected, GridMobility(s, Settings())(load)), 1e-14);
  // other images, and another origin of the cell: points of the grid move with it
  for (std::size_t i = 0; i < n; i++)
    s.x[i] = s.x[i] + image(s.cell, static_cast<int>(i) % 3 - 1, 2, -1);
  s.cell.origin = {0.1, 0.2, 0.3};
  const Settings exact{1.0, 0.5, 9.0, 12};
  const Numbers elsewhere = GridMobility(s, exact)(load);
  for (Vec3 &x : s.x) x = x - s.cell.origin;
  s.cell.origin = {};
  EXPECT_LT(relative_error(GridMobility(s, exact)(load), elsewhere), 1e-14);
  for (Vec3 &x : s.x) x = x + Vec3{0.1, 0.2, 0.3};
  EXPECT_LT(relative_error(GridMobility(s, exact)(load), elsewhere), 1e-6);
}

// a cell that is tilted by one of its edges is the same lattice of spheres
TEST(HydroMobility, WholeTiltIsNoTilt)
{
  const Reference r = reference(1);
  const Settings exact{1.0, 0.5, 8.0, 12};
  const Numbers before = GridMobility(r.spheres, exact)(r.load);
  Spheres s = r.spheres;
  s.cell.xy = s.cell.xprd;
  EXPECT_LT(relative_error(before, GridMobility(s, exact)(r.load)), 1e-7);
  s.cell.xy = 0.5 * s.cell.xprd;    // between two flips: against the sum over its waves
  EXPECT_LT(relative_error(spectral_motion(s, r.load), GridMobility(s, Settings())(r.load)), 8e-4);
}

// a point force in a cubic lattice: H. Hasimoto, J. Fluid Mech. 5, 317 (1959)
TEST(HydroMobility, DilutedArraySettlesAsHasimotoSays)
{
  const double edge = 12.0, phi = 4.0 / 3.0 * PI_ / (edge * edge * edge);
  Spheres s{cubic(edge), {{1.1, 2.3, 0.4}}, {1.0}};
  Numbers load(11, 0.0);
  load[0] = 6.0 * PI_;
  const double v = GridMobility(s, {1.0, 0.5, 8.0, 12})(load)[0];
  EXPECT_NEAR(v, 1.0 - 1.7601 * std::cbrt(phi) + phi, 2e-4);
}

struct Array {
  const char *name;
  std::vector<Vec3> basis;
};

const Array ARRAYS[] = {
    {"SC", {{0, 0, 0}}},
    {"BCC", {{0, 0, 0}, {.5, .5, .5}}},
    {"FCC", {{0, 0, 0}, {.5, .5, 0}, {.5, 0, .5}, {0, .5, .5}}},
};

Spheres array_of(const Array &array, double phi)
{
  const double edge = std::cbrt(static_cast<double>(array.basis.size()) * 4.0 / 3.0 * PI_ / phi);
  Spheres s{cubic(edge), {}, {}};
  for (const Vec3 &x : array.basis) {
    s.x.push_back(edge * x + Vec3{0.21, 0.33, 0.17});
    s.radius.push_back(1.0);
  }
  return s;
}

// loads of spheres that move like this
Numbers solved(const Spheres &s, const Numbers &motion, const Settings &settings)
{
  const GridMobility m(s, settings);
  Numbers load(motion.size());
  const auto result = LAMMPS_NS::Pore_NS::conjugate_gradients(
      [&](const Numbers &a, Numbers &b) {
        b = m(a);
      },
      [&](const Numbers &r, Numbers &z) {
        z = r;
        for (std::size_t n = 0; n < z.size(); n++) z[n] /= n % 11 < 3 ? 0.05 : 0.04;
      },
      [](double value) {
        return value;
      },
      motion, 1e-8, 200, load);
  EXPECT_LE(result.residual, 1e-8);
  return load;
}

// Drag of a simple cubic array that moves as a whole. Up to phi = 0.1 the exact one (J.P. Sangani,
// A. Acrivos, Int. J. Multiphase Flow 8, 343 (1982)); beyond, where forces, torques and stresslets
// are not enough, that of an independent program.
TEST(HydroMobility, DragOfASimpleCubicArray)
{
  struct {
    double phi, method, exact, error;
  } const known[] = {{0.001, 1.212205, 1.2121, 2e-4},
                     {0.027, 2.009051, 2.0077, 1e-3},
                     {0.064, 2.800593, 2.8101, 4e-3},
                     {0.125, 4.18047, 4.2894, 0.03},
                     {0.343, 11.74646, 15.4, 0.3}};
  for (const auto &k : known) {
    const Spheres s = array_of(ARRAYS[0], k.phi);
    Numbers motion(11, 0.0);
    motion[1] = 1.0;
    const double drag = solved(s, motion, {1.0, 0.5, 10.0, 12})[1] / (6.0 * PI_);
    EXPECT_NEAR(drag, k.method, 2e-6 * k.method) << k.phi;
    EXPECT_NEAR(drag, k.exact, k.error * k.exact) << k.phi;
  }
}

// Viscosity of free spheres in a straining flow along number n of the load: M of (F, T, S) is
// (v', w', -E) with F = T = 0.
double viscosity_of(const Spheres &s, int n)
{
  const GridMobility m(s, {1.0, 0.5, 10.0, 12});
  Numbers strain(11 * s.size()), load(strain.size());
  for (std::size_t i = 0; i < s.size(); i++) strain[11 * i + n] = -1.0;
  const auto free = [](const Numbers &a) {
    Numbers b = a;
    for (std::size_t i = 0; i < b.size(); i += 11) std::fill_n(&b[i], 6, 0.0);
    return b;
  };
  LAMMPS_NS::Pore_NS::conjugate_gradients(
      [&](const Numbers &a, Numbers &b) {
        b = free(m(free(a)));
      },
      [](const Numbers &r, Numbers &z) {
        z = r;
      },
      [](double value) {
        return value;
      },
      strain, 1e-8, 100, load);
  double stress = 0.0;
  for (std::size_t i = 0; i < s.size(); i++) stress -= load[11 * i + n];
  return 1.0 + stress / (s.cell.xprd * s.cell.yprd * s.cell.zprd) / 2.0;    // 2 eta E
}

// Without films: of an independent program, and the expansion of N. Zuzovsky, P.M. Adler,
// H. Brenner, Phys. Fluids 26, 1714 (1983).
TEST(HydroMobility, ViscosityOfArrays)
{
  struct {
    int array;
    double phi, shear, stretch, exact_shear, exact_stretch;
  } const known[] = {{0, 0.05, 1.12173, 1.149757, 1.12164, 1.14995},
                     {0, 0.1, 1.241567, 1.35836, 1.24109, 1.35994},
                     {0, 0.3, 1.787527, 3.238656, 0.0, 0.0},
                     {1, 0.05, 1.134932, 1.126855, 1.13496, 1.12682},
                     {2, 0.1, 1.290263, 1.260948, 1.29037, 1.26081}};
  for (const auto &k : known) {
    const Spheres s = array_of(ARRAYS[k.array], k.phi);
    const double shear = viscosity_of(s, 8), stretch = viscosity_of(s, 6);
    EXPECT_NEAR(shear, k.shear, 1e-5 * k.shear) << ARRAYS[k.array].name;
    EXPECT_NEAR(stretch, k.stretch, 1e-5 * k.stretch) << ARRAYS[k.array].name;
    if (k.exact_shear == 0.0) continue;
    EXPECT_NEAR(shear, k.exact_shear, 0.005 * k.exact_shear);
    EXPECT_NEAR(stretch, k.exact_stretch, 0.005 * k.exact_stretch);
  }
}

TEST(HydroMobility, ViscosityOfRandomSpheres)
{
  const Spheres s = reference(1).spheres;
  const double known[] = {2.194658, 2.185526, 2.166308, 2.099732, 2.16438};
  for (int n = 0; n < 5; n++) EXPECT_NEAR(viscosity_of(s, 6 + n), known[n], 1e-5 * known[n]) << n;
}

TEST(HydroMobility, ViscosityOfTheFluidAndUnitsOfLength)
{
  const Reference r = reference(2);
  const Numbers before = GridMobility(r.spheres, Settings())(r.load);
  const double eta = 3.0, unit = 0.5;
  Spheres s = r.spheres;
  Cell &c = s.cell;
  for (double *length : {&c.xprd, &c.yprd, &c.zprd, &c.xy, &c.xz, &c.yz}) *length *= unit;
  for (double &a : s.radius) a *= unit;
  for (Vec3 &x : s.x) x = unit * x;
  Numbers load = r.load, expected = before;
  for (std::size_t n = 0; n < load.size(); n++) {
    if (n % 11 < 3)
      expected[n] /= eta * unit;    // velocities
    else {
      load[n] *= unit;    // torques for the same forces
      expected[n] /= eta * unit * unit;
    }
  }
  Settings settings;
  settings.width = unit;
  EXPECT_LT(relative_error(expected, GridMobility(s, settings, eta)(load)), 1e-13);
}

}    // namespace

#endif
