#!/usr/bin/env python3
"""The docs are tested: links lead somewhere, shown programs are the files they are taken from, shown commands run.

check_docs.py links                  every relative link and anchor of every .md file resolves
check_docs.py programs               every ```cpp block after a line `<!-- file: PATH -->` is that file, byte for byte
check_docs.py pictures               every picture of docs/pictures is shown somewhere and is small
check_docs.py commands LUSTRO FILE   every ```sh block of FILE runs, in order, in one folder that holds assets/ and examples/

What stands on the line before an sh block changes what is expected of it: `<!-- not run: WHY -->`, `<!-- exits N -->`.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
FENCE = re.compile(r"^(```+|~~~+)\s*(\w*)")


def markdown_files():
    top = [p for p in ROOT.glob("*.md")]
    deep = [p for folder in ("docs", "assets", "examples") for p in (ROOT / folder).rglob("*.md")]
    return sorted(top + deep)


def split(text: str):
    """(prose lines with numbers, fenced blocks as (line number, language, line before, body))."""
    prose, blocks, before, fence = [], [], "", None
    for number, line in enumerate(text.splitlines(), start=1):
        match = FENCE.match(line)
        if fence is None and match:
            fence, body = (match[1], match[2], number, before), []
        elif fence is not None and line.strip() == fence[0]:
            blocks.append((fence[2], fence[1], fence[3], "\n".join(body) + "\n"))
            fence, before = None, ""
        elif fence is not None:
            body.append(line)
        else:
            prose.append((number, line))
            before = line.strip() or before
    return prose, blocks


def anchors(file: pathlib.Path):
    """The anchors of a file's headings, as GitHub makes them."""
    found, seen = set(), {}
    for _, line in split(file.read_text(encoding="utf-8"))[0]:
        heading = re.match(r"^#{1,6}\s+(.*?)\s*#*$", line)
        if heading:
            text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading[1])
            slug = re.sub(r"[^\w\- ]", "", text.lower().replace("`", "")).replace(" ", "-")
            count = seen.get(slug, 0)
            seen[slug] = count + 1
            found.add(slug if count == 0 else f"{slug}-{count}")
    return found


def check_links():
    problems, count = [], 0
    for file in markdown_files():
        for number, line in split(file.read_text(encoding="utf-8"))[0]:
            line = re.sub(r"`[^`]*`", "", line)
            targets = re.findall(r"\]\(<?([^)\s>]+)>?(?:\s+\"[^\"]*\")?\)", line) + re.findall(r"<(?:img|a)\s[^>]*?(?:src|href)=\"([^\"]+)\"", line)
            for target in targets:
                if re.match(r"^[a-z]+:", target):
                    continue
                count += 1
                path, _, anchor = target.partition("#")
                goal = (file.parent / path).resolve() if path else file
                where = f"{file.relative_to(ROOT)}:{number}"
                if not goal.exists():
                    problems.append(f"{where}: {target} does not exist")
                elif not goal.is_relative_to(ROOT):
                    problems.append(f"{where}: {target} leads out of the repository")
                elif anchor and goal.suffix == ".md" and anchor not in anchors(goal):
                    problems.append(f"{where}: {path or file.name} has no heading #{anchor}")
    return problems, f"{count} links in {len(markdown_files())} files"


def check_programs():
    problems, count = [], 0
    for file in markdown_files():
        for number, language, before, body in split(file.read_text(encoding="utf-8"))[1]:
            source = re.match(r"^<!-- file: (\S+) -->$", before)
            if not source:
                continue
            count += 1
            if not (ROOT / source[1]).exists():
                problems.append(f"{file.relative_to(ROOT)}:{number}: there is no {source[1]}")
            elif (ROOT / source[1]).read_text(encoding="utf-8") != body:
                problems.append(f"{file.relative_to(ROOT)}:{number}: the block is not {source[1]}")
    if count == 0:
        problems.append("no doc shows a program; README.md is expected to")
    return problems, f"{count} programs"


def check_pictures():
    problems, files = [], sorted(f for f in (ROOT / "docs" / "pictures").iterdir() if f.suffix in (".png", ".jpg"))
    text = "\n".join(f.read_text(encoding="utf-8") for f in markdown_files())
    for file in files:
        if f"pictures/{file.name}" not in text:
            problems.append(f"no page shows docs/pictures/{file.name}")
        if file.stat().st_size > 300_000:
            problems.append(f"docs/pictures/{file.name} has {file.stat().st_size} bytes, more than 300,000")
    total = sum(f.stat().st_size for f in files)
    if total > 6_000_000 or not files:
        problems.append(f"docs/pictures holds {len(files)} files with {total} bytes; expected are some, with at most 6,000,000")
    return problems, f"{len(files)} pictures with {total} bytes"


def check_commands(lustro: str, name: str):
    problems, count = [], 0
    file = ROOT / name
    with tempfile.TemporaryDirectory() as folder:
        place = pathlib.Path(folder)
        for part in ("assets", "examples"):
            if (ROOT / part).is_dir():
                shutil.copytree(ROOT / part, place / part)
        (place / "bin").mkdir()
        (place / "bin" / "lustro").symlink_to(pathlib.Path(lustro).resolve())
        environment = dict(os.environ, PATH=f"{place / 'bin'}:{os.environ['PATH']}")
        for number, language, before, body in split(file.read_text(encoding="utf-8"))[1]:
            if language != "sh" or before.startswith("<!-- not run"):
                continue
            expected = re.match(r"^<!-- exits (\d+) -->$", before)
            code = int(expected[1]) if expected else 0
            count += 1
            run = subprocess.run(["bash", "-euo", "pipefail", "-c", body], cwd=place, env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                 stderr=subprocess.STDOUT, text=True, timeout=300)
            if run.returncode != code:
                problems.append(f"{name}:{number}: exits {run.returncode}, not {code}\n{body}--- says ---\n{run.stdout}")
    return problems, f"{count} blocks of {name}"


def main() -> int:
    match sys.argv[1:]:
        case ["links"]:
            problems, what = check_links()
        case ["programs"]:
            problems, what = check_programs()
        case ["pictures"]:
            problems, what = check_pictures()
        case ["commands", lustro, name]:
            problems, what = check_commands(lustro, name)
        case _:
            print(__doc__, file=sys.stderr)
            return 2
    for problem in problems:
        print(problem)
    print(f"{what}: {'fine' if not problems else str(len(problems)) + ' problems'}")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
