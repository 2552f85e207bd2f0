# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""A Slurm cluster of two nodes on this host, for tests: munged, slurmctld and two slurmd of their
own."""
import getpass
import os
import pathlib
import secrets
import shutil
import socket
import subprocess
import time

PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch")
SBIN = "/usr/sbin"
WITHIN = 60  # [s]
CONFIGURATION = """
ClusterName=slam_test
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={ports[0]}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
CredType=cred/munge
SlurmUser={user}
SlurmdUser={user}
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/%n.pid
SlurmdSpoolDir={folder}/%n
StateSaveLocation={folder}/state
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
JobAcctGatherType=jobacct_gather/none
ReturnToService=2
SchedulerParameters=sched_interval=1
NodeName=one NodeHostname={host} NodeAddr=127.0.0.1 Port={ports[1]} CPUs=1 RealMemory=3000
NodeName=two NodeHostname={host} NodeAddr=127.0.0.1 Port={ports[2]} CPUs=1 RealMemory=3000
PartitionName=all Nodes=one,two Default=YES MaxTime=INFINITE State=UP
"""


def missing():
    """The programs that are not there."""
    path = os.pathsep.join([os.environ.get("PATH", ""), SBIN])
    return [name for name in PROGRAMS if shutil.which(name, path=path) is None]


def free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    for each in sockets:
        each.bind(("", 0))
    ports = [each.getsockname()[1] for each in sockets]
    for each in sockets:
        each.close()
    return ports


class Cluster:
    """Runs from construction to close(). environment: what its clients need."""

    def __init__(self, folder):
        self._folder = pathlib.Path(folder)
        self._folder.chmod(0o755)  # munged wants to know who can reach its socket
        (self._folder / "state").mkdir()
        self._processes = []
        configuration = self._folder / "slurm.conf"
        configuration.write_text(CONFIGURATION.format(
            folder=self._folder, host=socket.gethostname().split(".")[0], user=getpass.getuser(),
            ports=free_ports(3)), encoding="utf-8")
        self.environment = {**os.environ, "SLURM_CONF": str(configuration)}
        self.environment["PATH"] = os.pathsep.join([self.environment["PATH"], SBIN])
        try:
            self._start_all()
        except BaseException:
            self.close()
            raise

    def _start(self, name, *command):
        log = open(self._folder / f"{name}.out", "wb")
        self._processes.append(subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=log,
                                                stderr=subprocess.STDOUT, env=self.environment))
        log.close()

    def _start_all(self):
        key = self._folder / "munge.key"
        key.write_bytes(secrets.token_bytes(128))
        key.chmod(0o400)
        socket_path = self._folder / "munge.socket"
        self._start("munged", "munged", "--foreground", "--force", f"--key-file={key}",
                    f"--socket={socket_path}", f"--pid-file={self._folder}/munged.pid",
                    f"--log-file={self._folder}/munged.log",
                    f"--seed-file={self._folder}/munged.seed")
        self._wait_for(socket_path.exists, "munged")
        self._start("slurmctld", "slurmctld", "-D")
        for node in ("one", "two"):
            self._start(node, "slurmd", "-D", "-N", node)
        self._wait_for(lambda: self.said("sinfo", "-h", "-t", "idle", "-o", "%D").strip() == "2",
                       "two idle nodes")

    def _wait_for(self, condition, what):
        limit = time.monotonic() + WITHIN
        while not condition():
            if time.monotonic() > limit:
                logs = "".join(f"\n{path.name}: {path.read_text(errors='replace')[-600:]}"
                               for path in sorted(self._folder.glob("*.out")))
                raise RuntimeError(f"no {what} within {WITHIN} s{logs}")
            time.sleep(0.2)

    def said(self, *command):
        """What a command of Slurm prints."""
        return subprocess.run(command, env=self.environment, stdout=subprocess.PIPE,
                              stderr=subprocess.DEVNULL, text=True, check=False).stdout

    def close(self):
        """Ends the daemons, the last one first."""
        for process in reversed(self._processes):
            process.terminate()
            try:
                process.wait(10)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
