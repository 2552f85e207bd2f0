# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The page that reports are written on: one HTML file that holds its pictures."""
import base64
import html

_CSS = """
body{margin:0;background:#f4f5f7;color:#22262b;font:15px/1.55 system-ui,"Segoe UI",Helvetica,
Arial,sans-serif}
main{max-width:960px;margin:0 auto;padding:34px 22px 60px}
header h1{margin:0;font-size:27px;letter-spacing:-.01em}header p{margin:4px 0 0;color:#687079}
section{background:#fff;border:1px solid #e3e6ea;border-radius:10px;padding:20px 24px;
margin-top:20px}
h2{font-size:18px;margin:0 0 10px}h3{font-size:13px;margin:18px 0 4px;color:#1f5fa8;
text-transform:uppercase;letter-spacing:.05em}
table{border-collapse:collapse;width:100%}td{padding:7px 10px 7px 0;vertical-align:top;
border-top:1px solid #edeff2}td.n{white-space:nowrap;width:210px}
td.v{text-align:right;white-space:nowrap;font-variant-numeric:tabular-nums;font-weight:600;
width:110px;padding-right:6px}td.u{width:34px;color:#687079}td.m{color:#4a4f57;font-size:14px}
td.t{overflow-wrap:anywhere}figure{margin:0}figure img{width:100%;height:auto;display:block}
figcaption{color:#4a4f57;font-size:14px;margin-top:6px}
pre{background:#f7f8fa;border-radius:8px;padding:14px 16px;overflow-x:auto;font-size:13px;
line-height:1.45;margin:8px 0 0}
@media(max-width:600px){main{padding:20px 10px 40px}section{padding:14px 12px}
table.facts tr{display:grid;grid-template-columns:1fr auto 46px;border-top:1px solid #edeff2}
table.facts td{border-top:0;padding:5px 0}table.facts td.n,table.facts td.v{width:auto;
white-space:normal}table.facts td.v{padding-right:6px}table.facts td.m,table.facts td.t{
grid-column:1/-1;padding-top:0}}
.pair{display:grid;grid-template-columns:1fr 1fr;gap:18px;align-items:start}
@media(max-width:700px){.pair{grid-template-columns:1fr}}
main.wide{max-width:1280px}.single,figure.diagram{max-width:900px;margin:6px auto 16px}
a{color:#1f5fa8}p.small{font-size:14px;margin:12px 0 0}
table.compare{font-variant-numeric:tabular-nums}table.compare th{text-align:right;
font-weight:600;font-size:13px;color:#4a4f57;padding:6px 0 6px 10px;vertical-align:bottom}
table.compare td{text-align:right;padding:7px 0 7px 10px;white-space:nowrap}
table.compare th:first-child,table.compare td:first-child{text-align:left;padding-left:0}
.scroll{overflow-x:auto}table.compare th[colspan]{text-align:left;color:#1f5fa8;padding-top:14px}
.note{color:#8a5a12;background:#fdf5e6;border-radius:8px;padding:10px 14px;margin:0 0 8px}
"""

_TYPES = {".png": "image/png", ".svg": "image/svg+xml"}


def picture(path, title, caption, kind=""):
    """A figure that embeds a PNG or SVG file; kind: a class of the style sheet."""
    data = base64.b64encode(path.read_bytes()).decode("ascii")
    attribute = f' class="{kind}"' if kind else ""
    return (f'<figure{attribute}><img alt="{html.escape(title)}" '
            f'src="data:{_TYPES[path.suffix]};base64,{data}">'
            f"<figcaption>{html.escape(caption)}</figcaption></figure>")


def page(title, remark, sections, kind=""):
    """A whole page as HTML text. sections: HTML, one after the other; kind: a class of <main>."""
    title = html.escape(title)
    attribute = f' class="{kind}"' if kind else ""
    return (f'<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"><meta name="viewport" '
            f'content="width=device-width,initial-scale=1"><title>{title}</title>'
            f"<style>{_CSS}</style></head><body><main{attribute}><header><h1>{title}</h1>"
            f"<p>{html.escape(remark)}</p></header>" + "".join(sections)
            + "</main></body></html>\n")
