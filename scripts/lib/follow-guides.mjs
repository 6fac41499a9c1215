import {
  cpSync,
  existsSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  readdirSync,
  realpathSync,
  rmSync,
  symlinkSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, dirname, join } from 'node:path';

import { run, runNode } from './commands.mjs';
import { contentAfter, filesOf, readGuide } from './guides.mjs';
import { inRoot, programFile, readJson, root } from './repository.mjs';
import { StepFailed, expectSuccess } from './steps.mjs';

/** Commands of guides that need no browser and end by themselves, in the order in which they are run. */
const CHECKED = ['npm run generate', 'npx oxfmt', 'npx eslint --max-warnings 0', 'npx vitest run'];
const NOT_COPIED = /^(\.git|\.cache.*|\.pnpm|\.vite.*|dist)$/;
/** Folders of running programs, which may change while they are copied. */
const IN_USE = ['data', 'benchmarks/results', 'robustness/results', 'e2e/test-results'].map(
  (path) => inRoot(path),
);

/** @returns {{ name: string, steps: import('./guides.mjs').GuideStep[] }[]} all guides */
export function readGuides() {
  return readdirSync(inRoot('docs/guides'))
    .filter((name) => name.endsWith('.md') && name !== 'README.md')
    .map((name) => ({ name, steps: readGuide(readFileSync(inRoot('docs/guides', name), 'utf8')) }));
}

/**
 * Follows every guide in a copy of the repository: creates and changes the files, runs the commands, and
 * checks the types of what came out.
 *
 * @throws {StepFailed} with the output of the first command that failed
 */
export async function followGuides() {
  const copy = copyRepository();
  const remove = () => rmSync(copy, { recursive: true, force: true });
  // Also when the program is interrupted
  process.once('exit', remove);
  try {
    const steps = readGuides().flatMap(({ name, steps }) => applyFiles(copy, name, steps));
    for (const [program = '', ...args] of commandsOf(steps)) {
      expectSuccess(await run(program, args, { cwd: copy }));
    }
    await checkTypes(copy, filesOf(steps));
  } finally {
    remove();
    process.off('exit', remove);
  }
}

/** @returns {string} the folder of a copy without built things, with the packages of this repository */
function copyRepository() {
  const copy = realpathSync(mkdtempSync(join(tmpdir(), 'ubii-guides-')));
  cpSync(root, copy, {
    recursive: true,
    verbatimSymlinks: true,
    filter: (source) => !NOT_COPIED.test(basename(source)) && !IN_USE.includes(source),
  });
  symlinkSync(inRoot('node_modules/.pnpm'), join(copy, 'node_modules/.pnpm'), 'junction');
  return copy;
}

/**
 * @param {string} copy @param {string} guide @param {import('./guides.mjs').GuideStep[]} steps
 * @returns {import('./guides.mjs').GuideStep[]} the steps
 */
function applyFiles(copy, guide, steps) {
  for (const step of steps) {
    if (step.kind === 'run') continue;
    const file = join(copy, step.path);
    const content = existsSync(file) ? readFileSync(file, 'utf8') : undefined;
    try {
      mkdirSync(dirname(file), { recursive: true });
      writeFileSync(file, contentAfter(step, content));
    } catch (error) {
      throw new StepFailed(`docs/guides/${guide}: ${/** @type {Error} */ (error).message}`);
    }
  }
  return steps;
}

/**
 * @param {readonly import('./guides.mjs').GuideStep[]} steps
 * @returns {string[][]} each command once, with the arguments of all guides
 */
function commandsOf(steps) {
  const commands = steps.flatMap((step) => (step.kind === 'run' ? step.commands : []));
  return CHECKED.flatMap((start) => {
    const rests = commands.filter((one) => `${one} `.startsWith(`${start} `));
    const args = rests.flatMap((one) => one.slice(start.length).trim().split(' ').filter(Boolean));
    return rests.length === 0 ? [] : [[...start.split(' '), ...args]];
  });
}

/**
 * Checks the packages of the files; of the frontend, only the files and what they import.
 *
 * @param {string} copy @param {readonly string[]} files
 */
async function checkTypes(copy, files) {
  const frontend = 'apps/frontend/';
  const folders = new Set(files.map((path) => path.split('/').slice(0, 2).join('/')));
  for (const folder of folders) {
    const manifest = join(copy, folder, 'package.json');
    if (!existsSync(manifest) || `${folder}/` === frontend) continue;
    if (readJson(manifest).scripts?.typecheck === undefined) continue;
    const dir = ['--silent', '--dir', join(copy, folder), 'run', 'typecheck'];
    expectSuccess(await runNode(programFile('', 'pnpm'), dir));
  }
  const include = files
    .filter((path) => path.startsWith(frontend) && /\.(ts|vue)$/.test(path))
    .map((path) => path.slice(frontend.length));
  if (include.length === 0) return;
  const config = join(copy, frontend, 'tsconfig.guides.json');
  const extended = { extends: './tsconfig.json', include: [...include, 'src/**/*.d.ts'] };
  writeFileSync(config, JSON.stringify(extended));
  const program = programFile('apps/frontend', 'vue-tsc');
  expectSuccess(await runNode(program, ['--noEmit', '-p', config], { cwd: join(copy, frontend) }));
}
