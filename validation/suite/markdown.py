# SPDX-License-Identifier: AGPL-3.0-or-later
"""report.md; its pictures lie in pictures/."""

from suite import text


def page(outcomes, figures, about):
    lines = ["# Validation of etendue", "", about, "", text.summary_line(outcomes), "", text.ALLOWED, ""]
    lines += table(text.FRONT, [linked(text.front_cells(outcome)) for outcome in outcomes])
    for outcome in outcomes:
        if not outcome.benchmark.not_yet:
            lines += section(outcome, figures[outcome.benchmark.name])
    return "\n".join(lines) + "\n"


def linked(cells):
    return [f"[{cells[0]}](#{cells[0]})", *cells[1:]]


def section(outcome, figures):
    benchmark = outcome.benchmark
    lines = ["", f"## {benchmark.name}", "", f"**{benchmark.title}**: {outcome.verdict}", "", benchmark.text, ""]
    lines += [text.miss_line(outcome), ""] if text.miss_line(outcome) else []
    lines += [f"- {line}" for line in text.run_lines(outcome)]
    lines += [f"- fault: {fault}" for fault in outcome.faults]
    for figure in figures:
        lines += ["", f"![{figure.caption}](pictures/{figure.name}.{figure.form})"]
    lines += ["", *table(text.COLUMNS, [text.cells(judged) for judged in outcome.rows])]
    lines += ["", *table(["of", "allowed", "reason"], text.tolerance_lines(benchmark)), ""]
    lines += [f"Reference: {benchmark.source}"] if benchmark.source else []
    lines += [f"- `{name}`: {origin}" for name, origin in text.origins(benchmark)]
    return lines


def table(head, rows):
    return ["| " + " | ".join(head) + " |", "|" + "---|" * len(head),
            *("| " + " | ".join(cell.replace("|", "\\|") for cell in row) + " |" for row in rows)]
