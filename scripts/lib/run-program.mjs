import { ensureBuilt } from './builds.mjs';
import { launch } from './commands.mjs';
import { ensureInstalled } from './installation.mjs';
import { inRoot, readJson } from './repository.mjs';
import { runScript } from './steps.mjs';
import { onStop } from './stopping.mjs';

/**
 * Installs and builds what a program of this repository needs, runs it with the flags of this script until it
 * ends, and exits as it does.
 *
 * @param {string} program path of the built program, relative to the root
 * @param {readonly string[]} builds what is built before
 * @param {string} [cwd] folder in which relative paths of the flags are
 */
export async function runProgram(program, builds, cwd = process.cwd()) {
  await runScript(async () => {
    await ensureInstalled();
    await ensureBuilt(builds);
    const child = launch(
      process.execPath,
      [
        ...readJson(inRoot('apps/master/node-flags.json')),
        inRoot(program),
        ...process.argv.slice(2),
      ],
      { cwd, show: true, ownedByUs: true },
    );
    onStop((signal) => child.end(signal));
    process.exitCode = (await child.ended).code;
  });
}
