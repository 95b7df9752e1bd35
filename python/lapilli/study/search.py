"""The search for a setting: a ladder of runs, other settings beside it, what they tell."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field, replace

from lapilli._core import Scene
from lapilli.study.finer import TIGHTEST
from lapilli.study.fitting import with_cell
from lapilli.study.ladder import UNCERTAIN, Climb, Grade, Judge, Ladder, Rung
from lapilli.study.runner import Runner
from lapilli.study.settings import Setting
from lapilli.study.variants import variants_of

Tell = Callable[[str], None]

COARSEST = 4  # cells of the first rung over those of the scene
MOST_RUNGS = 9
SAFE = 0.9  # a setting must reach this part of the target to be chosen
LOOSEST = 1e-2  # tolerance of steps in time
BEYOND = 2  # halvings that may be extrapolated


@dataclass(frozen=True)
class Suggestion:
    """What was found. Without a grade, `reason` says why nothing can be suggested."""

    target: float
    judge: Judge
    grade: Grade | None
    reason: str
    cpu_seconds: float  # of the suggested setting: measured, or predicted where it was not run
    wall_seconds: float
    memory: float  # bytes
    was_run: bool
    spent: float  # CPU s, all runs together
    ladder: Ladder
    tried: list[Grade] = field(default_factory=list)  # variants

    @property
    def setting(self) -> Setting:
        """The setting that is suggested."""
        if self.grade is None:
            raise ValueError(self.reason)
        return self.grade.rung.setting


@dataclass
class Search:
    """The runs of one suggestion."""

    scene: Scene
    judge: Judge
    target: float
    budget: float
    threads: int
    runner: Runner
    tell: Tell
    spent: float = 0.0

    def run(self) -> Suggestion:
        """Climb the ladder, try variants, say what was found."""
        ladder = self.climb()
        base = self.reached(ladder)
        if base is not None:
            tried = self.try_variants(ladder, base)
            good = [one for one in tried if one.error <= SAFE * self.target]
            best = min([base, *good], key=lambda one: one.rung.effort)
            return self.found(best, ladder, tried)
        if ladder.falls_as_it_should():
            return self.extrapolated(ladder)
        return self.cannot_tell(ladder)

    def reached(self, ladder: Ladder) -> Grade | None:
        """The coarsest rung from which on all reach the target; two graded rungs whose errors do
        not grow must confirm it."""
        graded = ladder.graded()
        good = [one.error <= SAFE * self.target for one in graded]
        if len(graded) < 2 or not good[-1]:
            return None
        if graded[-1].error > graded[-2].error and not good[-2]:
            return None
        first = len(good) - next((k for k, one in enumerate(reversed(good)) if not one), len(good))
        return graded[first]

    def climb(self) -> Ladder:
        """Run finer until rungs that the finest judges reach the target, or the budget ends."""
        ladder = Ladder(self.judge)
        failures: list[str] = []
        level = -int(math.log2(COARSEST))
        while len(ladder.rungs) < MOST_RUNGS and level < MOST_RUNGS:
            rungs = ladder.rungs
            if rungs:
                next_cost = rungs[-1].effort * ladder.growth("effort")
                if self.spent + next_cost > self.budget:
                    break
            work = self.work(self.rung_setting(level))
            level += 1
            if rungs and work.cell > 0.8 * rungs[-1].cell:
                continue  # the grid allows no cell between
            (rung,) = self.do([work])
            if rung.seen is None:
                failures.append(rung.reason)
                if level > 1:
                    break
                rungs.clear()  # too coarse for the scene, and so were those before
                continue
            rungs.append(rung)
            if self.reached(ladder) is not None:
                break
        if not ladder.rungs:
            raise ValueError("no run worked: " + "; ".join(dict.fromkeys(failures)))
        return ladder

    def rung_setting(self, level: int) -> Setting:
        """The scene's own setting at level 0, twice as fine at each further one."""
        cell = self.scene.grid.cell / 2.0**level
        changed = with_cell(self.scene, cell)
        changes = [("grid.cell", repr(changed.grid.cell))]
        if list(changed.grid.upper) != list(self.scene.grid.upper):
            changes.append(("grid.upper", str(list(changed.grid.upper))))
        steps, step = self.scene.time.steps, self.scene.time.step
        if isinstance(steps, int):
            changes.append(("time.steps", str(max(1, round(steps * 2.0**level)))))
        elif isinstance(step, float | int):
            changes.append(("time.step", repr(step / 2.0**level)))
        elif self.scene.heat is not None and self.scene.heat.time_integration == "auto":
            # errors in time fall with those in space, or a floor would look like a small error
            tolerance = min(self.scene.heat.tolerance / 4.0**level, LOOSEST)
            changes.append(("heat.tolerance", f"{max(tolerance, TIGHTEST):.3g}"))
        return Setting(tuple(changes))

    def work(self, setting: Setting) -> Climb:
        """The run of a setting."""
        applied = setting.applied(self.scene)
        cell = self.scene.grid.cell if applied is None else applied.grid.cell
        fields = (self.judge.name,) if self.judge.is_field else ()
        return Climb(self.scene, setting, cell, fields, self.judge.times, self.threads)

    def do(self, works: list[Climb]) -> list[Rung]:
        """Run, and count what it took."""
        rungs = list(self.runner.run(works))
        for rung in rungs:
            if rung.seen is None:
                self.tell(f"{rung.setting}: {rung.reason}")
            else:
                self.spent += rung.effort
                self.tell(f"{rung.setting}: {rung.effort:.3g} CPU s")
        return rungs

    def try_variants(self, ladder: Ladder, base: Grade) -> list[Grade]:
        """Other settings at the cell that reached the target and at twice the cell, as many as the
        budget allows if each takes what that of the scene took."""
        coarser = [one for one in ladder.rungs if one.cell > 1.5 * base.rung.cell]
        works: list[Climb] = []
        planned = self.spent
        for rung in [base.rung, *coarser[-1:]]:
            for variant in variants_of(self.scene):
                planned += rung.effort
                if planned <= self.budget:
                    works.append(self.work(merged(rung.setting, variant)))
        return [ladder.grade_other(one) for one in self.do(works) if one.seen is not None]

    def found(self, best: Grade, ladder: Ladder, tried: list[Grade]) -> Suggestion:
        """A setting that was run; once more, to see what its output takes."""
        (again,) = self.do([replace(self.work(best.rung.setting), output_cost=True)])
        cost = best.rung.cost if again.seen is None else again.cost
        return Suggestion(
            self.target,
            self.judge,
            best,
            "",
            cost.total_cpu_seconds,
            cost.total_wall_seconds,
            cost.peak_memory,
            True,
            self.spent,
            ladder,
            tried,
        )

    def extrapolated(self, ladder: Ladder) -> Suggestion:
        """The cell that the design order asks for, at most two halvings beyond the finest run."""
        error, finest = ladder.finest_error(), ladder.rungs[-1]
        level = 0
        while error > SAFE * self.target / UNCERTAIN**0.5 and level < BEYOND:
            error, level = error / 4, level + 1
        if error > SAFE * self.target:
            return self.cannot_tell(ladder)
        own = round(math.log2(self.scene.grid.cell / finest.cell))
        setting = finest.setting if level == 0 else self.rung_setting(own + level)
        rung = Rung(setting, finest.cell / 2**level, finest.seen if level == 0 else None)
        how = "extrapolated with order 2 from differences that fall with it"
        grade = Grade(rung, error, error / UNCERTAIN, error * UNCERTAIN, how)
        cpu, wall, memory = (
            float(getattr(finest.cost, what)) * ladder.growth(what) ** level
            for what in ("total_cpu_seconds", "total_wall_seconds", "peak_memory")
        )
        return Suggestion(
            self.target, self.judge, grade, "", cpu, wall, memory, level == 0, self.spent, ladder
        )

    def cannot_tell(self, ladder: Ladder) -> Suggestion:
        """Nothing can be suggested: what was reached, and why it is not enough."""
        graded = ladder.graded()
        finest = ladder.rungs[-1]
        said = f"cannot tell within {self.budget:g} CPU s: "
        if graded:
            best = min(graded, key=lambda one: one.error)
            orders = ", ".join(f"{one:.2g}" for one in ladder.orders()) or "too few runs"
            said += (
                f"the best graded setting, {best.rung.setting}, errs by {best.error:.3g}; "
                f"orders of the differences are {orders} (2 is the design order); the finest "
                f"run was {finest.setting} at {finest.cost.total_cpu_seconds:.3g} CPU s"
            )
        else:
            said += f"only {finest.setting} was run"
        return Suggestion(
            self.target, self.judge, None, said, math.nan, math.nan, math.nan, False, self.spent,
            ladder,
        )  # fmt: skip


def merged(setting: Setting, variant: Setting) -> Setting:
    """A setting with the changes of a variant in place of its own."""
    paths = {path for path, _ in variant.changes}
    if "time.steps" in paths:
        paths.add("time.step")
    kept = [one for one in setting.changes if one[0] not in paths]
    return Setting((*kept, *variant.changes))
