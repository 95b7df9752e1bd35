"""A hook of mkdocs: formulas, LaTeX between dollars, become MathML when the manual is built.

No script runs in the reader's browser and nothing is loaded. A formula with a word that the
converter does not know is an error.
"""

from __future__ import annotations

import html
import re
from typing import Any

from latex2mathml.converter import convert

# What pymdownx.arithmatex (generic) leaves of $...$ and $$...$$.
FORMULA = re.compile(
    r'<(?P<tag>span|div) class="arithmatex">\\[(\[](?P<latex>.*?)\\[)\]]</(?P=tag)>', re.DOTALL
)


def on_page_content(text: str, page: Any, **_: Any) -> str:
    """The page with its formulas as MathML."""
    return FORMULA.sub(lambda found: mathml(found, page.file.src_path), text)


def mathml(found: re.Match[str], place: str) -> str:
    """One formula; the search of the site leaves it out."""
    latex = html.unescape(found["latex"]).strip()
    display = "block" if found["tag"] == "div" else "inline"
    made = convert(latex, display=display)
    if "\\" in made or "&</" in made:
        raise ValueError(f"{place}: no MathML for {latex!r}")
    return made.replace("<math ", '<math data-search-exclude="" ', 1)
