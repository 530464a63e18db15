#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Puts the medians of scripts/bench.sh between the markers of a page: bench_table.py BENCH.json PAGE.md"""
import json
import sys

BEGIN, END = "<!-- bench begin -->\n", "<!-- bench end -->\n"
ROWS = [
    ("one pass of springs, dampers and anchors, 100,000 nodes, 1 and 2 threads",
     "{spring_100k_1t_ns:.2f} and {spring_100k_2t_ns:.2f} ns a spring"),
    ("  times faster than an iteration of Bullet's soft body, 1 and 2 threads",
     "{springs_vs_bullet_100k_1t_x:.1f} and {springs_vs_bullet_100k_2t_x:.1f} (Bullet {spring_100k_bullet_ns:.1f} ns)"),
    ("  times faster than the plain loop in the scan's order, 100,000 and 1,000,000 nodes",
     "{springs_vs_naive_100k_2t_x:.1f} and {springs_vs_naive_1m_2t_x:.1f}"),
    ("  share of the STREAM triad's bytes per second at 1,000,000 nodes, 2 threads",
     "{stream_1m_2t_share:.2f} of {stream_2t_gb_per_s:.0f} GB/s"),
    ("  ns a spring by size: 5k, 20k, 80k, 320k, 1M nodes, 2 threads",
     "{spring_by_size_5k_2t_ns:.2f}, {spring_by_size_20k_2t_ns:.2f}, {spring_by_size_80k_2t_ns:.2f}, "
     "{spring_by_size_320k_2t_ns:.2f}, {spring_by_size_1000k_2t_ns:.2f}"),
    ("kernels chosen at run time over a build for the machine", "{baseline_vs_native_x:.2f}"),
    ("2 threads over 1 while another process keeps one processor busy", "{busy_neighbour_2t_vs_1t_x:.2f}"),
    ("cold 10 mm pull on 100,000 nodes to 1 % of the energy", "{cold_pull_100k_ms:.0f} ms; explicit Euler at its stable "
     "step on the same kernel {cold_pull_explicit_100k_ms:.0f} ms or more ({cold_pull_vs_explicit_100k_x:.0f} ×)"),
    ("set-up of the levels, 10,000 and 100,000 nodes", "{levels_set_up_10k_ms:.0f} and {levels_set_up_100k_ms:.0f} ms"),
    ("frame of a live 10 mm drag (forces, levels, scan and normals), median and 99 %: 10k", "{live_drag_median_10k_ms:.1f} and {live_drag_p99_10k_ms:.1f} ms"),
    ("  100k", "{live_drag_median_100k_ms:.1f} and {live_drag_p99_100k_ms:.1f} ms"),
    ("  1M", "{live_drag_median_1m_ms:.1f} and {live_drag_p99_1m_ms:.1f} ms"),
    ("  off the equilibrium at the end of the drag (rms) and a second later: 100k",
     "{live_drag_rms_100k_share:.1%} and {live_drag_rms_1s_after_100k_share:.1%}"),
    ("  1M", "{live_drag_rms_1m_share:.1%} and {live_drag_rms_1s_after_1m_share:.1%}"),
    ("slider move to picture, 100k, median and 99 %",
     "{slider_update_100k_ms:.1f} and {slider_update_p99_100k_ms:.1f} ms"),
    ("saving a case of a reshaped scan of 1,000,000 vertices", "{save_case_1m_ms:.0f} ms"),
    ("from a file to an answering face, 10k, 100k, 1M",
     "{open_to_interactive_10k_ms:.0f}, {open_to_interactive_100k_ms:.0f}, {open_to_interactive_1m_ms:.0f} ms"),
]


def main() -> int:
    if len(sys.argv) != 3:
        print(__doc__, file=sys.stderr)
        return 2
    with open(sys.argv[1], encoding="utf-8") as file:
        values = json.load(file)
    lines = ["| what | measured |\n", "|---|---|\n"]
    for name, form in ROWS:
        try:
            lines.append(f"| {name.strip() if not name.startswith(' ') else '· ' + name.strip()} | {form.format(**values)} |\n")
        except KeyError:
            pass  # a part of the benchmarks that was not run
    with open(sys.argv[2], encoding="utf-8") as file:
        text = file.read()
    head, rest = text.split(BEGIN)
    tail = rest.split(END)[1]
    with open(sys.argv[2], "w", encoding="utf-8") as file:
        file.write(head + BEGIN + "".join(lines) + END + tail)
    return 0


if __name__ == "__main__":
    sys.exit(main())
