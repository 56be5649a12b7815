"""Bodies from finite-element meshes, reduced to modes."""

from . import _spoke
from ._simulation import read_scenario


def reduce(scenario, *, set=None, force=False):
    """Reduces the solids of a scenario to modes: a list of SolidReduction, one a body.

    scenario, set: as of read_scenario(). Of a file, meshes are relative to its folder; of a text or
        a dictionary, to the working directory.
    force: whether all is made anew, even if it is in the cache (docs/scenario.md).

    Raises InputError if the scenario is not valid, or if the machine lacks the memory.
    """
    return _spoke._reduce(read_scenario(scenario, set), force)
