# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The filters that the parts of benchmark pf compare."""
import dataclasses

from slam_eval.bench.harness.table import verdict

FEW_SHARE = 1.1


@dataclasses.dataclass(frozen=True)
class Variant:
    """A filter that is measured: product and settings of its own."""

    name: str
    product: str
    settings: tuple
    random: bool = True

    def run_name(self, prefix):
        """Name of a run for files."""
        return f"{prefix}_{self.name.replace(', ', '_').replace(' ', '_')}"


EKF = Variant("ekf", "ekf_wheel", (), random=False)
OTHER_EKFS = tuple(Variant(f"ekf, {name}", "ekf_wheel", (f"ekf.linearization={name}",),
                           random=False) for name in ("textbook", "first_estimates"))
DEFAULT = Variant("pf, 100 particles", "pf_wheel", ("pf.particles=100",))
FEW = Variant("fastslam2, 30 particles", "pf_wheel",
              ("pf.particles=30", "pf.proposal=fastslam2"))
MANY = Variant("fastslam1, 200 particles", "pf_wheel",
               ("pf.particles=200", "pf.proposal=fastslam1"))


def few_verdict(few, many):
    """A line on the mean ATE of FEW [m] beside that of MANY."""
    share = few / many
    return (f"- mean ATE, {FEW.name} over {MANY.name} {share:.3f} "
            f"({verdict(share, FEW_SHARE, True)})")
