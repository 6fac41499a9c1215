/**
 * A step of a guide: a file that it creates, a change of a file, or commands.
 *
 * @typedef {{ kind: 'create', path: string, content: string }
 *   | { kind: 'change', path: string, hunks: readonly Hunk[] }
 *   | { kind: 'run', commands: readonly string[] }} GuideStep
 * @typedef {readonly { sign: ' ' | '+' | '-', text: string }[]} Hunk
 */

/** A code block, with the sentence before it that names a file. */
const BLOCK = /(?:(Create|Change) `([^`\n]+)`:\n\n)?^(`{3,})(\w*)\n([\s\S]*?)^\3$/gm;
/** At the end of a line of a change: the rest of the line is any. */
const ANY_REST = ' …';

/**
 * Reads the steps of a guide. "Create `path`:" stands before the content of a new file, "Change `path`:"
 * before a `diff` block; `sh` blocks are commands, `text` blocks are output.
 *
 * @param {string} text Markdown
 * @returns {GuideStep[]}
 * @throws {Error} when another block names no file
 */
export function readGuide(text) {
  return [...text.matchAll(BLOCK)].flatMap(([, verb, path = '', , language, content = '']) => {
    if (language === 'sh') return [{ kind: 'run', commands: content.trim().split('\n') }];
    if (language === 'text') return [];
    if (verb === 'Create') return [{ kind: 'create', path, content }];
    if (verb === 'Change') return [{ kind: 'change', path, hunks: readHunks(content) }];
    throw new Error(`A code block names no file: ${content.split('\n')[0]}`);
  });
}

/** @param {string} diff hunks between lines `@@` @returns {Hunk[]} */
function readHunks(diff) {
  return diff.split(/^@@.*\n/m).map((part) =>
    part
      .split('\n')
      .slice(0, -1)
      .map((line) => {
        const sign = line.slice(0, 1);
        if (line !== '' && !/[ +-]/.test(sign)) throw new Error(`No line of a change: ${line}`);
        return { sign: /** @type {' ' | '+' | '-'} */ (sign || ' '), text: line.slice(1) };
      }),
  );
}

/**
 * @param {string} content
 * @param {readonly Hunk[]} hunks
 * @param {string} path for messages
 * @throws {Error} when a hunk does not fit exactly one place
 */
export function applyHunks(content, hunks, path) {
  return hunks.reduce((text, hunk) => {
    const before = hunk.filter(({ sign }) => sign !== '+');
    const pattern = new RegExp(
      before.map((line) => `^(${lineSource(line.text)})\\n`).join(''),
      'gm',
    );
    const places = before.length === 0 ? 0 : [...text.matchAll(pattern)].length;
    if (places !== 1) {
      throw new Error(`${path} has ${places} places for the change at: ${before[0]?.text}`);
    }
    return text.replace(pattern, (...found) => {
      let index = 0;
      const lines = hunk.flatMap(({ sign, text: added }) => {
        if (sign === '+') return [added];
        index += 1;
        return sign === '-' ? [] : [found[index]];
      });
      return lines.map((line) => `${line}\n`).join('');
    });
  }, content);
}

/** @param {string} text a line of a change @returns {string} a regular expression */
function lineSource(text) {
  const start = text.endsWith(ANY_REST) ? text.slice(0, -ANY_REST.length) : text;
  const escaped = start.replace(/[\\^$.*+?()[\]{}|]/g, '\\$&');
  return start === text ? escaped : `${escaped}.*`;
}

/**
 * @param {Exclude<GuideStep, { kind: 'run' }>} step
 * @param {string | undefined} content of the file before the step; undefined when there is none
 * @returns {string} the content after the step
 * @throws {Error} when the file exists and should not, or the other way round, or a change does not fit
 */
export function contentAfter(step, content) {
  if (step.kind === 'create') {
    if (content !== undefined) throw new Error(`${step.path} exists already.`);
    return step.content;
  }
  if (content === undefined) throw new Error(`${step.path} does not exist.`);
  return applyHunks(content, step.hunks, step.path);
}

/** @param {readonly GuideStep[]} steps @returns {string[]} the files of a guide, once each */
export function filesOf(steps) {
  return [...new Set(steps.flatMap((step) => (step.kind === 'run' ? [] : [step.path])))];
}
