# SPDX-License-Identifier: AGPL-3.0-or-later
"""report.html: one file with its pictures inside, for the screen and for paper."""

import base64
import pathlib
from html import escape

from suite import text

STYLE = pathlib.Path(__file__).with_name("report.css")
TYPES = {"svg": "image/svg+xml", "png": "image/png"}
MARKS = {"PASS": "pass", "miss": "missed", "not yet": "waiting", "": ""}
LONG = 40  # rows; a longer table shows its worst first


def page(outcomes, figures, about):
    body = [f"<h1>Validation of etendue</h1><p class=about>{escape(about)}</p>",
            f"<p><strong>{escape(text.summary_line(outcomes))}</strong></p><p>{escape(text.ALLOWED)}</p>", front(outcomes)]
    body += [section(outcome, figures[outcome.benchmark.name]) for outcome in outcomes if not outcome.benchmark.not_yet]
    return (f"<!DOCTYPE html><html lang=en><head><meta charset=utf-8><title>Validation of etendue</title>"
            f"<meta name=viewport content='width=device-width'><style>{STYLE.read_text(encoding='utf-8')}</style></head>"
            f"<body>{''.join(body)}</body></html>")


def front(outcomes):
    rows, group = [], ""
    for outcome in outcomes:
        if outcome.benchmark.group != group:
            group = outcome.benchmark.group
            rows.append(f"<tr class=group><th colspan={len(text.FRONT)}>{escape(group)}</th></tr>")
        rows.append(front_row(outcome))
    return f"<div class=wide><table class=front><thead>{row(text.FRONT, 'th')}</thead><tbody>{''.join(rows)}</tbody></table></div>"


def front_row(outcome):
    cells = [escape(cell) for cell in text.front_cells(outcome)]
    if not outcome.benchmark.not_yet:
        cells[0] = f"<a href='#{cells[0]}'>{cells[0]}</a>"
    cells[2] = verdict(outcome.verdict)
    if outcome.worst:
        cells[4] = f"<span class=bar><i style='width:{min(100, 100 * outcome.worst.share):.0f}%'></i></span> {cells[4]}"
    return "<tr>" + "".join(f"<td>{cell}</td>" for cell in cells) + "</tr>"


def verdict(word):
    return f"<b class={MARKS[word]}>{word}</b>" if word else ""


def section(outcome, figures):
    benchmark = outcome.benchmark
    parts = [f"<section id='{benchmark.name}'><h2>{escape(benchmark.title)} {verdict(outcome.verdict)}</h2>",
             "".join(f"<p>{escape(paragraph)}</p>" for paragraph in benchmark.text.split("\n\n")),
             f"<p class=reason>{escape(text.miss_line(outcome))}</p>" if text.miss_line(outcome) else "",
             "<ul>" + "".join(f"<li>{escape(line)}</li>" for line in text.run_lines(outcome))
             + "".join(f"<li class=fault>{escape(fault)}</li>" for fault in outcome.faults) + "</ul>",
             "<div class=figures>" + "".join(map(picture, figures)) + "</div>", values(outcome), tolerances(benchmark)]
    return "".join(parts) + "</section>"


def picture(figure):
    data = base64.b64encode(figure.data).decode()
    return (f"<figure><img alt='{escape(figure.caption, quote=True)}' src='data:{TYPES[figure.form]};base64,{data}'>"
            f"<figcaption>{escape(figure.caption)}</figcaption></figure>")


def values(outcome):
    rows = outcome.rows
    if len(rows) <= LONG:
        return value_table(rows)
    worst = sorted((j for j in rows if j.share is not None), key=lambda j: -j.share)[:12]
    return (f"<p>The worst {len(worst)} of {len(rows)} values:</p>{value_table(worst)}"
            f"<details><summary>All {len(rows)} values</summary>{value_table(rows)}</details>")


def value_table(rows):
    found = []
    for judged in rows:
        cells = [escape(cell) for cell in text.cells(judged)]
        cells[-1] = verdict(judged.verdict)
        found.append("<tr>" + "".join(f"<td>{cell}</td>" for cell in cells) + "</tr>")
    return (f"<div class=wide><table class=values><thead>{row(text.COLUMNS, 'th')}</thead>"
            f"<tbody>{''.join(found)}</tbody></table></div>")


def tolerances(benchmark):
    lines = "".join(row(map(escape, line)) for line in text.tolerance_lines(benchmark))
    origins = "".join(f"<li><code>{escape(name)}</code>: {escape(origin)}</li>" for name, origin in text.origins(benchmark))
    source = f"<p>Reference: {escape(benchmark.source)}</p>" if benchmark.source else ""
    return (f"<div class=wide><table class=why><thead>{row(['of', 'allowed', 'reason'], 'th')}</thead><tbody>{lines}</tbody></table></div>"
            f"{source}<ul class=origin>{origins}</ul>")


def row(cells, kind="td"):
    return "<tr>" + "".join(f"<{kind}>{cell}</{kind}>" for cell in cells) + "</tr>"
