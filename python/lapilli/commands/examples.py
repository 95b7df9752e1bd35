"""lapilli examples list, copy"""

from __future__ import annotations

from typing import Annotated

from cyclopts import App, Parameter

from lapilli.commands.codes import FINISHED
from lapilli.commands.options import Json, Quiet, Verbose
from lapilli.commands.wrote import wrote
from lapilli.console import print_json

app = App(name="examples", help="List or copy the example scenes, and the tutorials as notebooks.")


@app.command(name="list")
def list_examples(*, json: Json = False, quiet: Quiet = False, verbose: Verbose = False) -> int:
    """Name and title of each."""
    del verbose
    from lapilli import examples, notebooks

    brief = quiet and not json
    found = {name: "" if brief else examples.title(name) for name in examples.names()}
    for name, page in notebooks.pages().items():
        found[name] = "" if brief else f"{notebooks.title(page)} (notebook)"
    if json:
        print_json([{"name": name, "title": title} for name, title in found.items()])
        return FINISHED
    width = max(map(len, found), default=0)
    for name, title in found.items():
        print(f"{name:{width}}  {title}".rstrip())
    return FINISHED


@app.command(name="copy")
def copy_examples(
    *name: Annotated[
        str, Parameter(help="vhfm/ring, vhfm for all of it, tutorials/heat; all if none")
    ],
    to: Annotated[str, Parameter(help="the current folder unless given")] = ".",
    json: Json = False,
    quiet: Quiet = False,
    verbose: Verbose = False,
) -> int:
    """Copy scenes with the files they read, and tutorials as notebooks."""
    del verbose
    from lapilli import examples

    wrote(examples.copy(name, to), json, quiet)
    return FINISHED
