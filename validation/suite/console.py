# SPDX-License-Identifier: AGPL-3.0-or-later
"""What etendue-validate prints."""


def print_list(benchmarks):
    for entry in benchmarks:
        state = "not yet" if entry.not_yet else "quick" if entry.quick else "full"
        print(f"{entry.name:24} {state:8} {entry.title}")


def print_outcome(outcome, verbose):
    entry = outcome.benchmark
    if entry.not_yet:
        print(f"{entry.name:24} not yet  {entry.not_yet}", flush=True)
        return
    worst = outcome.worst
    nearest = f", worst at {100 * worst.share:.0f} % of what is allowed ({worst.row.label})" if worst else ""
    print(f"{entry.name:24} {outcome.verdict:8} {len(outcome.judged) - len(outcome.missed)} of {len(outcome.judged)} values met"
          f"{nearest}, {outcome.seconds:.0f} s", flush=True)
    for fault in outcome.faults:
        print(f"    {fault}")
    for judged in outcome.rows if verbose else outcome.missed:
        print("    " + row_text(judged))


def row_text(judged):
    row = judged.row
    relative = "" if row.relative is None else f"{row.relative:+.2e}"
    sigmas = "" if row.sigmas is None else f"{row.sigmas:+.3g} u"
    allowed = "" if judged.allowed is None else f"{judged.allowed:.1e}"
    return (f"{row.label:34} {row.value:13.7g} {row.reference:13.7g} {row.difference:+10.2e} {relative:>10} {sigmas:>12} "
            f"{allowed:>8} {judged.verdict}")


def print_end(outcomes, seconds, options):
    run = [outcome for outcome in outcomes if not outcome.benchmark.not_yet]
    waiting = len(outcomes) - len(run)
    print(f"{sum(o.passed for o in run)} of {len(run)} benchmarks agree with their references"
          f"{f', {waiting} not yet possible' if waiting else ''}; {seconds:.0f} s")
    if not options.no_report:
        print(f"report: {options.output / 'report.html'}")
