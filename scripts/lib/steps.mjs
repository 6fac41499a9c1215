/** A step that did not succeed; what there was to say has been said on the screen. */
export class StepFailed extends Error {}

/**
 * One line on stderr for a piece of work: its name when it begins, its duration when it ends.
 *
 * @template T
 * @param {string} name
 * @param {() => Promise<T>} work throws StepFailed with the output of what failed
 * @returns {Promise<T>}
 */
export async function step(name, work) {
  const begun = performance.now();
  const seconds = () => `${((performance.now() - begun) / 1000).toFixed(1)} s\n`;
  process.stderr.write(`  ${name} ${'.'.repeat(Math.max(3, 44 - name.length))} `);
  try {
    const result = await work();
    process.stderr.write(seconds());
    return result;
  } catch (error) {
    process.stderr.write(`failed after ${seconds()}`);
    throw error;
  }
}

/**
 * A step that is one command: its output is shown only when it fails.
 *
 * @param {string} name
 * @param {() => Promise<{ code: number, output: string }>} command
 */
export function commandStep(name, command) {
  return step(name, async () => expectSuccess(await command()));
}

/** @param {{ code: number, output: string }} result */
export function expectSuccess(result) {
  if (result.code !== 0) throw new StepFailed(result.output.trimEnd());
  return result;
}

/**
 * Runs a script: a failed step ends the process with its output and exit code 1.
 *
 * @param {() => Promise<void>} script
 */
export async function runScript(script) {
  try {
    await script();
  } catch (error) {
    if (!(error instanceof StepFailed)) throw error;
    if (error.message !== '') process.stderr.write(`\n${error.message}\n`);
    process.exitCode = 1;
  }
}
