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
  process.stderr.write(begunLine(name));
  return timed(work, (ending) => process.stderr.write(ending));
}

/**
 * Independent steps, two at a time: more does not fit a small machine. They begin in the order of the list;
 * each has its line on stderr when it ends. After the first that fails none begins.
 *
 * @param {readonly { name: string, work: () => Promise<unknown> }[]} steps
 * @throws what the first step threw that failed, once none runs any more
 */
export async function stepsTogether(steps) {
  const waiting = [...steps];
  const lane = async () => {
    for (let next = waiting.shift(); next !== undefined; next = waiting.shift()) {
      const { name, work } = next;
      try {
        await timed(work, (ending) => process.stderr.write(begunLine(name) + ending));
      } catch (error) {
        waiting.length = 0;
        throw error;
      }
    }
  };
  const lanes = await Promise.allSettled([lane(), lane()]);
  const failed = lanes.find(({ status }) => status === 'rejected');
  if (failed !== undefined) throw failed.reason;
}

/** @param {string} name */
function begunLine(name) {
  return `  ${name} ${'.'.repeat(Math.max(3, 44 - name.length))} `;
}

/**
 * @template T
 * @param {() => Promise<T>} work @param {(ending: string) => void} say told once how long it took
 * @returns {Promise<T>}
 */
async function timed(work, say) {
  const begun = performance.now();
  const seconds = () => `${((performance.now() - begun) / 1000).toFixed(1)} s\n`;
  try {
    const result = await work();
    say(seconds());
    return result;
  } catch (error) {
    say(`failed after ${seconds()}`);
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
