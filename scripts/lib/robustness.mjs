import { requireNode } from './node-version.mjs';

requireNode();
const { ensureBuilt } = await import('./builds.mjs');
const { runNode } = await import('./commands.mjs');
const { ensureInstalled } = await import('./installation.mjs');
const { inRoot, programFile } = await import('./repository.mjs');
const { runScript } = await import('./steps.mjs');

/**
 * Runs one of the programs in `robustness/src`, with the arguments of this process.
 *
 * @param {string} name its folder
 * @param {readonly string[]} builds what it starts; built when it is stale
 */
export async function runRobustness(name, builds) {
  await runScript(async () => {
    await ensureInstalled();
    await ensureBuilt(builds);
    const { code } = await runNode(
      programFile('robustness', 'tsx'),
      [`src/${name}/main.ts`, ...process.argv.slice(2)],
      { cwd: inRoot('robustness'), show: true },
    );
    process.exitCode = code;
  });
}
