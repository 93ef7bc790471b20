"""The pages of isochron show in a browser: opened at both widths in light and dark, played, scrubbed, turned, looked at. Prints TAP.

    pages.py FOLDER      single.html and several.html of the folder, single.svg, a still, and fault.html, which is broken
"""
import re
import sys

from browser import Browser

folder = sys.argv[1]
results = 0


def result(good, name):
    global results
    results += 1
    print(f"{'ok' if good else 'not ok'} {results} - {name}")


def picture(of):
    """How many pixels of a canvas are painted, and a checksum of all."""
    return browser.run(f"""(() => {{
        const canvas = document.querySelector("{of}"), copy = new OffscreenCanvas(canvas.width, canvas.height);
        const context = copy.getContext("2d", {{willReadFrequently: true}});
        context.drawImage(canvas, 0, 0);
        const all = context.getImageData(0, 0, canvas.width, canvas.height).data;
        let painted = 0, sum = 0;
        for (let i = 0; i < all.length; i += 4) {{
            painted += all[i + 3] > 128;
            sum = (sum * 31 + all[i] + 7 * all[i + 1] + 13 * all[i + 2]) >>> 0;
        }}
        return [painted / canvas.width / canvas.height, sum];
    }})()""")


def wait(seconds):
    browser.run(f"new Promise((done) => setTimeout(done, {1000 * seconds}))")


def looks_right(width, scheme):
    """The page as it stands: it is as wide as the window, no text is cut off, its colours are those of the scheme."""
    return browser.run("""(() => {
        const wide = document.documentElement.scrollWidth <= innerWidth;
        const cut = [...document.querySelectorAll("h1, p, li, b, label, button, output")].filter((e) => e.offsetParent &&
            (e.scrollWidth > e.clientWidth + 1 && getComputedStyle(e).display !== "inline")).map((e) => e.textContent);
        const ground = getComputedStyle(document.body).backgroundColor.match(/\\d+/g).map(Number);
        return [wide, cut, ground[0] + ground[1] + ground[2] > 384 ? "light" : "dark"];
    })()""") == [True, [], scheme]


def play(name):
    """Play moves the mechanism and the cursor of the plots; pause holds both."""
    before, cursor = picture("#scene"), picture("#plots canvas")
    browser.click("#play")
    wait(0.35)
    browser.click("#play")
    time, after, cursor_after = browser.run("state.time"), picture("#scene"), picture("#plots canvas")
    result(time > 0.05 and before[1] != after[1] and cursor[1] != cursor_after[1], f"{name}: play moves the mechanism and the cursor")
    wait(0.1)
    result(browser.run("state.time") == time and picture("#scene")[1] == after[1], f"{name}: pause holds them")
    result(0.005 < after[0] < 0.9, f"{name}: the mechanism fills {100 * after[0]:.0f} % of its canvas")


def steer(name):
    """Scrub, cursor, orbit and zoom."""
    browser.run("""element("scrub").value = 0.5; element("scrub").dispatchEvent(new Event("input"))""")
    result(browser.run("Math.abs(state.time - end / 2) < 1e-9"), f"{name}: scrub goes to a time")
    x, y, width = browser.run("""(() => { const b = document.querySelector("#plots canvas").getBoundingClientRect();
        return [b.x, b.y + b.height / 2, b.width]; })()""")
    browser.drag([(x + width / 2, y)])
    result(browser.run("state.time > 0.2 * end && state.time < 0.8 * end && state.time !== end / 2"),
           f"{name}: a click into a plot goes to its time")
    box = browser.run("""(() => { scrollTo(0, 0); const b = canvas.getBoundingClientRect();
        return [b.x + b.width / 2, b.y + b.height / 2]; })()""")
    before = picture("#scene")[1]
    browser.drag([tuple(box), (box[0] + 60, box[1] + 20)])
    turned = picture("#scene")[1]
    browser.ask("Input.dispatchMouseEvent", type="mouseWheel", x=box[0], y=box[1], deltaX=0, deltaY=-300)
    nearer = picture("#scene")[1]
    browser.click("#reset")
    result(before != turned and turned != nearer and picture("#scene")[1] == before,
           f"{name}: the mouse turns it and brings it nearer, and back")


def corners_of_still(path):
    """The polygons of a still, in pixels: lists of corners, and their colours."""
    with open(path, encoding="utf-8") as file:
        text = file.read()
    polygons = []
    for colour, drawn in re.findall(r"<path color='(#[0-9a-f]{6})' d='([^']*)z'", text):
        numbers = [int(n) for n in re.findall(r"-?\d+", drawn)]
        x, y, corners = 0, 0, []
        for dx, dy in zip(numbers[::2], numbers[1::2]):
            x, y = x + dx, y + dy
            corners.append((x / 10, y / 10))
        polygons.append((colour, corners))
    return polygons


def same_as_still():
    """The polygons that the page draws at the size of a still, at its time."""
    drawn = browser.run("""(() => {
        const camera = new Camera(data.view), time = 0.3;
        camera.aim(runs[0], time, 560, 380);
        return polygonsOf(runs[0], time, camera, data.inks, null).filter((one) => !one.isLine).map((one) =>
            ["#" + one.colour.map((c) => c.toString(16).padStart(2, "0")).join(""), one.points.map((p) => [p[0], p[1]])]);
    })()""")
    still = corners_of_still(folder + "/single.svg")
    # What is a hair thin may be seen by one and not by the other, and what is equally near may change places.
    found = 0
    for colour, corners in still:
        found += any(all(min(abs(x - q[0]) + abs(y - q[1]) for q in points) < 0.35 for x, y in corners)
                     and max(abs(int(colour[i:i + 2], 16) - int(other[i:i + 2], 16)) for i in (1, 3, 5)) <= 2
                     for other, points in drawn)
    result(len(still) > 30 and found >= 0.98 * len(still) and abs(len(drawn) - len(still)) < 0.05 * len(still),
           f"the page draws what a still has: {found} of {len(still)} polygons")


browser = Browser()
try:
    for page in ("single", "several"):
        for width, height in ((400, 900), (1600, 900)):
            for scheme in ("light", "dark"):
                name = f"{page}, {width} px, {scheme}"
                browser.look(width, height, scheme)
                browser.open(f"{folder}/{page}.html")
                result(looks_right(width, scheme), f"{name}: nothing is cut off, colours are those asked for")
                if (width, scheme) in ((400, "dark"), (1600, "light")):
                    play(name)
                if page == "single" and width == 1600 and scheme == "light":
                    steer(name)
                    same_as_still()
        result(not browser.said, f"{page}: the page complains of nothing: {browser.said}")
    before = picture("#scene")
    browser.click("#layout")
    result(picture("#scene")[1] != before[1] and browser.run("state.sideBySide"), "runs stand side by side, or over one another")
    result(browser.run("runs.length === 3 && document.querySelectorAll('#legend li').length === 3"), "all runs are in the legend")
    # A point that is an output, and the same point by the pose of its body, at all frames.
    browser.open(folder + "/single.html")
    apart = browser.run("""(() => {
        const run = runs[0], tip = run.names.indexOf("tip_x");
        let most = 0;
        for (let i = 0; i < run.frames; i++) {
            const p = placed(run.pose(i * run.interval, 1), [0, -1, 0]);
            p.forEach((x, n) => { most = Math.max(most, Math.abs(x - run.column(i * run.interval, tip + n))); });
        }
        return most;
    })()""")
    result(0 <= apart < 2e-6, f"the pose of the lower arm has the tip where the output has it: {apart:.1e} m apart")
    # A run that was kept has no bodies; its curve is drawn, and read at the cursor.
    browser.open(folder + "/kept.html")
    kept = browser.run("""(() => {
        seek(0.5);
        const one = runs[1], first = runs[0], column = first.names.indexOf("tip_x");
        return [one.label, one.bodies, one.names.join() === first.names.join(), one.frames, one.end, moving.join(),
            Math.abs(one.column(0.5, column) - first.column(0.5, column)),
            document.querySelector("#plots figcaption").textContent, document.querySelectorAll("#legend li")[1].textContent];
    })()""")
    result(kept[:6] == ["before", 0, True, 251, 1, "0,2"] and kept[6] < 1e-3 and "kept: its outputs alone" in kept[8],
           f"a run that was kept is in the plots: {kept}")
    before = picture("#scene")
    browser.click("#layout")
    result(picture("#scene")[1] != before[1] and not browser.said, f"side by side stand those that move: {browser.said}")
    browser.said.clear()
    browser.open(folder + "/fault.html")
    result(len(browser.said) > 0, "found: a page with a fault")
finally:
    browser.close()
print(f"1..{results}")
