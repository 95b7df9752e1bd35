"""The commands of `lapilli`, one module each.

A command is a function `command` in `lapilli/commands/NAME.py` and its name below, in the order of
`lapilli --help`; a group of commands is an `app` with a `command` for each action. A module is
imported when its command is used; what is heavy is imported inside of the function.
"""

COMMANDS = (
    "new",
    "run",
    "check",
    "plot",
    "report",
    "merge",
    "verify",
    "keys",
    "schema",
    "examples",
    "tradeoff",
    "study",
    "suggest",
    "reproduce",
    "extremes",
    "completion",
)

GROUPS = ("examples",)
