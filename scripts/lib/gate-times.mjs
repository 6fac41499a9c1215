import { stripVTControlCharacters } from 'node:util';

/**
 * What a run of the gate says about itself.
 *
 * @typedef {object} GateRun
 * @property {ReadonlyMap<string, number>} seconds by step, in the order of their ends
 * @property {readonly string[]} flaky titles of stories that passed at the second try
 * @property {string} result last line with counts, empty without one
 */

const STEP = /^ {2}(\S.*?) \.{3,} ([\d.]+) s$/;
const STORIES = /^\s*\d+ passed \(([\d.]+)(ms|s|m|h)\)$/;
const FLAKY = /^\s*\d+ flaky$/;
const FLAKY_STORY = /^\s+\[\w+\] › (.+?)(?: ─*)?$/;
const RESULT = /^\d+ passed, \d+ failed$/;
const SECONDS = { ms: 0.001, s: 1, m: 60, h: 3600 };

/** Reads what a run wrote. @param {string} output @returns {GateRun} */
export function readGateRun(output) {
  /** @type {Map<string, number>} */
  const seconds = new Map();
  const flaky = [];
  let result = '';
  let suites = 0;
  let isListing = false;
  for (const line of stripVTControlCharacters(output).split(/\r?\n/)) {
    const [, name = '', duration] = STEP.exec(line) ?? [];
    if (duration !== undefined) seconds.set(name, (seconds.get(name) ?? 0) + Number(duration));
    const [, amount, unit] = STORIES.exec(line) ?? [];
    if (amount !== undefined) {
      suites += 1;
      const factor = SECONDS[/** @type {keyof typeof SECONDS} */ (unit)];
      seconds.set(`stories, part ${suites}`, Number(amount) * factor);
    }
    const story = isListing ? FLAKY_STORY.exec(line)?.[1] : undefined;
    if (story !== undefined) flaky.push(story);
    isListing = FLAKY.test(line) || story !== undefined;
    if (RESULT.test(line)) result = line;
  }
  return { seconds, flaky, result };
}

/**
 * A table in Markdown: minutes of each step and run. Steps run two at a time, so that they add up to more than the whole.
 *
 * @param {readonly (GateRun & { total: number, code: number })[]} runs total in seconds
 */
export function tableOfRuns(runs) {
  const names = [...new Set(runs.flatMap(({ seconds }) => [...seconds.keys()]))];
  const minutes = (/** @type {number | undefined} */ value) =>
    value === undefined ? '' : (value / 60).toFixed(1);
  const row = (/** @type {readonly (string | number)[]} */ cells) => `| ${cells.join(' | ')} |`;
  return [
    row(['minutes', ...runs.map((_, index) => `run ${index + 1}`)]),
    row(['---', ...runs.map(() => '---:')]),
    ...names.map((name) => row([name, ...runs.map(({ seconds }) => minutes(seconds.get(name)))])),
    row(['**the whole**', ...runs.map(({ total }) => `**${minutes(total)}**`)]),
    row([
      'result',
      ...runs.map(({ result, code }) => (code === 0 ? result : `ended with ${code}`)),
    ]),
    row(['flaky', ...runs.map(({ flaky }) => flaky.join('; ') || 'nothing')]),
  ].join('\n');
}
