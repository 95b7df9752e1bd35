"""Commands: lapilli run, check, plot, merge, verify, keys, schema, examples, reproduce, tradeoff,
extremes."""

from __future__ import annotations

import argparse
import signal
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import NoReturn

from lapilli import _core
from lapilli._core import OutputError, RunError, Scene
from lapilli.mistakes import is_disk_failure, is_utf8
from lapilli.signals import Signalled, stopped_by_signals
from lapilli.words import meant

FINISHED, RUN_FAILED, WRONG_INPUT, DISK_FAILED, BAR_MISSED, SIGNALLED = 0, 1, 2, 3, 4, 128


def main(words: Sequence[str] | None = None) -> int:
    """Run one command; mistakes become one line on standard error and an exit code."""
    words = list(sys.argv[1:] if words is None else words)
    top = parser()
    require_known_command(top, words)
    given = top.parse_args(words)
    for text in vars(given).values():
        if isinstance(text, str) and not is_utf8(text):
            return report(ValueError(f"{text!a} is a name that is no UTF-8"), WRONG_INPUT)
    try:
        with stopped_by_signals():
            code: int = given.command(given)
        sys.stdout.flush()
        return code
    except KeyboardInterrupt as error:
        print("\nlapilli: stopped", file=sys.stderr)
        return SIGNALLED + (error.number if isinstance(error, Signalled) else signal.SIGINT)
    except BrokenPipeError:
        sys.stderr.close()
        return FINISHED
    except OutputError as error:
        return report(error, DISK_FAILED)
    except RunError as error:
        return report(error, RUN_FAILED)
    except MemoryError as error:
        return report(error, RUN_FAILED)
    except (ValueError, OSError) as error:
        return report(error, DISK_FAILED if is_disk_failure(error) else WRONG_INPUT)


def require_known_command(top: Parser, words: Sequence[str]) -> None:
    """Name the command that a misspelt one was meant for."""
    known = command_names(top)
    if words and not words[0].startswith("-") and words[0] not in known:
        top.error(f"unknown command '{words[0]}'; {meant(words[0], known)}")


def command_names(top: Parser) -> list[str]:
    """The commands of a parser."""
    actions = [a for a in top._actions if isinstance(a, argparse._SubParsersAction)]
    return [name for action in actions for name in action.choices]


def report(error: Exception, code: int) -> int:
    """Say what went wrong."""
    print(f"lapilli: {error}", file=sys.stderr)
    return code


class Parser(argparse.ArgumentParser):
    """Says what is wrong and how to ask for help, in two lines."""

    def error(self, message: str) -> NoReturn:
        self.exit(WRONG_INPUT, f"{self.prog}: {message}\n(see {self.prog} --help)\n")


def parser() -> Parser:
    """Commands and their options."""
    top = Parser(prog="lapilli", description=_summary())
    top.add_argument("--version", action="version", version=f"lapilli {_core.__version__}")
    commands = top.add_subparsers(required=True, metavar="COMMAND", parser_class=Parser)

    run = commands.add_parser("run", help="run a scene")
    _scene_arguments(run)
    run.add_argument("--output", metavar="FILE", help="frames for ParaView (.vtkhdf)")
    run.add_argument("--every", type=float, metavar="S", help="time between frames, s")
    run.add_argument("--threads", type=_count, metavar="N", help="all processors unless given")
    run.add_argument("--resume", action="store_true", help="go on from the checkpoint")
    run.add_argument("--quiet", action="store_true", help="show no progress")
    run.set_defaults(command=run_command)

    check = commands.add_parser("check", help="say what a scene models and costs")
    _scene_arguments(check)
    check.add_argument("--json", action="store_true", help="as JSON")
    check.set_defaults(command=check_command)

    plot = commands.add_parser("plot", help="a picture or an animation of a run")
    plot.add_argument("frames", help="frames (.vtkhdf)")
    plot.add_argument("--field", help="temperature unless given")
    plot.add_argument("--time", type=float, metavar="S", help="the last frame unless given")
    plot.add_argument("--save", metavar="FILE", help=".png, .pdf, .svg; .gif and .mp4 are animated")
    plot.set_defaults(command=plot_command)

    merge = commands.add_parser("merge", help="gather the files of a run into one")
    merge.add_argument("frames", help="frames (.vtkhdf)")
    merge.add_argument("target", help="the one file (.vtkhdf)")
    merge.set_defaults(command=merge_command)

    verify = commands.add_parser("verify", help="compare the files of a run with their checksums")
    verify.add_argument("frames", help="frames (.vtkhdf)")
    verify.add_argument(
        "--rebuild", action="store_true", help="make a lost index anew from the data files first"
    )
    verify.set_defaults(command=verify_command)

    keys = commands.add_parser("keys", help="list the keys of a scene file")
    keys.add_argument(
        "section",
        nargs="?",
        default="",
        help="one section (heat, heat.boundaries, shape, annulus), or history: what runs record",
    )
    keys.set_defaults(command=keys_command)

    schema = commands.add_parser("schema", help="JSON Schema of scene files, for editors")
    schema.add_argument("--save", metavar="FILE", help="write it there")
    schema.set_defaults(command=schema_command)

    _add_examples(commands)

    _add_tradeoff(commands)
    _add_reproduce(commands)
    _add_extremes(commands)
    return top


def _add_examples(commands: argparse._SubParsersAction[Parser]) -> None:
    examples = commands.add_parser("examples", help="list or copy the example scenes")
    actions = examples.add_subparsers(required=True, metavar="ACTION", parser_class=Parser)
    shown = actions.add_parser("list", help="name and title of each")
    shown.set_defaults(command=list_examples_command)
    copied = actions.add_parser("copy", help="copy scenes with the files they read")
    copied.add_argument("name", nargs="*", help="vhfm/ring, or vhfm for all of it; all if none")
    copied.add_argument("--to", metavar="DIR", default=".", help="the current folder unless given")
    copied.set_defaults(command=copy_examples_command)


def _summary() -> str:
    return "Heat and large deformation with particles, on boundaries that do not fit the grid."


def _scene_arguments(command: argparse.ArgumentParser) -> None:
    command.add_argument("scene", help="scene file (TOML)")
    command.add_argument(
        "--set",
        action="append",
        default=[],
        metavar="PATH=VALUE",
        dest="changes",
        help="change one member of the scene: grid.cell=0.05; may be repeated",
    )


def _count(text: str) -> int:
    try:
        number = int(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"an integer, got {text!r}") from None
    if not 1 <= number <= 4096:
        raise argparse.ArgumentTypeError(f"from 1 to 4096, got {number}")
    return number


def _add_tradeoff(commands: argparse._SubParsersAction[Parser]) -> None:
    tradeoff = commands.add_parser("tradeoff", help="measure error against cost")
    _scene_arguments(tradeoff)
    tradeoff.add_argument(
        "--vary",
        action="append",
        required=True,
        metavar="PATH=A,B,...",
        help="values of one member to try; may be repeated",
    )
    tradeoff.add_argument(
        "--reference",
        required=True,
        metavar="WHAT",
        help="radial, slab, finer:grid.cell=0.05, a .vtkhdf file, or module:function",
    )
    tradeoff.add_argument("--times", metavar="S,S,...", help="the end unless given")
    tradeoff.add_argument("--field", default="temperature")
    tradeoff.add_argument("--repeats", type=_count, default=3)
    tradeoff.add_argument("--workers", type=_count, default=1, help="runs at once")
    tradeoff.add_argument("--threads", type=_count, default=1, help="threads of each run")
    tradeoff.add_argument(
        "--target-error", type=float, metavar="E", help="name the cheapest within"
    )
    tradeoff.add_argument("--budget", type=float, metavar="S", help="name the best within CPU s")
    tradeoff.add_argument(
        "--output", metavar="NAME", help="NAME.csv, .json, .png, .jsonl; the scene's unless given"
    )
    tradeoff.set_defaults(command=tradeoff_command)


def _add_reproduce(commands: argparse._SubParsersAction[Parser]) -> None:
    reproduce = commands.add_parser("reproduce", help="paper, reference and lapilli side by side")
    reproduce.add_argument("case", nargs="*", help="vhfm/ring, or vhfm for all of it; all if none")
    reproduce.add_argument("--list", action="store_true", help="list the cases")
    reproduce.add_argument("--quick", action="store_true", help="smaller sizes, in seconds")
    reproduce.add_argument("--json", metavar="FILE", help="write the rows")
    reproduce.add_argument("--plot", metavar="DIR", help="draw the paper's figures")
    reproduce.set_defaults(command=reproduce_command)


def _add_extremes(commands: argparse._SubParsersAction[Parser]) -> None:
    extremes = commands.add_parser("extremes", help="map stable, inaccurate and refused steps")
    extremes.add_argument(
        "--transfer",
        action="append",
        choices=["nodal", "flip", "pic", "tpic", "affine", "peridynamics", "dynamics"],
        help="one transfer of heat, or a method; may be repeated; all unless given",
    )
    extremes.add_argument("--quick", action="store_true", help="four steps a case")
    extremes.add_argument("--json", metavar="FILE", help="write every step")
    extremes.add_argument("--plot", metavar="DIR", help="draw the map")
    extremes.set_defaults(command=extremes_command)


def load(given: argparse.Namespace) -> Scene:
    """The scene with its changes."""
    scene = Scene.load(given.scene)
    for change in given.changes:
        scene = scene.set(change)
    return scene


def run_command(given: argparse.Namespace) -> int:
    """lapilli run"""
    from lapilli.result import run

    scene = load(given)
    output = given.output or scene.output.path or Path(given.scene).stem + ".vtkhdf"
    result = run(
        scene,
        output,
        given.every,
        threads=given.threads,
        progress=not given.quiet,
        resume=given.resume,
    )
    if not given.quiet:
        print(result.report(), end="")
    return FINISHED


def check_command(given: argparse.Namespace) -> int:
    """lapilli check"""
    scene = load(given)
    text = _core.check_json(scene) if given.json else _core.check_text(scene)
    print(text, end="" if text.endswith("\n") else "\n")
    return FINISHED


def plot_command(given: argparse.Namespace) -> int:
    """lapilli plot"""
    from lapilli import plot

    save = Path(given.save or Path(given.frames).with_suffix(".png"))
    if save.suffix.lower() in {".gif", ".mp4", ".webm"}:
        plot.animate(given.frames, save, given.field)
    else:
        plot.draw(given.frames, given.field, given.time, save)
    print(f"wrote {save}")
    return FINISHED


def merge_command(given: argparse.Namespace) -> int:
    """lapilli merge"""
    _core.merge(given.frames, given.target)
    print(f"wrote {given.target}")
    return FINISHED


def verify_command(given: argparse.Namespace) -> int:
    """lapilli verify"""
    if given.rebuild:
        print(f"made the index anew, with {_core.rebuild_index(given.frames)} frames")
    frames, whole, damages = _core.verify(given.frames)
    for damage in damages:
        print(damage)
    print(f"{whole} of {frames} frames are whole" + ("" if damages else "; no damage found"))
    return DISK_FAILED if damages else FINISHED


def keys_command(given: argparse.Namespace) -> int:
    """lapilli keys"""
    print(_core.keys_as_markdown(given.section), end="")
    return FINISHED


def schema_command(given: argparse.Namespace) -> int:
    """lapilli schema"""
    if given.save is None:
        print(_core.scene_schema(), end="")
    else:
        Path(given.save).write_text(_core.scene_schema())
        print(f"wrote {given.save}")
    return FINISHED


def list_examples_command(given: argparse.Namespace) -> int:
    """lapilli examples list"""
    from lapilli import examples

    width = max(map(len, examples.names()), default=0)
    for name in examples.names():
        print(f"{name:{width}}  {examples.title(name)}")
    return FINISHED


def copy_examples_command(given: argparse.Namespace) -> int:
    """lapilli examples copy"""
    from lapilli import examples

    for path in examples.copy(given.name, given.to):
        print(f"wrote {path}")
    return FINISHED


def tradeoff_command(given: argparse.Namespace) -> int:
    """lapilli tradeoff"""
    from lapilli.study.show import show_study

    return FINISHED if show_study(load(given), given) else RUN_FAILED


def reproduce_command(given: argparse.Namespace) -> int:
    """lapilli reproduce"""
    from lapilli.reproduce import show_cases

    kept = show_cases(given.case, given.list, given.quick, given.json, given.plot)
    return FINISHED if kept else BAR_MISSED


def extremes_command(given: argparse.Namespace) -> int:
    """lapilli extremes"""
    from lapilli.extremes.show import show_extremes

    return FINISHED if show_extremes(given) else BAR_MISSED


if __name__ == "__main__":
    sys.exit(main())
