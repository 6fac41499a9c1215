import { spawn } from 'node:child_process';

import { root } from './repository.mjs';
import { exitCodeOf, onStop } from './stopping.mjs';

/** Time limit for a child to end after a request, before it is killed. */
const KILL_AFTER_MS = 4000;

/**
 * @typedef {object} CommandOptions
 * @property {string} [cwd] default: the repository's root
 * @property {Record<string, string>} [env] added to this process's environment
 * @property {boolean} [show] let the child write to the terminal instead of capturing its output
 * @property {boolean} [ownedByUs] tell the child by a channel that it has to end when this process does
 * @property {boolean} [stopsWithUs] default true: a signal to this process ends the command and this process
 */

/**
 * Runs a command to its end. No shell, except for npx on Windows, which is a batch file.
 *
 * @param {string} command
 * @param {readonly string[]} args
 * @param {CommandOptions} [options]
 * @returns {Promise<{ code: number, output: string }>} output is empty when it was shown
 */
export async function run(command, args, options = {}) {
  const started = launch(command, args, options);
  const stopListening = onStop((signal) => {
    started.end(signal);
    void started.ended.then(() => process.exit(exitCodeOf(signal)));
  });
  try {
    return await started.ended;
  } finally {
    // A stopped script waits for the exit above instead of continuing with its next step.
    if (!started.asked) stopListening();
    else await new Promise(() => {});
  }
}

/**
 * Runs a JavaScript program with this Node.
 *
 * @param {string} file
 * @param {readonly string[]} args
 * @param {CommandOptions} [options]
 */
export function runNode(file, args, options) {
  return run(process.execPath, [file, ...args], options);
}

/**
 * Starts a command and leaves it running.
 *
 * @param {string} command
 * @param {readonly string[]} args
 * @param {CommandOptions} [options]
 */
export function launch(command, args, options = {}) {
  const stdio = options.show ? 'inherit' : 'pipe';
  const child = spawn(command, args, {
    cwd: options.cwd ?? root,
    env: { ...process.env, ...options.env },
    stdio: [
      options.show ? 'inherit' : 'ignore',
      stdio,
      stdio,
      ...(options.ownedByUs ? /** @type {const} */ (['ipc']) : []),
    ],
    shell: process.platform === 'win32' && /^np[mx]$/.test(command),
  });
  let output = '';
  for (const stream of [child.stdout, child.stderr]) {
    stream?.setEncoding('utf8').on('data', (text) => (output += text));
  }
  const started = {
    asked: false,
    /** @type {Promise<{ code: number, output: string }>} */
    ended: new Promise((resolve) => {
      child.on('error', (error) =>
        resolve({ code: 127, output: `${command}: ${error.message}\n` }),
      );
      child.on('close', (code, signal) =>
        resolve({ code: code ?? (signal ? exitCodeOf(signal) : 1), output }),
      );
    }),
    end(/** @type {NodeJS.Signals} */ signal) {
      started.asked = true;
      child.kill(signal);
      setTimeout(() => child.kill('SIGKILL'), KILL_AFTER_MS).unref();
    },
  };
  return started;
}
