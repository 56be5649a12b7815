#pragma once

/// Kills runs with checkpoints at random times, `kills` times in all, and resumes them, until they
/// end by themselves; checks that each then has the results of the unbroken run.
void check_kills(int kills);
