"""Films from pictures: GIF by Pillow, MP4 by ffmpeg."""

import io
import shutil
import subprocess

from .files import stop


def write_gif(pictures, file, rate):
    try:
        from PIL import Image
    except ImportError:
        stop("a GIF needs Pillow: install python3-pil, or write a film.mp4")
    images = [Image.open(io.BytesIO(picture)).convert("P", palette=Image.ADAPTIVE)
              for picture in pictures]
    images[0].save(file, save_all=True, append_images=images[1:],
                   duration=round(1000 / rate), loop=0, optimize=True)
    return len(images)


def write_mp4(pictures, file, rate):
    if shutil.which("ffmpeg") is None:
        stop("an MP4 needs ffmpeg: install it, or write a film.gif")
    command = ["ffmpeg", "-y", "-loglevel", "error", "-f", "image2pipe", "-framerate",
               str(rate), "-c:v", "png", "-i", "-", "-pix_fmt", "yuv420p",
               "-movflags", "+faststart", str(file)]
    n = 0
    with subprocess.Popen(command, stdin=subprocess.PIPE) as encoder:
        for picture in pictures:
            encoder.stdin.write(picture)
            n += 1
        encoder.stdin.close()
        if encoder.wait() != 0:
            stop(f"ffmpeg did not write {file}")
    return n


def write_film(pictures, file, rate):
    """Writes a film of the kind that the ending of the file names; returns the
    number of its frames."""
    writers = {".gif": write_gif, ".mp4": write_mp4}
    if file.suffix not in writers:
        stop(f"{file} has no known ending; films are .gif or .mp4")
    return writers[file.suffix](pictures, file, rate)
