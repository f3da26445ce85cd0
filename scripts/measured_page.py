"""Common functions of the scripts that write tables of doc/measurements/ and
doc/verification/."""

import datetime
import pathlib
import platform
import re

ROOT = pathlib.Path(__file__).resolve().parent.parent
PICTURES = ROOT / "doc" / "pictures"


def machine():
    """The kind of processor, as the system names it."""
    info = pathlib.Path("/proc/cpuinfo")
    found = info.exists() and re.search(r"^model name\s*: (.*)$",
                                        info.read_text(encoding="utf-8"), re.MULTILINE)
    return f"{found[1]}, {platform.machine()}" if found else platform.machine()


def provenance(command, date=None, cores="one core"):
    """The line below a measured table: date (today), machine, command that makes it."""
    return f"{date or datetime.date.today()}, {cores} of {machine()}: `{command}`\n"


def write_blocks(page, makers):
    """Replaces the text of @p page between `<!-- NAME -->` and `<!-- end -->` by what
    @p makers has for that name: a function that returns Markdown."""
    names = "|".join(map(re.escape, makers))
    pattern = re.compile(rf"(<!-- ({names}) -->\n)(.*?)(<!-- end -->)", re.DOTALL)

    def block(match):
        head, name, _, end = match.groups()
        return head + "\n" + makers[name]() + "\n" + end

    text = page.read_text(encoding="utf-8")
    page.write_text(pattern.sub(block, text), encoding="utf-8")
