#!/usr/bin/env python3
"""Makes the gallery of shipped scenarios: a page with all of them moving, and pictures for gallery.md.

    docs/make_gallery.py SPOKE OUT [NAME...]

Runs every scenario of models/ (or those that are named) by the program SPOKE into OUT, a run each with
its page, and writes OUT/index.html, which shows the pages side by side. With Chromium it also takes the
pictures of docs/pictures/gallery/ anew. gallery.md is written from the titles and the first lines of the
scenarios.
"""

import html
import pathlib
import re
import shutil
import subprocess
import sys
import tomllib

ROOT = pathlib.Path(__file__).resolve().parent.parent
PICTURES = ROOT / "docs" / "pictures" / "gallery"
LONGEST = 20.0  # seconds of a run that its picture needs
WIDTH, HEIGHT = 600, 380  # pixels of a picture

# Lets the picture of a page, which moves, cover all else.
MOVING = """<style>
body { overflow: hidden }
#animation-inertial { position: fixed; inset: 0; z-index: 10; background: Canvas;
  width: 100vw !important; height: 100vh !important; max-width: none; max-height: none }
</style>"""

STILL = """<script>setTimeout(() => {
  const canvas = document.getElementById('animation-inertial');
  const image = new Image();
  image.src = canvas.toDataURL();
  image.style = 'position:fixed;inset:0;width:100vw;height:100vh;object-fit:contain;background:white';
  image.onload = () => document.body.replaceChildren(image);
}, 1500)</script>"""


def scenarios(names):
    files = sorted((ROOT / "models").glob("*.toml"))
    return [file for file in files if not names or file.stem in names]


def described(file):
    """The title of a scenario, and the first sentences of its comment."""
    text = file.read_text(encoding="utf-8")
    comment = []
    for line in text.splitlines():
        if not line.startswith("#"):
            break
        comment.append(line[1:].strip())
    said = ""
    for sentence in re.findall(r".*?\.(?=\s|$)", " ".join(comment)):
        said += sentence
        if len(said) > 60:
            break
    return tomllib.loads(text).get("title", file.stem), said.strip()


def run(program, file, out):
    duration = tomllib.loads(file.read_text(encoding="utf-8"))["integration"]["duration"]
    command = [program, "run", str(file), "--quiet", "--out", str(out)]
    if duration > LONGEST:
        command += ["--set", f"integration.duration={LONGEST}"]
    subprocess.run(command, check=True, cwd=ROOT)


def write_moving(page):
    text = page.read_text(encoding="utf-8")
    page.with_name("moving.html").write_text(text.replace("</body>", MOVING + "</body>"), encoding="utf-8")


def take_picture(page, picture):
    still = page.with_name("still.html")
    still.write_text(page.read_text(encoding="utf-8").replace("</body>", STILL + "</body>"), encoding="utf-8")
    subprocess.run(["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
                    f"--window-size={WIDTH},{HEIGHT}", "--virtual-time-budget=6000",
                    f"--screenshot={picture}", still.as_uri()], check=True, capture_output=True)
    still.unlink()


def write_page(out, shown):
    cards = "\n".join(
        f'<section><h2>{html.escape(title)}</h2><p>{html.escape(text)}</p>'
        f'<iframe loading="lazy" title="{html.escape(title)}" src="{name}/moving.html"></iframe>'
        f'<p><a href="{name}/report.html">the page of the run</a> &middot; <code>spoke run models/{name}.toml</code></p></section>'
        for name, title, text in shown)
    (out / "index.html").write_text(f"""<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>Spoke: gallery</title>
<style>
body {{ font: 16px/1.4 system-ui, sans-serif; margin: 1rem; color-scheme: light dark }}
main {{ display: grid; grid-template-columns: repeat(auto-fill, minmax(30rem, 1fr)); gap: 1.5rem }}
section {{ border: 1px solid #8884; border-radius: 6px; padding: 0 1rem }}
iframe {{ width: 100%; height: 20rem; border: 0 }}
h2 {{ font-size: 1.1rem }}
</style></head><body><h1>Spoke: shipped scenarios</h1><main>
{cards}
</main></body></html>
""", encoding="utf-8")


def write_document(shown):
    parts = [f"### {title}\n\n![{title}](pictures/gallery/{name}.png)\n\n{text} File: `models/{name}.toml`.\n\n"
             f"```sh\nspoke run models/{name}.toml\n```\n" for name, title, text in shown]
    (ROOT / "docs" / "gallery.md").write_text("""# Gallery

What is shipped in `models/`, a picture of each while it moves, and its command. The page with all of them moving is made by

```sh
docs/make_gallery.py spoke gallery
```

which writes `gallery/index.html`, of the pages that the program itself writes for each run. Keys of scenarios are in
[scenario.md](scenario.md).

""" + "\n".join(parts), encoding="utf-8")


def main(program, out, *names):
    out = pathlib.Path(out).resolve()
    out.mkdir(parents=True, exist_ok=True)
    shown = []
    for file in scenarios(names):
        print(file.stem, flush=True)
        run(program, file, out / file.stem)
        write_moving(out / file.stem / "report.html")
        if shutil.which("chromium"):
            PICTURES.mkdir(parents=True, exist_ok=True)
            take_picture(out / file.stem / "report.html", PICTURES / f"{file.stem}.png")
        shown.append((file.stem, *described(file)))
    write_page(out, shown)
    if not names:
        write_document(shown)


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
