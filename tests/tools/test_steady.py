"""tools/steady.py against synthetic signals whose answer is known in closed form.

Coverage: the share of many replicas whose interval holds the truth; a fixed seed makes it repeatable.
"""
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

import steady
from steady import Estimate, NotSteady, TooShort

HEADER = "# Time-averaged data for fix mean\n# TimeStep v_a f_b[2]\n"


def first_order(rng, replicas, samples, relaxation):
    """Gauss-Markov signals, AR(1), of variance 1 around 0: one row for each replica."""
    a = np.exp(-1 / relaxation)
    noise = rng.standard_normal((samples, replicas))
    values = np.empty_like(noise)
    values[0] = noise[0]
    for n in range(1, samples):
        values[n] = a * values[n - 1] + np.sqrt(1 - a * a) * noise[n]
    return values.T


def coverage(estimates, truth):
    """Shares of the estimates within one error and within the 95 % interval of the truth."""
    off = [abs(e.mean - truth) for e in estimates]
    return (np.mean([d <= e.error for d, e in zip(off, estimates)]),
            np.mean([d <= steady.interval(e) for d, e in zip(off, estimates)]))


class Case(unittest.TestCase):
    def setUp(self):
        self.rng = np.random.default_rng(20)

    def expect_coverage(self, estimates, truth, slack=0.05):
        within, wide = coverage(estimates, truth)
        self.assertTrue(abs(within - 0.683) < slack, f"{within:.3f} within one error")
        self.assertTrue(abs(wide - 0.95) < 0.6 * slack, f"{wide:.3f} within the 95 % interval")


class MeanError(Case):
    def test_white_noise(self):
        signals = 3 + 2 * self.rng.standard_normal((1000, 200))
        estimates = [steady.mean_error(s) for s in signals]
        self.expect_coverage(estimates, 3)
        self.assertAlmostEqual(np.mean([e.error for e in estimates]), 2 / np.sqrt(200), delta=0.01)
        self.assertAlmostEqual(np.mean([e.independent for e in estimates]), 200, delta=20)

    def test_correlated_noise_of_20_relaxation_times(self):
        estimates = []
        for signal in 5 + first_order(self.rng, 1000, 200, 10):
            try:
                estimates.append(steady.mean_error(signal))
            except TooShort:
                pass
        self.assertGreater(len(estimates), 950)
        self.expect_coverage(estimates, 5)

    def test_correlation_length_of_a_long_signal(self):
        signal = first_order(self.rng, 1, 200000, 10)[0]
        a = np.exp(-0.1)
        found = steady.mean_error(signal)
        self.assertAlmostEqual(found.correlation / ((1 + a) / (1 - a)), 1, delta=0.08)
        self.assertAlmostEqual(found.error * np.sqrt(200000 * (1 - a) / (1 + a)), 1, delta=0.05)
        self.assertEqual(found.samples, 200000)

    def test_values_known_as_independent(self):
        found = steady.mean_error([1.0, 2.0, 3.0], correlated=False)
        self.assertAlmostEqual(found.mean, 2)
        self.assertAlmostEqual(found.error, 1.3213 / np.sqrt(3), delta=0.01)    # t of 2 degrees at 0.6827
        self.assertAlmostEqual(steady.interval(found), 4.3027 / np.sqrt(3), delta=0.02)

    def test_student_factors(self):
        for dof, one, wide in ((2, 1.3213, 4.3027), (5, 1.1105, 2.5706), (10, 1.0527, 2.2281), (1e9, 1.0, 1.9600)):
            self.assertAlmostEqual(steady.student(0.6827, dof), one, delta=0.005)
            self.assertAlmostEqual(steady.student(0.95, dof) / wide, 1, delta=0.01)

    def test_constant_signal_has_no_error(self):
        for value in (0.0, 0.1, -1e20):
            found = steady.mean_error(np.full(100, value))
            self.assertAlmostEqual(found.mean, value, delta=1e-12 * abs(value))
            self.assertEqual((found.error, found.independent), (0.0, 100))

    def test_too_short(self):
        for signal in ([], [1.0], np.arange(19) % 3, np.sin(np.arange(100) / 60)):
            with self.assertRaises(TooShort):
                steady.mean_error(signal)

    def test_refuses_what_is_not_a_signal(self):
        for signal in ([1.0, np.nan] * 20, np.ones((5, 20))):
            with self.assertRaises(ValueError):
                steady.mean_error(signal)


class SteadyStart(Case):
    time = np.arange(1000)

    def starts(self, transient, relaxation=8, replicas=300):
        """(start, signal) of noise around 0 with transient, and how many had no steady part."""
        found, refused = [], 0
        for signal in first_order(self.rng, replicas, 1000, relaxation) + transient:
            try:
                found.append((steady.steady_start(signal), signal))
            except NotSteady:
                refused += 1
        return found, refused / replicas

    def test_exponential_transient_is_left_out(self):
        for height in (8, -8):
            found, refused = self.starts(height * np.exp(-self.time / 60))
            self.assertLess(refused, 0.15)
            start = np.median([s for s, _ in found])
            self.assertTrue(2 * 60 < start < 5 * 60, f"start {start}")
            self.expect_coverage([steady.mean_error(x[s:]) for s, x in found], 0, slack=0.06)

    def test_nearly_all_is_kept_without_transient(self):
        found, refused = self.starts(0.0)
        self.assertLess(refused, 0.08)
        self.assertEqual(np.median([s for s, _ in found]), 0)
        self.assertLess(np.percentile([s for s, _ in found], 90), 250)

    def test_drift_is_refused(self):
        for transient in (4 * self.time / 1000, -4 * self.time / 1000, 10 * np.exp(-self.time / 300)):
            self.assertGreater(self.starts(transient)[1], 0.95)
        self.assertGreater(self.starts(2.5 * self.time / 1000)[1], 0.85)

    def test_slow_fluctuations_are_no_transient(self):
        refused, starts = 0, []    # a dozen correlation lengths each
        for signal in first_order(self.rng, 400, 500, 20):
            try:
                starts.append(steady.steady_start(signal))
            except NotSteady:
                refused += 1
        self.assertLess(refused / 400, 0.13)
        self.assertLessEqual(max(starts), 250)

    def test_trend_left_after_the_start(self):
        self.assertTrue(steady.has_trend(np.arange(100.0)))
        self.assertFalse(steady.has_trend(np.ones(100)))
        noise = self.rng.standard_normal((500, 100))
        self.assertAlmostEqual(np.mean([steady.has_trend(x) for x in noise]), 0.05, delta=0.03)
        drifting = noise + 1.2 * np.arange(100) / 100    # slope of 3.5 standard errors
        self.assertGreater(np.mean([steady.has_trend(x) for x in drifting]), 0.85)

    def test_latest_start_of_several_signals(self):
        a, b = first_order(self.rng, 2, 1000, 3)
        quick, slow = a + 10 * np.exp(-self.time / 10), b - 10 * np.exp(-self.time / 60)
        start = steady.steady_start(slow)
        self.assertGreater(start, steady.steady_start(quick))
        self.assertEqual(steady.steady_start(quick, slow), start)
        with self.assertRaises(ValueError):
            steady.steady_start(quick, slow[1:])

    def test_false_alarms_of_several_signals_together(self):
        signals = first_order(self.rng, 1200, 1000, 8).reshape(150, 8, 1000)
        refused = 0
        for group in signals:
            try:
                steady.steady_start(*group)
            except NotSteady:
                refused += 1
        self.assertLess(refused / 150, 0.12)

    def test_constant_and_short_signals(self):
        self.assertEqual(steady.steady_start(np.full(60, 0.1)), 0)
        with self.assertRaises(TooShort):
            steady.steady_start(np.ones(49))


class Ratios(Case):
    time = np.arange(2000)
    rate = 0.3 + np.cos(2 * np.pi * time / 40)    # changes sign in every cycle

    def test_weighted_mean_in_closed_form(self):
        rate = 0.3 + np.cos(2 * np.pi * np.arange(40000) / 4000)
        mean_rate = 2 / np.pi * (0.3 * np.arcsin(0.3) + np.sqrt(1 - 0.3**2))    # of |rate|
        expected = 2 + 5 * (0.3**2 + 0.5) / mean_rate
        found = steady.weighted_mean(2 + 5 * np.abs(rate), rate, period=4000)
        self.assertAlmostEqual(found.mean / expected, 1, delta=1e-6)
        self.assertLess(found.error, 1e-9)
        self.assertEqual(found.samples, 10)
        self.assertAlmostEqual(steady.weighted_mean(2 + 5 * np.abs(rate), -rate, period=4000).mean, found.mean)

    def test_incomplete_cycle_is_left_out(self):
        rate = np.cos(2 * np.pi * (np.arange(90) + 0.5) / 40)
        values = np.concatenate([np.full(10, 100.0), np.ones(80)])
        self.assertAlmostEqual(steady.weighted_mean(values, rate, period=40).mean, 1)

    def test_friction_of_a_coulomb_material(self):
        pressure = 1 + 0.2 * np.sin(2 * np.pi * self.time / 40)
        found = steady.friction(self.rate, 0.4 * pressure * np.sign(self.rate), pressure, period=40)
        self.assertAlmostEqual(found.mean, 0.4)
        self.assertLess(found.error, 1e-9)

    def test_coverage_of_correlated_ratios(self):
        noise = first_order(self.rng, 1200, 2000, 12).reshape(600, 2, 2000)
        for period in (40, None):
            found = [steady.friction(self.rate, 0.4 * np.sign(self.rate) + 0.1 * a, 1 + 0.2 * b, period)
                     for a, b in noise]
            self.expect_coverage(found, 0.4)
            self.expect_coverage([steady.weighted_mean(2 + a, self.rate, period) for a, _ in noise], 2)

    def test_error_of_a_ratio_counts_what_cancels(self):
        common = 1 + 0.2 * self.rng.standard_normal(2000)
        self.assertAlmostEqual(steady.ratio(3 * common, common).mean, 3)
        self.assertLess(steady.ratio(3 * common, common).error, 1e-9)

    def test_too_short(self):
        with self.assertRaises(TooShort):
            steady.ratio(np.ones(79), np.ones(79), period=40)


class Oscillation(Case):
    omega, g0, g1, shift = 2.5, 0.4, 3.0, 0.7
    eta, lag = 2.0, 0.3    # of a Maxwell fluid, stress + lag d(stress)/dt = eta rate

    def maxwell(self, time, g0=None):
        """Rate and periodic stress."""
        g0 = self.g0 if g0 is None else g0
        wl, angle = self.omega * self.lag, self.omega * time + self.shift
        stress = self.eta * (g0 + self.g1 * (np.cos(angle) + wl * np.sin(angle)) / (1 + wl**2))
        return g0 + self.g1 * np.cos(angle), stress

    def expect_maxwell(self, found, delta=1e-9):
        wl = self.omega * self.lag
        self.assertAlmostEqual(found["real"].mean, self.eta / (1 + wl**2), delta=delta)
        self.assertAlmostEqual(found["imag"].mean, self.eta * wl / (1 + wl**2), delta=delta)
        self.assertAlmostEqual(found["modulus"].mean, self.eta / np.sqrt(1 + wl**2), delta=delta)
        self.assertAlmostEqual(found["phase"].mean, np.arctan(wl), delta=delta)
        self.assertAlmostEqual(found["third"].mean, 0, delta=delta)

    def test_maxwell_fluid(self):
        time = 0.0731 * np.arange(500) + 11.3    # 34.4 samples in a cycle, 14.5 cycles
        found = steady.complex_viscosity(time, *self.maxwell(time), self.omega)
        self.expect_maxwell(found)
        self.assertEqual(found["real"].samples, 14)
        self.assertLess(max(e.error for e in found.values()), 1e-9)

    def test_window_averages_of_the_fluid(self):
        fine = 0.001 * np.arange(40000)
        time = fine.reshape(-1, 200)[:, -1]    # of the last value, as fix ave/time writes
        rate, stress = (x.reshape(-1, 200).mean(axis=1) for x in self.maxwell(fine))
        self.expect_maxwell(steady.complex_viscosity(time, rate, stress, self.omega))

    def test_equals_the_integrals_of_dong(self):
        time = 2 * np.pi / self.omega * (np.arange(4000) + 0.5) / 1000    # four cycles
        rate = self.g1 * np.cos(self.omega * time)
        stress = np.tanh(rate) + 0.8 * np.sin(self.omega * time) ** 3    # nonlinear
        cos, sin = np.cos(self.omega * time), np.sin(self.omega * time)
        found = steady.complex_viscosity(time, rate, stress, self.omega)
        self.assertAlmostEqual(found["real"].mean, np.sum(stress * cos) / (self.g1 * np.sum(cos**2)))    # eq. 4.13
        self.assertAlmostEqual(found["imag"].mean, np.sum(stress * sin) / (self.g1 * np.sum(sin**2)))    # eq. 4.14
        pressure = 2 + 0.5 * np.cos(2 * self.omega * time)
        strain = self.g1 / self.omega * sin
        found = steady.complex_friction(time, rate, stress, pressure, self.omega)
        viscous = np.sum(stress / pressure * rate) / np.sum(np.abs(rate))    # eq. 4.15
        elastic = np.sum(stress / pressure * strain) / np.sum(np.abs(strain))    # eq. 4.16
        self.assertAlmostEqual(found["real"].mean, viscous, delta=1e-5)
        self.assertAlmostEqual(found["imag"].mean, elastic, delta=1e-5)
        weighted = steady.weighted_mean(np.sign(strain) * stress / pressure, strain, period=1000)
        self.assertAlmostEqual(weighted.mean, elastic)

    def test_third_harmonic(self):
        time = 0.05 * np.arange(1000)
        rate, stress = self.maxwell(time)
        stress = stress + 0.25 * np.cos(3 * self.omega * time + 1)
        found = steady.complex_viscosity(time, rate, stress, self.omega)
        self.assertAlmostEqual(found["third"].mean, 0.25 / (self.g1 * found["modulus"].mean))

    def test_cycles_of_different_phase(self):
        angle = 2 * np.pi * (np.arange(400) + 0.5) / 40 + np.repeat(self.rng.uniform(0, 6, 10), 40)
        stress = 2 * np.cos(angle - 0.5) + 0.3 * np.cos(3 * angle + 1)
        found = steady.complex_viscosity(np.arange(400), np.cos(angle), stress, 2 * np.pi / 40)
        for name, value in (("modulus", 2), ("phase", 0.5), ("third", 0.15)):
            self.assertAlmostEqual(found[name].mean, value)
            self.assertLess(found[name].error, 1e-9)

    def test_coverage_under_noise(self):
        time = 2 * np.pi / self.omega * np.arange(800) / 40
        rate, stress = self.maxwell(time)
        wl = self.omega * self.lag
        found = [steady.complex_viscosity(time, rate, stress + x, self.omega)
                 for x in first_order(self.rng, 300, 800, 5)]
        for name, truth in (("real", 1 / (1 + wl**2)), ("imag", wl / (1 + wl**2)), ("modulus", (1 + wl**2) ** -0.5)):
            self.expect_coverage([f[name] for f in found], self.eta * truth, slack=0.08)
        self.expect_coverage([f["phase"] for f in found], np.arctan(wl), slack=0.08)

    def test_refusals(self):
        time = 0.1 * np.arange(200)
        rate, stress = self.maxwell(time)
        for omega in (0.5, 10.0):    # 1.6 cycles; 6.3 samples in a cycle
            with self.assertRaisesRegex(TooShort, "cycles of"):
                steady.complex_viscosity(time, rate, stress, omega)
        with self.assertRaises(ValueError):
            steady.complex_friction(time, rate, stress, np.cos(time), self.omega)


class Combine(Case):
    def test_two_runs_by_hand(self):
        runs = [Estimate(1.0, 0.3, 1, 1e6, 1000000, 1e6), Estimate(2.0, 0.4, 1, 3e6, 3000000, 1e6)]
        found = steady.combine(runs)
        self.assertAlmostEqual(found.mean, 0.25 * 1 + 0.75 * 2)
        self.assertAlmostEqual(found.chi2, 1 / (0.3**2 + 0.4**2))    # 4
        self.assertAlmostEqual(found.probability, 0.0455, delta=0.003)    # P(|normal| > 2)
        self.assertAlmostEqual(found.error, 2 * np.hypot(0.25 * 0.3, 0.75 * 0.4), delta=1e-5)    # grown by sqrt(chi2)
        close = steady.combine([runs[0], runs[1]._replace(mean=1.6)])
        self.assertAlmostEqual(close.chi2, 1.44)
        self.assertAlmostEqual(close.error, np.hypot(0.25 * 0.3, 0.75 * 0.4), delta=1e-5)
        by_error = steady.combine(runs, weights=[1 / 0.3**2, 1 / 0.4**2])
        self.assertAlmostEqual(by_error.mean, (1 / 0.09 + 2 / 0.16) / (1 / 0.09 + 1 / 0.16))

    def test_coverage(self):
        found = []
        for group in first_order(self.rng, 900, 500, 10).reshape(300, 3, 500):
            found.append(steady.combine([steady.mean_error(x) for x in group]))
        within = np.mean([abs(c.mean) < c.error for c in found])
        self.assertAlmostEqual(within, 0.70, delta=0.06)
        self.assertLess(np.mean([c.probability < 0.05 for c in found]), 0.10)

    def test_inconsistent_runs_show(self):
        runs = [Estimate(m, 0.1, 1, 500, 500, 100) for m in (1.0, 1.5, 2.0)]
        self.assertLess(steady.combine(runs).probability, 1e-6)
        self.assertGreater(steady.combine(runs).error, 0.25)

    def test_refusals(self):
        for runs in ([Estimate(1, 1, 1, 1, 1, 1)], [Estimate(1, 0.0, 1, 9, 9, 9)] * 2):
            with self.assertRaises(ValueError):
                steady.combine(runs)


class Files(Case):
    def setUp(self):
        super().setUp()
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.file = Path(folder.name) / "stress.txt"

    def read(self, text):
        self.file.write_text(text, encoding="ascii")
        return steady.read_ave_time(self.file)

    def test_columns(self):
        data = self.read(HEADER + "0 1.5 -2\n100 2.5 3e-4\n")
        self.assertEqual(list(data), ["TimeStep", "v_a", "f_b[2]"])
        np.testing.assert_array_equal(data["f_b[2]"], [-2, 3e-4])

    def test_last_line_of_a_running_job(self):
        for tail in ("200 3.", "200 3.5 4", "200 3.5 4e", "2"):
            np.testing.assert_array_equal(self.read(HEADER + "0 1 2\n100 3 4\n" + tail)["TimeStep"], [0, 100])

    def test_later_run_wins(self):
        for end in ("", "300 4"):    # a killed run leaves half a line, to which the next header is appended
            data = self.read(HEADER + "0 1 1\n100 2 2\n200 3 3\n" + end + HEADER + "100 5 5\n200 6 6\n")
            np.testing.assert_array_equal(data["TimeStep"], [0, 100, 200])
            np.testing.assert_array_equal(data["v_a"], [1, 5, 6])

    def test_what_is_no_continuation_is_refused(self):
        first = HEADER + "100 1 1\n200 2 2\n300 3 3\n"
        self.assertEqual(len(self.read(first + HEADER + "500 5 5\n600 6 6\n")["TimeStep"]), 5)    # a window was cut
        for appended in ("600 6 6\n700 7 7\n", "350 3 3\n400 4 4\n", "400 4 4\n550 5 5\n", "290 2 2\n380 3 3\n"):
            with self.assertRaisesRegex(ValueError, "not one run and its continuation"):
                self.read(first + HEADER + appended)

    def test_refusals_say_why(self):
        for text, why in ((HEADER, "no complete line"), ("", "no complete line"), (HEADER + "0 1 x\n", "line 3"),
                          ("0 1 2\n", "line 1"), (HEADER + "0 1 2\n# TimeStep v_a\n", "columns change"),
                          ("# TimeStep Number-of-rows\n# Row c_x\n0 1\n1 2\n", "mode scalar")):
            with self.assertRaisesRegex(ValueError, why):
                self.read(text)

    def command(self, *args):
        done = subprocess.run([sys.executable, steady.__file__, str(self.file), *args], stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, check=False)
        return done.returncode, done.stdout

    def test_command(self):
        steps = np.arange(400)
        transient = 20 * np.exp(-steps / 10)
        columns = [steps, 0.01 * steps, 7 + transient + self.rng.standard_normal(400), steps**2.0]
        self.file.write_text("# TimeStep v_strain v_eta v_fast\n" + "\n".join(
            " ".join(f"{x:.6g}" for x in row) for row in zip(*columns)) + "\n", encoding="ascii")
        code, text = self.command("--over", "v_strain", "--json")
        self.assertEqual(code, 0, text)
        row, = json.loads(text)    # columns that only grow are left out
        self.assertEqual((row["name"], row["remark"]), ("v_eta", ""))
        self.assertLess(abs(row["mean"] - 7), 4 * row["error"])
        self.assertTrue(0.3 < row["from"] < 1.5, row)
        self.assertAlmostEqual(row["correlation"], 0.01, delta=0.004)
        code, text = self.command("--over", "v_strain", "--from", "2.005", "--json")
        self.assertEqual((json.loads(text)[0]["from"], json.loads(text)[0]["samples"]), (2.01, 199))
        code, text = self.command("--columns", "v_eta", "v_fast")
        self.assertEqual(code, 1)
        self.assertRegex(text, r"(?m)^v_eta +[67]\.\d+ ")
        self.assertRegex(text, r"(?m)^v_fast +the transient fills")
        code, text = self.command("--columns", "v_eat")
        self.assertEqual(code, 2)
        self.assertIn("no column v_eat", text)


if __name__ == "__main__":
    unittest.main()
