# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""The grid of a benchmark: which cells there are, and which drive each of them needs.

A cell is a system on a sequence with a seed. Pure functions of the settings (settings.yaml, and
what the command line changed): nothing here looks at files.
"""

import dataclasses


class SettingsError(Exception):
    """The settings are contradictory; the message is one line and says what to change."""


@dataclasses.dataclass(frozen=True)
class System:
    """A row of the tables: a configuration, and the labels that it is given."""
    name: str
    config: str
    title: str
    ours: bool = False
    closes_loops: bool = False
    ablation: bool = False
    label_noise: float | None = None  # None: as the settings have it for all
    labels_dir: str = ""  # "": the drive's own
    same_as: str = ""  # the system whose cells these are; "": its own


@dataclasses.dataclass(frozen=True)
class Drive:
    """A simulated drive. Drives that differ in label_noise alone have equal point clouds."""
    sequence: str
    seed: int
    label_noise: float

    @property
    def folder(self):
        return f"drives/noise_{self.label_noise:g}/seed_{self.seed}/sequences/{self.sequence}"


@dataclasses.dataclass(frozen=True)
class Cell:
    """A run. Seeds count from 0; sequences of a data set have no other."""
    system: str
    sequence: str
    seed: int

    @property
    def folder(self):
        return f"runs/{self.system}/{self.sequence}/{self.seed}"


def sequence_name(sequence):
    """"7" and 7 are sequence "07", as KITTI has it; other names stay."""
    text = str(sequence)
    return text.zfill(2) if text.isdigit() else text


def _system(name, entry, ablation):
    unknown = set(entry) - {field.name for field in dataclasses.fields(System)}
    if unknown:
        raise SettingsError(f"{name}: {', '.join(sorted(unknown))} is no key of a system")
    if ("config" in entry) == ("same_as" in entry):
        raise SettingsError(f"{name}: needs either config or same_as")
    return System(name=name, ablation=ablation, **{"title": name, "config": "", **entry})


def systems(settings):
    """All rows by name, ablations last."""
    rows = {}
    for key, ablation in (("systems", False), ("ablations", True)):
        for name, entry in (settings.get(key) or {}).items():
            if name in rows:
                raise SettingsError(f"{name} is the name of a system and of an ablation")
            rows[name] = _system(name, entry, ablation)
            if rows[name].same_as and rows[name].same_as not in settings["systems"]:
                raise SettingsError(f"{name}: there is no system {rows[name].same_as}")
    return rows


def _chosen(rows, names, ablation):
    """The rows of one kind that the command line wants: all if it names none."""
    there = [row.name for row in rows.values() if row.ablation == ablation]
    unknown = [name for name in names or [] if name not in there]
    if unknown:
        raise SettingsError(f"there is no {unknown[0]}; there are {', '.join(there)}")
    return [rows[name] for name in (there if names is None else names)]


def single_cell(text):
    """The cell that SYSTEM/SEQUENCE or SYSTEM/SEQUENCE/SEED names."""
    words = text.split("/")
    if len(words) not in (2, 3) or not all(words) or not words[-1].isalnum():
        raise SettingsError(f"{text} is no cell; write SYSTEM/SEQUENCE or SYSTEM/SEQUENCE/SEED")
    return Cell(words[0], sequence_name(words[1]), int(words[2]) if len(words) == 3 else 0)


def cells(settings):
    """All cells, sequence by sequence, so that a drive can go as soon as possible."""
    rows, only = systems(settings), settings.get("only") or {}
    if only.get("cell"):
        cell = single_cell(only["cell"])
        if cell.system not in rows:
            raise SettingsError(f"there is no {cell.system}; there are {', '.join(rows)}")
        return [cell]
    wanted = (_chosen(rows, only.get("systems"), False) + _chosen(rows, only.get("ablations"), True))
    wide = [sequence_name(s) for s in settings["sequences"]]
    narrow = [sequence_name(s) for s in settings.get("ablation_sequences") or []]
    simulated = bool(settings.get("poses"))
    return list(dict.fromkeys(
        Cell(row.same_as or row.name, sequence, seed)
        for sequence in dict.fromkeys(wide + narrow)
        for seed in range(int(settings["seeds"]))
        for row in wanted
        if sequence in (narrow if row.ablation else wide)
        and (simulated or row.label_noise is None)))


def drive(settings, cell):
    """The simulated drive that a cell needs."""
    noise = systems(settings)[cell.system].label_noise
    if noise is None:
        noise = settings["simulation"]["label_noise"]
    return Drive(cell.sequence, cell.seed, float(noise))


def ready_made(settings, wanted):
    """Whether the drive lies ready in the folder `drives` of the settings."""
    return (wanted.sequence in settings.get("ready_sequences", []) and wanted.seed == 0
            and wanted.label_noise == settings["simulation"]["label_noise"])


def drives_to_simulate(settings):
    """Drives in the order in which they are simulated."""
    wanted = dict.fromkeys(drive(settings, cell) for cell in cells(settings))
    return [one for one in wanted if not ready_made(settings, one)]


def cells_before(settings, wanted):
    """The cells that have to be done before a drive may be simulated, lest too many drives stand
    on the disk: those of the drive that comes `standing_drives` earlier."""
    order = drives_to_simulate(settings)
    earlier = order.index(wanted) - int(settings["standing_drives"])
    if earlier < 0:
        return []
    return [cell for cell in cells(settings) if drive(settings, cell) == order[earlier]]


def num_scans(settings, sequence):
    """How many scans of a sequence are used; None: all."""
    limit = settings.get("num_scans")
    if isinstance(limit, dict):
        limit = {sequence_name(key): value for key, value in limit.items()}.get(sequence)
    return int(limit) if limit else None
