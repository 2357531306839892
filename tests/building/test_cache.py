"""The cache: what is damaged heals, what is not ours is refused, what is left behind goes."""

import errno
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import pytest

import eigenmotion as em
from eigenmotion.building import cache
from eigenmotion.building.toolchain import EXTENSION_SUFFIX
from eigenmotion.cli import main

PENDULUM = Path(__file__).parents[2] / "models" / "pendulum.py"
KEY = cache.key("something")


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    monkeypatch.setenv("EIGENMOTION_CACHE", str(tmp_path / "cache"))
    return tmp_path / "cache"


def fill(folder):
    (folder / "text").write_text("as it was made")


def made():
    return cache.entry("things", KEY, fill)


def truncate(entry):
    with (entry / "text").open("r+") as file:
        file.truncate(3)


def replace_by_a_file(entry):
    entry.rename(entry.with_name("elsewhere"))
    entry.write_text("")


DAMAGES = {
    "empty file": lambda entry: (entry / "text").write_text(""),
    "truncated": truncate,
    "another text": lambda entry: (entry / "text").write_text("as it is not made"),
    "bytes": lambda entry: (entry / "text").write_bytes(b"\xff"),
    "missing": lambda entry: (entry / "text").unlink(),
    "no sums": lambda entry: (entry / "sums").unlink(),
    "empty sums": lambda entry: (entry / "sums").write_text(""),
    "nothing in it": lambda entry: [file.unlink() for file in entry.iterdir()],
    "a folder for a file": lambda entry: [(entry / "text").unlink(), (entry / "text").mkdir()],
    "one file more": lambda entry: (entry / "more").write_text(""),
    "a file": replace_by_a_file,
    "a dangling link": lambda entry: [entry.rename(entry.with_name("elsewhere")), entry.symlink_to("nowhere")],
    "open to others": lambda entry: entry.chmod(0o777),
    "unreadable": lambda entry: [(entry / "sums").write_text("not to be read"), entry.chmod(0)],
}


@pytest.mark.parametrize("damage", DAMAGES.values(), ids=DAMAGES)
def test_what_is_damaged_is_made_anew(damage):
    entry = made()
    damage(entry)
    assert made() == entry
    assert (entry / "text").read_text() == "as it was made"
    assert sorted(file.name for file in entry.iterdir()) == ["sums", "text"]
    assert entry.stat().st_mode & 0o777 == 0o700
    assert not list(entry.parent.glob(".*"))


DAMAGED = """
import os, sys
from pathlib import Path
import eigenmotion as em
import eigenmotion.building.verification, eigenmotion.codegen.compiler # once for all

def in_another_process():
    inside = os.fork()
    if not inside:
        print(em.build(sys.argv[1]).simulate((0.0, 1.0)).y[0, -1], flush=True)
        os._exit(0)
    assert os.waitpid(inside, 0)[1] == 0

in_another_process()
(binary,) = Path(os.environ["EIGENMOTION_CACHE"]).glob(f"binaries/*/*{sys.argv[2]}")
content = binary.read_bytes()
for damaged in (b"", content[: len(content) // 3], b"no module"):
    binary.write_bytes(damaged)
    in_another_process()
    assert binary.read_bytes()[:4] == content[:4], damaged[:9]
"""


@pytest.mark.usefixtures("hurried")
def test_a_damaged_module_never_kills_python(folder):
    """Each in a process of its own, for what has been loaded once would stay loaded."""
    command = [sys.executable, "-c", DAMAGED, PENDULUM, EXTENSION_SUFFIX]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    right, *others = map(float, done.stdout.split())
    assert others == [right] * 3


def test_a_module_that_cannot_be_loaded_is_named(tmp_path):
    (tmp_path / f"broken{EXTENSION_SUFFIX}").write_bytes(b"no module")
    with pytest.raises(em.BuildError, match=r"broken.* cannot be loaded.*\$EIGENMOTION_CACHE"):
        em.build.__globals__["load"](tmp_path / f"broken{EXTENSION_SUFFIX}")


def test_it_is_private(folder):
    made()
    for place in (folder, folder / "things", folder / "things" / KEY, folder / "locks"):
        assert place.stat().st_mode & 0o777 == 0o700


@pytest.mark.parametrize("inner", ["", "things"])
def test_one_that_others_can_write_to_is_refused(folder, inner):
    made()
    (folder / inner).chmod(0o770)
    with pytest.raises(em.BuildError, match=r"can be written to by others.*chmod go-w.*\$EIGENMOTION_CACHE") as caught:
        made()
    assert str(folder / inner) in str(caught.value)


@pytest.mark.skipif(os.geteuid() != 0, reason="only root gives files away")
def test_one_of_somebody_else_is_refused(folder):
    made()
    os.chown(folder / "things" / KEY, 12345, -1)
    assert made().stat().st_uid == 0
    os.chown(folder, 12345, -1)
    with pytest.raises(em.BuildError, match="belongs to somebody else"):
        made()


@pytest.mark.skipif(os.geteuid() != 0, reason="needs another user to be")
@pytest.mark.parametrize("rights", [0o500, 0o000])
def test_one_without_rights_serves_what_it_has_and_names_what_it_lacks(rights, monkeypatch):
    """As a user who is not root: root may write everywhere."""
    with tempfile.TemporaryDirectory() as place:
        Path(place).chmod(0o755)
        folder = Path(place) / "cache"
        monkeypatch.setenv("EIGENMOTION_CACHE", str(folder))
        assert of_a_user(folder, rights) == ["True" if rights else "named", "named"]


def of_a_user(folder, rights):
    script = (
        "import os; from eigenmotion.building import cache; from eigenmotion.building.errors import BuildError\n"
        "os.setgid(12345); os.setuid(12345)\n"
        "def fill(folder): (folder / 'text').write_text('x')\n"
        "for name in (cache.key('there'), cache.key('not there')):\n"
        "    try: print(cache.entry('things', name, fill).is_dir())\n"
        "    except BuildError as error: print('EIGENMOTION_CACHE' in str(error) and 'named')\n"
    )
    cache.entry("things", cache.key("there"), fill)
    for place in (folder, *folder.rglob("*")):
        os.chown(place, 12345, 12345)
    places = [folder, *(place for place in folder.iterdir() if place.is_dir())]
    for place in reversed(places):
        place.chmod(rights)
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=False)
    for place in places:
        place.chmod(0o700)
    assert done.returncode == 0, done.stderr
    return done.stdout.split()


def test_a_full_one_is_named_with_the_remedy(folder):
    def full(folder):
        raise OSError(errno.ENOSPC, "No space left on device")

    with pytest.raises(em.BuildError, match=r"No space left.*eigenmotion cache.*\$EIGENMOTION_CACHE"):
        cache.entry("things", KEY, full)
    assert not list((folder / "things").iterdir())


@pytest.mark.parametrize("place", ["", "things", "locks"])
def test_a_file_in_place_of_a_folder_is_named(folder, place):
    (folder / place).parent.mkdir(parents=True, exist_ok=True)
    (folder / place).write_text("")
    folder.is_dir() and folder.chmod(0o700)
    with pytest.raises(em.BuildError, match="EIGENMOTION_CACHE"):
        made()


def test_a_home_of_nobody_is_named(monkeypatch):
    monkeypatch.setenv("EIGENMOTION_CACHE", "~nobody-of-this-name/cache")
    with pytest.raises(em.BuildError, match="nobody-of-this-name"):
        made()


def test_what_killed_builds_left_behind_goes_and_what_is_under_way_stays(folder):
    started = folder.parent / "started"
    script = (
        "from eigenmotion.building import cache; from pathlib import Path; import time\n"
        f"def fill(folder): (folder / 'half').write_text(''); Path({str(started)!r}).touch(); time.sleep(60)\n"
        f"cache.entry('things', {cache.key('slow')!r}, fill)\n"
    )
    builder = subprocess.Popen([sys.executable, "-c", script])
    try:
        while not started.exists():
            assert builder.poll() is None
            time.sleep(0.01)
        (at_work,) = (folder / "things").iterdir()
        made()
        assert at_work.is_dir()
    finally:
        builder.kill()
        builder.wait()
    assert at_work.is_dir()
    cache.entry("things", cache.key("another"), fill)
    assert not at_work.exists()


def test_the_command_shows_and_clears_it(folder, capsys):
    made()
    keep = folder / "things" / "not ours"
    keep.write_text("")
    (folder / "things" / f".{KEY}.01234567").mkdir()
    assert main(["cache"]) == 0
    said = capsys.readouterr().out
    assert said.splitlines()[0] == str(folder)
    assert "things" in said
    assert "1 entry" in said
    assert main(["cache", "--clear"]) == 0
    assert "1 entry" in capsys.readouterr().out
    assert [file.name for file in (folder / "things").iterdir()] == ["not ours"]
    assert made().is_dir()


def test_the_command_without_a_cache(folder, capsys):
    assert main(["cache"]) == 0
    assert capsys.readouterr().out.startswith(f"{folder}\n")
    assert main(["cache", "--clear"]) == 0
    assert not folder.exists()


@pytest.mark.parametrize("whose", ["somebody else's", "open to others", "a link"])
def test_a_file_that_is_not_ours_alone_is_made_anew_and_never_loaded(monkeypatch, whose):
    """Its folder was looked at alone, and the library in it loaded, whoever it belonged to."""
    entry = made()
    text, real = entry / "text", os.stat

    def stat(path, *given, **named):
        found = real(path, *given, **named)
        if whose == "somebody else's" and os.fspath(path) == os.fspath(text) and found.st_ino == ours.st_ino:
            return os.stat_result((*found[:4], os.geteuid() + 4321, *found[5:]))
        return found

    ours = real(text)
    if whose == "open to others":
        text.chmod(0o666)
    if whose == "a link":
        text.rename(entry.parent / "elsewhere")
        text.symlink_to(entry.parent / "elsewhere")
    monkeypatch.setattr(os, "stat", stat)
    filled = []
    cache.entry("things", KEY, lambda folder: (filled.append(folder), fill(folder)))
    assert filled
    assert not text.is_symlink()
    assert text.stat().st_mode & 0o022 == 0
    cache.entry("things", KEY, filled.append)
    assert len(filled) == 1


def test_what_a_umask_lets_others_write_is_ours_alone(monkeypatch):
    before = os.umask(0o002)
    try:
        entry = made()
    finally:
        os.umask(before)
    assert not [file for file in entry.iterdir() if file.stat().st_mode & 0o022]
    assert cache.entry("things", KEY, lambda folder: pytest.fail("made anew")) == entry
