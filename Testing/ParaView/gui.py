"""The real ParaView window on a display of its own: python3 gui.py PARAVIEW FOLDER (script|menus)

Runs gui_script.py in it, or clicks what gui_menus.xml says, and leaves a picture of the whole screen in
FOLDER/window.png. Fails if the script or a click did, or if the screen stayed empty. PLUGIN and NOSECONE name
the plugin and the surface.
"""
import os
import re
import struct
import subprocess
import sys
import time
import zlib

SCREEN = "1600x1000x24"
START_LIMIT = 200  # seconds
SETTLE = 6  # seconds until panels are laid out and painted


def read_screen(path):
    """Rows of RGB bytes of a screen that Xvfb keeps in a file, in the format of xwd."""
    with open(path, "rb") as file:
        content = file.read()
    header = struct.unpack(">25I", content[:100])
    size, width, height, line, colors = header[0], header[4], header[5], header[12], header[19]
    start = size + 12 * colors
    rows = []
    for y in range(height):
        row = content[start + y * line:start + y * line + 4 * width]
        rgb = bytearray(3 * width)
        rgb[0::3], rgb[1::3], rgb[2::3] = row[2::4], row[1::4], row[0::4]
        rows.append(bytes(rgb))
    return width, height, rows


def write_png(path, width, height, rows):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    pixels = zlib.compress(b"".join(b"\0" + row for row in rows))
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">2I5B", width, height, 8, 2, 0, 0, 0)) +
                   chunk(b"IDAT", pixels) + chunk(b"IEND", b""))


def said(folder):
    """What ParaView has written so far."""
    with open(os.path.join(folder, "output.txt"), encoding="utf-8", errors="replace") as file:
        return file.read()


def wait_for_end(process, folder):
    for _ in range(2 * START_LIMIT):
        if "is finished. Success" in said(folder):
            return "done" if re.search(r"Success =\s+true", said(folder)) else "failed", said(folder)
        for marker in ("done", "failed"):
            path = os.path.join(folder, marker)
            if os.path.exists(path):
                with open(path, encoding="utf-8") as file:
                    return marker, file.read()
        if process.poll() is not None:
            return "failed", f"paraview ended with status {process.returncode}"
        time.sleep(0.5)
    return "failed", "paraview's script did not come to its end"


def start(program, folder, what):
    number_read, number_write = os.pipe()
    server = subprocess.Popen(["Xvfb", "-displayfd", str(number_write), "-screen", "0", SCREEN, "-fbdir", folder,
                               "-nolisten", "tcp"], pass_fds=[number_write], stderr=subprocess.DEVNULL)
    os.close(number_write)
    display = os.read(number_read, 16).decode().strip()
    own = os.path.dirname(os.path.abspath(__file__))
    # A home of its own: no settings of the user's, and no window that greets.
    environment = dict(os.environ, DISPLAY=f":{display}", GUI_FOLDER=folder, HOME=folder)
    if what == "menus":
        environment["PV_PLUGIN_PATH"] = os.path.dirname(environment["PLUGIN"])
        options = [f"--data={environment['NOSECONE']}", f"--test-script={own}/gui_menus.xml"]
    else:
        options = [f"--script={own}/gui_script.py"]
    with open(os.path.join(folder, "output.txt"), "w", encoding="utf-8") as output:
        return server, subprocess.Popen([program, "--dr", *options, "-qwindowgeometry", "1600x1000+0+0"],
                                        env=environment, stdout=output, stderr=output)


def main(program, folder, what):
    for name in ("done", "failed", "window.png"):
        if os.path.exists(os.path.join(folder, name)):
            os.remove(os.path.join(folder, name))
    server, paraview = start(program, folder, what)
    try:
        marker, text = wait_for_end(paraview, folder)
        time.sleep(SETTLE)
        width, height, rows = read_screen(os.path.join(folder, "Xvfb_screen0"))
        write_png(os.path.join(folder, "window.png"), width, height, rows)
    finally:
        paraview.kill()
        paraview.wait()
        server.terminate()
        server.wait()
    print(text)
    if len(set(rows)) < height // 4:
        print("the screen is empty")
        return 1
    return 0 if marker == "done" else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
