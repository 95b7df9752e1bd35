"""lapilli completion"""

from __future__ import annotations

from typing import Annotated, Literal

from cyclopts import Parameter

from lapilli.commands.codes import FINISHED
from lapilli.commands.options import Quiet, Verbose
from lapilli.commands.wrote import wrote


def command(
    shell: Annotated[Literal["bash", "zsh", "fish", "powershell"], Parameter(help="which shell")],
    /,
    *,
    install: Annotated[
        bool, Parameter(negative=(), help="put it where the shell looks for it")
    ] = False,
    quiet: Quiet = False,
    verbose: Verbose = False,
) -> int:
    """Complete commands and options in a shell.

    Prints a script for `source`, or with --install puts it where new shells find it.
    """
    del verbose
    from lapilli.cli import application

    app = application()
    if install:
        wrote([app.install_completion(shell=shell)], False, quiet)
    else:
        print(app.generate_completion(prog_name="lapilli", shell=shell))
    return FINISHED
