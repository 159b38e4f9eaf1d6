#!/usr/bin/env python3
# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""`run --live`: the page while a run works and when it ends, in a real browser."""

import json
import os
import re
import shutil
import signal
import socket
import tempfile
import unittest
import urllib.error
import urllib.request

import browser
from program import REPEATABLE_FILES, RUN_FILES, ProgramTest, main, read
from ring import simulate_ring

OPENER = urllib.request.build_opener(urllib.request.ProxyHandler({}))


class LiveTest(ProgramTest):

    @classmethod
    def setUpClass(cls):
        cls.work = tempfile.mkdtemp(prefix="semantic_kiss_")
        cls.addClassCleanup(shutil.rmtree, cls.work)
        # Farther round than a browser takes to start and look a few times.
        simulate_ring(cls.work, ring_m=150., length_m=300., scan_rate_hz=10.)

    def start_live(self, *flags):
        """A run with a page; returns the process and the page's address."""
        process = self.start("run", "--config=semantic_kiss_6dof.lua", f"--dataset={self.work}",
                             f"--output={self.path('out')}", "--quiet", "--live", *flags)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.stderr.close)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        first = process.stderr.readline()
        address = re.fullmatch(r"live at (http://127\.0\.0\.1:(\d+)/)\n", first)
        self.assertIsNotNone(address, first)
        return process, address.group(1), int(address.group(2))

    def status(self, url, method="GET", **headers):
        request = urllib.request.Request(url, method=method, headers=headers)
        try:
            with OPENER.open(request, timeout=20) as answer:
                return answer.status
        except urllib.error.HTTPError as error:
            return error.code

    def test_can_only_be_read_and_only_from_here(self):
        process, url, port = self.start_live("--threads=1")
        self.assertEqual(self.status(url), 200)
        for method in ("POST", "PUT", "DELETE", "PATCH"):
            self.assertEqual(self.status(url, method), 405, method)
        self.assertEqual(self.status(url, Host=f"elsewhere.example:{port}"), 403)
        # All listening sockets of that port: the addresses are in hexadecimal, little endian.
        with open("/proc/net/tcp") as file:
            listening = [line.split()[1] for line in file if line.split()[3] == "0A"]
        own = [address for address in listening if address.endswith(f":{port:04X}")]
        self.assertEqual(own, [f"0100007F:{port:04X}"])
        if os.path.exists("/proc/net/tcp6"):
            with open("/proc/net/tcp6") as file:
                self.assertNotRegex(file.read(), rf":{port:04X} \S+ 0A ")
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130)
        self.assertEqual(sorted(os.listdir(self.path("out"))), RUN_FILES)
        with self.assertRaises(OSError):
            socket.create_connection(("127.0.0.1", port), timeout=5)

    def test_changes_no_result(self):
        few = (f"--dataset={self.work}", "--num_scans=150", "--quiet")
        self.succeed("run", *few, f"--output={self.path('plain')}")
        process = self.start("run", *few, "--live", f"--output={self.path('looked_at')}")
        url = process.stderr.readline().split()[-1]
        looks = 0
        while process.poll() is None:
            try:
                with OPENER.open(url + "state.json", timeout=20) as answer:
                    looks += json.load(answer)["snapshot"] is not None
            except OSError:
                pass  # it has just ended
            except json.JSONDecodeError:
                pass
        process.communicate()
        self.assertEqual(process.returncode, 0)
        self.assertGreater(looks, 0)
        for name in REPEATABLE_FILES:
            self.assertEqual(read(self.path("plain"), name), read(self.path("looked_at"), name), name)

    def test_ports_must_be_free_and_possible(self):
        flags = ("--dataset=" + self.work, f"--output={self.path('out')}", "--quiet")
        self.fail_with(2, ["--live=70000", "at most 65535"], "run", *flags, "--live=70000")
        self.fail_with(2, ["--live"], "run", *flags, "--live=-1")
        with socket.create_server(("127.0.0.1", 0)) as taken:
            port = taken.getsockname()[1]
            self.fail_with(1, ["--live", f"port {port}"], "run", *flags, f"--live={port}")

    @unittest.skipIf(browser.missing(),
                     f"{browser.missing()} is not installed: scripts/setup.sh --test")
    def test_the_page_follows_the_run_to_its_report(self):
        with browser.opened() as window:
            process, url, _ = self.start_live()
            window.emulate()
            window.visit(url)
            scans = ("[...document.querySelectorAll('.figure')].filter((figure) => "
                     "figure.innerText.startsWith('Scans')).map((figure) => "
                     "Number(figure.querySelector('b').innerText))[0]")
            window.wait_until(f"{scans} > 0")
            before = window.run(f"return {scans}")
            window.wait_until(f"{scans} > {before}")
            window.wait_until("document.querySelector('.leaflet-image-layer')?.naturalWidth > 100")
            self.assertIsNone(process.poll(), "the run ended before it was looked at")
            for words in ("Time left", "Loop closures", "Memory", "registration", "converged"):
                self.assertIn(words, window.run("return document.body.innerText"))
            window.wait_until("!document.querySelector('#end').hidden", within_s=120)
            self.assertIn("has ended", window.run("return document.body.innerText"))
            _, problem = process.communicate(timeout=60)
            self.assertEqual((process.returncode, problem), (0, ""))
            # The program is gone, its report is here.
            window.run("document.querySelector('#open-report').click()")
            window.wait_until("document.querySelectorAll('.plot svg').length == 6")
            window.wait_until("document.querySelector('#closures')?.innerText.includes('score')")
            self.assertEqual(window.log(), [])


if __name__ == "__main__":
    main()
