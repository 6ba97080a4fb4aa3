"""A Slurm job array gives what one run gives. Not part of ./ssrkit test: it needs Debian's slurm-wlm and munge, and root.

    SSRKIT_PROGRAM=build/release/bin/ssrkit python3 tests/slurm/slurm_test.py

Starts a Slurm of one node on the loopback interface (munged, slurmctld, slurmd), submits docs/slurm/conform.sbatch as an
array of three tasks with sbatch --wait, merges the shards, and compares with one run and with three processes."""

import json
import os
import pathlib
import shutil
import socket
import subprocess
import sys
import tempfile
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = pathlib.Path(os.environ.get("SSRKIT_PROGRAM", "")).resolve()
NEEDED = ("munged", "mungekey", "slurmctld", "slurmd", "sbatch", "scontrol")
SELECTION = ["--device", "gl-osmesa", "--device", "vk-lavapipe", "--filter", "*/33x17"]
PATIENCE_S = 600


def tool(name):
    return shutil.which(name, path=os.environ["PATH"] + ":/usr/sbin:/sbin")


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def configuration(folder, host, processors):
    return f"""ClusterName=ssrkit
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={free_port()}
SlurmdPort={free_port()}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
CredType=cred/munge
SlurmUser=root
SlurmdUser=root
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
MpiDefault=none
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
NodeName={host} NodeAddr=127.0.0.1 CPUs={processors} RealMemory=4000 State=UNKNOWN
PartitionName=all Nodes={host} Default=YES MaxTime=INFINITE State=UP
"""


class OneNode:
    """A Slurm that lives as long as the test."""

    def __init__(self, folder):
        self.folder = folder
        self.processes = []
        self.environment = dict(os.environ, SLURM_CONF=f"{folder}/slurm.conf")
        # Plain names only: Slurm matches its configuration against the host's own.
        self.host = socket.gethostname().split(".")[0]
        for name in ("state", "spool"):
            os.mkdir(folder / name)
        (folder / "slurm.conf").write_text(configuration(folder, self.host, os.cpu_count() or 1))

    def start(self):
        key = self.folder / "munge.key"
        subprocess.run([tool("mungekey"), "--create", f"--keyfile={key}"], check=True)
        self.launch("munged", "--foreground", "--force", f"--socket={self.folder}/munge.socket", f"--key-file={key}",
                    f"--log-file={self.folder}/munged.log", f"--pid-file={self.folder}/munged.pid",
                    f"--seed-file={self.folder}/munged.seed")
        self.wait(lambda: (self.folder / "munge.socket").exists(), "munged")
        self.launch("slurmctld", "-D", "-i")
        self.launch("slurmd", "-D", "-N", self.host)
        self.wait(lambda: "State=IDLE" in self.run("scontrol", "show", "node", check=False).stdout, "the node")

    def launch(self, name, *arguments):
        with open(self.folder / f"{name}.out", "wb") as output:
            self.processes.append(subprocess.Popen([tool(name), *arguments], env=self.environment,
                                                   stdin=subprocess.DEVNULL, stdout=output, stderr=output))

    def wait(self, is_so, what):
        deadline = time.monotonic() + 60
        while not is_so():
            if time.monotonic() > deadline:
                logs = [path.read_text(errors="replace")[-2000:] for path in self.folder.glob("*.log")]
                raise RuntimeError(f"{what} never came\n" + "\n---\n".join(logs))
            time.sleep(0.2)

    def run(self, name, *arguments, check=True, **variables):
        return subprocess.run([tool(name), *arguments], env=dict(self.environment, **variables), check=check, cwd=ROOT,
                              capture_output=True, text=True, timeout=PATIENCE_S)

    def stop(self):
        for process in reversed(self.processes):
            process.terminate()
        for process in self.processes:
            try:
                process.wait(timeout=20)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()


def conform(*arguments):
    return subprocess.run([PROGRAM, "conform", *map(str, arguments)], cwd=ROOT, capture_output=True, text=True,
                          timeout=PATIENCE_S)


def checks(folder):
    """The checks of a results.json as bytes."""
    return json.dumps(json.loads((folder / "results.json").read_text())["checks"]).encode()


class JobArray(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="ssrkit-slurm-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        self.slurm = OneNode(self.folder)
        self.addCleanup(self.slurm.stop)
        self.slurm.start()

    def submit(self, out):
        return self.slurm.run("sbatch", "--wait", "--array=1-3", f"--output={self.folder}/task-%a.log",
                              str(ROOT / "docs" / "slurm" / "conform.sbatch"), *SELECTION, check=False,
                              SSRKIT_BUILD=str(PROGRAM.parents[1]), SSRKIT_OUT=str(out))

    def test_equals_one_run_and_three_processes(self):
        whole = conform(*SELECTION, "--out", self.folder / "whole")
        self.assertEqual(0, whole.returncode, whole.stdout + whole.stderr)
        for index in (1, 2, 3):
            conform(*SELECTION, "--shard", f"{index}/3", "--out", self.folder / f"process-{index}")
        array = self.submit(self.folder / "array")
        logs = "\n".join(path.read_text() for path in sorted(self.folder.glob("task-*.log")))
        self.assertEqual(0, array.returncode, array.stdout + array.stderr + logs)
        for name in ("process", "array/shard"):
            out = self.folder / ("merged-" + name.split("/")[0])
            merged = conform("merge", *(self.folder / f"{name}-{index}" for index in (1, 2, 3)), "--out", out)
            self.assertEqual(0, merged.returncode, merged.stdout + merged.stderr)
            self.assertEqual(whole.stdout.splitlines()[-1], merged.stdout.splitlines()[-1])
            self.assertEqual(checks(self.folder / "whole"), checks(out), name)

    def test_a_second_submission_does_nothing_again(self):
        self.submit(self.folder / "array")
        cells = sorted((self.folder / "array").rglob("cells/**/*.json"))
        self.assertGreater(len(cells), 10)
        before = [cell.stat().st_mtime_ns for cell in cells]
        self.assertEqual(0, self.submit(self.folder / "array").returncode)
        self.assertEqual(before, [cell.stat().st_mtime_ns for cell in cells])


if __name__ == "__main__":
    missing = [name for name in NEEDED if tool(name) is None]
    if missing or not PROGRAM.is_file() or os.geteuid() != 0:
        sys.exit("needs root, SSRKIT_PROGRAM, and Debian's slurm-wlm and munge" + (f": no {missing}" if missing else ""))
    unittest.main(verbosity=2)
