"""docs/slurm/conform.sbatch asks for the shard that is meant, whichever tasks of its array are submitted. Needs no Slurm."""

import os
import pathlib
import subprocess
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "docs" / "slurm" / "conform.sbatch"


class SlurmScript(unittest.TestCase):
    def task(self, index, least, most, count, **variables):
        """What a task of the array LEAST-MOST calls, with a program that prints its arguments."""
        with tempfile.TemporaryDirectory() as folder:
            program = pathlib.Path(folder, "bin", "ssrkit")
            program.parent.mkdir()
            program.write_text('#!/bin/sh\necho "$@"\n')
            program.chmod(0o755)
            slurm = {"SLURM_ARRAY_TASK_ID": index, "SLURM_ARRAY_TASK_MIN": least, "SLURM_ARRAY_TASK_MAX": most,
                     "SLURM_ARRAY_TASK_COUNT": count, "SLURM_SUBMIT_DIR": folder, "SSRKIT_BUILD": folder}
            environment = {k: v for k, v in os.environ.items() if not k.startswith(("SLURM_", "SSRKIT_"))}
            environment.update({name: str(value) for name, value in {**slurm, **variables}.items()})
            return subprocess.run(["bash", str(SCRIPT)], env=environment, capture_output=True, text=True, timeout=60)

    def test_a_whole_array_counts_itself(self):
        self.assertIn("--shard 3/8 ", self.task(3, 1, 8, 8).stdout)

    def test_one_task_alone_is_told_how_many_there_are(self):
        done = self.task(3, 3, 3, 1, SSRKIT_SHARDS=8)
        self.assertIn("--shard 3/8 ", done.stdout)
        self.assertIn("shard-3", done.stdout)

    def test_one_task_alone_is_refused_without_it(self):
        for least, most, count in ((3, 3, 1), (2, 8, 7), (1, 8, 4)):
            done = self.task(most, least, most, count)
            self.assertEqual(2, done.returncode, done.stdout)
            self.assertIn("SSRKIT_SHARDS=N", done.stderr)
            self.assertEqual("", done.stdout)


if __name__ == "__main__":
    unittest.main()
