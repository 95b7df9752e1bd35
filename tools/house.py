"""What the sources look like from outside: print it, or let a test hold it.

`python tools/house.py` prints includes that run up, circles of includes and imports, the longest
chain of folders below `scene`, and files and functions that are too long.
"""

from __future__ import annotations

import ast
import re
import subprocess
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path

ROOT = Path(__file__).parents[1]
LIBRARY = ROOT / "cpp" / "lapilli"
PACKAGE = ROOT / "python" / "lapilli"
LONG_FILE, LONG_FUNCTION = 300, 60  # lines

# Who may include whom, as CONTRIBUTING.md draws it.
ALLOWED = {
    "core": {"core"},
    "materials": {"materials", "core"},
    "geometry": {"geometry", "core"},
    "output": {"output", "core"},
    "algebra": {"algebra", "geometry", "core"},
    "mpm": {"mpm", "algebra", "materials", "geometry", "core"},
    "peridynamics": {"peridynamics", "materials", "geometry", "core"},
    "scene": {"scene", "output", "algebra", "mpm", "peridynamics", "materials", "geometry", "core"},
}
INCLUDE = re.compile(r'^\s*#\s*include\s+"lapilli/([a-z_0-9/.]+)"', re.MULTILINE)
Graph = Mapping[str, set[str]]


def sources(folder: Path) -> list[Path]:
    """The C++ files below a folder."""
    return sorted(path for path in folder.rglob("*") if path.suffix in {".hpp", ".cpp"})


def included(path: Path) -> set[str]:
    """The headers of the library that a file includes, below cpp/lapilli."""
    return set(INCLUDE.findall(path.read_text()))


def upward_includes(folder: str) -> list[str]:
    """Includes of a folder that its row of the table does not allow."""
    return sorted(
        f"{path.relative_to(ROOT)} includes {header}"
        for path in sources(LIBRARY / folder)
        for header in included(path)
        if header.split("/")[0] not in ALLOWED[folder]
    )


def include_graph() -> dict[str, set[str]]:
    """By header or source of the library: the headers that it includes."""
    return {str(path.relative_to(LIBRARY)): included(path) for path in sources(LIBRARY)}


def room(file: str) -> str:
    """The folder that a file is filed under: "core", "mpm/heat"."""
    return "/".join(file.split("/")[:-1][:2])


def folder_graph() -> dict[str, set[str]]:
    """By folder: the other folders that its files include from."""
    graph: dict[str, set[str]] = defaultdict(set)
    for file, headers in include_graph().items():
        graph[room(file)] |= {room(header) for header in headers} - {room(file)}
    return dict(graph)


def import_graph() -> dict[str, set[str]]:
    """By module of the package: the modules that importing it imports."""
    modules = {}
    for path in PACKAGE.rglob("*.py"):
        parts = path.relative_to(PACKAGE.parent).with_suffix("").parts
        modules[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = path
    graph = {}
    for module, path in modules.items():
        graph[module] = set()
        for name in imported(ast.parse(path.read_text()).body):
            if not name.startswith("lapilli._core"):  # compiled: it imports nothing of these
                known = [one for one in (name, name.rpartition(".")[0]) if one in modules]
                graph[module] |= set(known[:1]) - {module}
    return graph


def imported(body: Iterable[ast.stmt]) -> Iterator[str]:
    """Full names that statements at the top of a module import."""
    for statement in body:
        if isinstance(statement, ast.Import):
            yield from (name.name for name in statement.names)
        elif isinstance(statement, ast.ImportFrom) and statement.module:
            yield from (f"{statement.module}.{name.name}" for name in statement.names)
        elif isinstance(statement, ast.Try):
            yield from imported(statement.body)


def circles(graph: Graph) -> list[list[str]]:
    """Groups of more than one that reach each other."""
    reach = {start: reached(graph, start) for start in graph}
    groups = {
        tuple(sorted(other for other in reach[one] if one in reach.get(other, set())))
        for one in graph
        if one in reach[one]
    }
    return sorted(list(group) for group in groups)


def reached(graph: Graph, start: str) -> set[str]:
    """All that `start` leads to; itself only by a circle."""
    seen: set[str] = set()
    left = list(graph[start])
    while left:
        one = left.pop()
        if one not in seen:
            seen.add(one)
            left += graph.get(one, set())
    return seen


def longest_chain(graph: Graph, start: str) -> list[str]:
    """The longest way down from `start` in a graph without circles."""
    ways = [longest_chain(graph, below) for below in sorted(graph.get(start, set()))]
    return [start, *max(ways, key=len, default=[])]


def tracked(*patterns: str) -> list[Path]:
    """Files that are under version control."""
    listed = subprocess.run(
        ["git", "ls-files", *patterns], cwd=ROOT, capture_output=True, text=True, check=True
    )
    return [path for name in listed.stdout.split() if (path := ROOT / name).is_file()]


def long_files() -> list[tuple[int, str]]:
    """Sources of more than 300 lines, C++ and Python, tests included."""
    lengths = [
        (path.read_text().count("\n"), str(path.relative_to(ROOT)))
        for path in tracked("*.hpp", "*.cpp", "*.py")
    ]
    return sorted((found for found in lengths if found[0] > LONG_FILE), reverse=True)


def long_functions() -> list[tuple[int, str]]:
    """Functions of more than 60 lines in library, bindings, package and tools."""
    found = []
    for path in tracked("cpp/*.hpp", "cpp/*.cpp", "python/bindings/*.[hc]pp"):
        found += [(size, path, name) for size, name in cpp_functions(path.read_text())]
    for path in tracked("python/lapilli/*.py", "tools/*.py", "bench/*.py"):
        for node in ast.walk(ast.parse(path.read_text())):
            if isinstance(node, ast.FunctionDef):
                found.append(((node.end_lineno or 0) - node.lineno + 1, path, node.name))
    return sorted(
        (
            (size, f"{path.relative_to(ROOT)}: {name}")
            for size, path, name in found
            if size > LONG_FUNCTION
        ),
        reverse=True,
    )


NOT_CODE = re.compile(
    r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'|^\s*#(?:[^\n]*\\\n)*[^\n]*',
    re.DOTALL | re.MULTILINE,
)
CONTAINER = re.compile(r"\b(namespace|class|struct|union|enum)\b[^()]*$|^\s*extern\s*$")
NAME = re.compile(r"([\w:~]+|operator\S+)\s*\($")


def cpp_functions(text: str) -> Iterator[tuple[int, str]]:
    """Length in lines and name of every function that C++ text defines."""
    text = NOT_CODE.sub(lambda found: re.sub(r"[^\n]", " ", found[0]), text)
    open_braces: list[tuple[bool, int, str]] = []  # container, begin of the head, head
    begin = 0
    for at in re.finditer(r"[{};]", text):
        head = text[begin : at.start()]
        if at[0] == "{":
            open_braces.append((bool(CONTAINER.search(head)), begin, head))
        elif at[0] == "}" and open_braces:
            container, since, its_head = open_braces.pop()
            outer = all(brace[0] for brace in open_braces)
            if not container and outer and "(" in its_head:
                since += len(its_head) - len(its_head.lstrip())
                name = its_head[: its_head.index("(") + 1].split()[-1]
                yield text.count("\n", since, at.start()) + 1, name.rstrip("(")
        begin = at.end()


def main() -> None:
    folders = folder_graph()
    up = [line for folder in ALLOWED for line in upward_includes(folder)]
    of_folders = circles(folders)
    rows: list[tuple[str, list[str]]] = [
        ("includes that run up", up),
        ("circles of C++ files", [" ".join(group) for group in circles(include_graph())]),
        ("circles of C++ folders", [" ".join(group) for group in of_folders]),
        ("circles of Python modules", [" ".join(group) for group in circles(import_graph())]),
        (f"files over {LONG_FILE} lines", [f"{n} {name}" for n, name in long_files()]),
        (f"functions over {LONG_FUNCTION} lines", [f"{n} {name}" for n, name in long_functions()]),
    ]
    for title, found in rows:
        print(f"{len(found):4} {title}")
        for line in found:
            print(f"         {line}")
    if not of_folders:
        chain = longest_chain(folders, "scene")
        print(f"{len(chain):4} folders in the longest chain: {' > '.join(chain)}")


if __name__ == "__main__":
    main()
